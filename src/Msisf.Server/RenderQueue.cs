using System.Diagnostics;
using System.Runtime;

namespace Msisf.Server;

/// <summary>
/// Runs the work of requests, which share the cores, in the order in which they came; but small work does not wait for large work. Each of
/// both has places of its own. Thread-safe.
/// </summary>
/// <param name="maxWaiting">Number of requests that may wait, small or large.</param>
/// <param name="limit">Longest time of a request, waiting included.</param>
internal sealed class RenderQueue(int cores, int maxWaiting, TimeSpan limit) : IDisposable
{
    /// <summary>Each of them takes one or two GB.</summary>
    private const int MaxLarge = 4;

    private static readonly TimeSpan BetweenLooks = TimeSpan.FromMilliseconds(10);

    private readonly Places _small = new(cores, maxWaiting);
    private readonly Places _large = new(Math.Min(cores, MaxLarge), maxWaiting);
    private readonly IdleMemory _memory = new();
    private int _running;

    /// <summary>Number of requests that wait.</summary>
    public int Waiting => _small.Waiting + _large.Waiting;

    /// <summary>Number of requests whose work is done at the moment.</summary>
    public int Running => Volatile.Read(ref _running);

    /// <param name="isLarge">Whether the work takes much longer, or much more memory, than an image of 1024 x 1024 px.</param>
    /// <param name="work">Receives the number of threads that it may use, and what stops it.</param>
    /// <exception cref="RefusedException">Too many requests wait, or the work took too long.</exception>
    public async Task<T> RunAsync<T>(bool isLarge, Func<int, CancellationToken, T> work, CancellationToken client)
    {
        Places places = isLarge ? _large : _small;
        using CancellationTokenSource end = CancellationTokenSource.CreateLinkedTokenSource(client);
        end.CancelAfter(limit);
        try
        {
            await places.TakeAsync(end.Token).ConfigureAwait(false);
            try
            {
                int threads = Math.Max(1, cores / Interlocked.Increment(ref _running));
                return await Task.Run(() => work(threads, end.Token), end.Token).ConfigureAwait(false);
            }
            finally
            {
                Interlocked.Decrement(ref _running);
                places.GiveBack();
                if (isLarge)
                {
                    _memory.LargeWorkEnded();
                }
            }
        }
        catch (OperationCanceledException) when (!client.IsCancellationRequested)
        {
            throw new RefusedException(
                StatusCodes.Status503ServiceUnavailable,
                Invariant(
                    $"the image took longer than the server's --max-seconds of {limit.TotalSeconds} s. Ask for a smaller one or for fewer "
                        + $"samples."));
        }
    }

    /// <summary>Waits for the end of all work.</summary>
    /// <returns>Whether it has ended in time.</returns>
    public async Task<bool> EndsWithinAsync(TimeSpan time)
    {
        long start = Stopwatch.GetTimestamp();
        while (Running > 0 && Stopwatch.GetElapsedTime(start) < time)
        {
            await Task.Delay(BetweenLooks).ConfigureAwait(false);
        }

        return Running == 0;
    }

    public void Dispose()
    {
        _small.Dispose();
        _large.Dispose();
        _memory.Dispose();
    }

    private sealed class Places(int count, int maxWaiting) : IDisposable
    {
        private readonly SemaphoreSlim _free = new(count);
        private int _waiting;

        public int Waiting => Volatile.Read(ref _waiting);

        public async Task TakeAsync(CancellationToken end)
        {
            try
            {
                if (Interlocked.Increment(ref _waiting) > maxWaiting + _free.CurrentCount)
                {
                    throw new RefusedException(
                        StatusCodes.Status429TooManyRequests,
                        $"{maxWaiting} requests are waiting already (--queue of the server). Ask again later.");
                }

                await _free.WaitAsync(end).ConfigureAwait(false);
            }
            finally
            {
                Interlocked.Decrement(ref _waiting);
            }
        }

        public void GiveBack() => _free.Release();

        public void Dispose() => _free.Dispose();
    }
}

/// <summary>
/// Returns memory to the system when large work has been over for a while; .NET would keep it until there is reason to collect.
/// Thread-safe.
/// </summary>
internal sealed class IdleMemory : IDisposable
{
    /// <summary>Long enough that a client who asks for one large image after the other is not slowed down.</summary>
    private static readonly TimeSpan AfterWork = TimeSpan.FromSeconds(10);

    /// <summary>.NET's pools of arrays let go of what they have kept unused for a minute since they saw a collection.</summary>
    private static readonly TimeSpan ForPools = TimeSpan.FromSeconds(35);

    /// <summary>Together they last longer than that minute.</summary>
    private const int Collections = 3;

    private readonly Timer _timer;
    private int _collections;

    public IdleMemory() => _timer = new Timer(_ => Collect());

    public void LargeWorkEnded()
    {
        Volatile.Write(ref _collections, 0);
        _timer.Change(AfterWork, ForPools);
    }

    public void Dispose() => _timer.Dispose();

    private void Collect()
    {
        GCSettings.LargeObjectHeapCompactionMode = GCLargeObjectHeapCompactionMode.CompactOnce;
        GC.Collect(GC.MaxGeneration, GCCollectionMode.Aggressive, blocking: true, compacting: true);
        if (Interlocked.Increment(ref _collections) == Collections)
        {
            _timer.Change(Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
        }
    }
}
