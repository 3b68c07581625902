using System.Diagnostics;
using System.Runtime;

namespace Msisf.Server;

/// <summary>What the work of a request needs.</summary>
/// <param name="Client">Who asks: clients share the places evenly.</param>
/// <param name="Samples">Samples that are drawn; 0 for what is not an image.</param>
/// <param name="IsLarge">Whether the work takes much longer, or much more memory, than an image of 1024 x 1024 px.</param>
internal readonly record struct Demand(string Client, long Samples, bool IsLarge);

/// <summary>
/// Runs the work of requests, which share the cores. Small work does not wait for large work: each of both has places of its own. A client
/// that has no work running does not wait for those of others, as long as there are spare places. Among those who wait, the client with the
/// least work running comes first, then by turns the least work and the one that has waited longest. Thread-safe.
/// </summary>
/// <param name="maxWaiting">Number of requests of a client that may wait, small or large.</param>
/// <param name="limit">Longest time of a request, waiting included.</param>
internal sealed class RenderQueue(int cores, int maxWaiting, TimeSpan limit) : IDisposable
{
    /// <summary>Each of them takes one or two GB.</summary>
    private const int MaxLarge = 4;

    /// <summary>Work at once, of several clients, to that of one.</summary>
    private const int Spare = 2;

    private static readonly TimeSpan BetweenLooks = TimeSpan.FromMilliseconds(10);

    private readonly Places _small = new(cores, Spare * cores, maxWaiting);
    private readonly Places _large = new(Math.Min(cores, MaxLarge / Spare), MaxLarge, maxWaiting);
    private readonly IdleMemory _memory = new();
    private int _running;

    /// <summary>Number of requests that wait.</summary>
    public int Waiting => _small.Waiting + _large.Waiting;

    /// <summary>Number of requests whose work is done at the moment.</summary>
    public int Running => Volatile.Read(ref _running);

    /// <param name="work">Receives the number of threads that it may use, and what stops it.</param>
    /// <exception cref="RefusedException">Too many requests of the client wait, or the work took too long.</exception>
    public async Task<T> RunAsync<T>(Demand demand, Func<int, CancellationToken, T> work, CancellationToken client)
    {
        Places places = demand.IsLarge ? _large : _small;
        using CancellationTokenSource end = CancellationTokenSource.CreateLinkedTokenSource(client);
        end.CancelAfter(limit);
        try
        {
            await places.TakeAsync(demand, end.Token).ConfigureAwait(false);
            try
            {
                int threads = Math.Max(1, cores / Interlocked.Increment(ref _running));
                return await Task.Run(() => work(threads, end.Token), end.Token).ConfigureAwait(false);
            }
            finally
            {
                Interlocked.Decrement(ref _running);
                places.GiveBack(demand.Client);
                if (demand.IsLarge)
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
        _memory.Dispose();
    }

    /// <param name="count">Places of one client, and of all as long as others have some.</param>
    /// <param name="most">Places of all: those beyond the count are for clients that have none, and for the smallest images.</param>
    private sealed class Places(int count, int most, int maxWaiting)
    {
        /// <summary>Samples of an image of 256 x 256 px, which is drawn in some ms.</summary>
        private const long Smallest = 256 * 256;

        private readonly Lock _gate = new();
        private readonly LinkedList<Waiter> _waiting = []; // in the order in which they came
        private readonly Dictionary<string, int> _running = new(StringComparer.Ordinal);
        private int _taken;
        private bool _isLongestNext;

        public int Waiting
        {
            get
            {
                lock (_gate)
                {
                    return _waiting.Count;
                }
            }
        }

        public async Task TakeAsync(Demand demand, CancellationToken end)
        {
            Waiter waiter = new(demand);
            lock (_gate)
            {
                if (HasPlaceFor(demand)) // nobody waits who could have it
                {
                    Take(demand.Client);
                    return;
                }

                if (_waiting.Count(other => other.Demand.Client == demand.Client) >= maxWaiting)
                {
                    throw new RefusedException(
                        StatusCodes.Status429TooManyRequests,
                        $"{maxWaiting} requests are waiting already (--queue of the server). Ask again later.");
                }

                _waiting.AddLast(waiter);
            }

            using CancellationTokenRegistration left = end.Register(() => Leave(waiter, end));
            await waiter.Turn.Task.ConfigureAwait(false);
        }

        public void GiveBack(string client)
        {
            lock (_gate)
            {
                _taken--;
                int others = _running[client] - 1;
                if (others == 0)
                {
                    _running.Remove(client);
                }
                else
                {
                    _running[client] = others;
                }

                while (Next() is { } next)
                {
                    _waiting.Remove(next);
                    Take(next.Demand.Client);
                    next.Turn.SetResult();
                }
            }
        }

        private Waiter? Next()
        {
            Waiter[] fit = [.. _waiting.Where(waiter => HasPlaceFor(waiter.Demand))];
            if (fit.Length == 0)
            {
                return null;
            }

            _isLongestNext = !_isLongestNext;
            int least = fit.Min(waiter => _running.GetValueOrDefault(waiter.Demand.Client));
            IEnumerable<Waiter> first = fit.Where(waiter => _running.GetValueOrDefault(waiter.Demand.Client) == least);
            return _isLongestNext ? first.First() : first.MinBy(waiter => waiter.Demand.Samples);
        }

        private bool HasPlaceFor(Demand demand) =>
            _taken < count || (_taken < most && (demand.Samples <= Smallest || !_running.ContainsKey(demand.Client)));

        private void Take(string client)
        {
            _taken++;
            _running[client] = _running.GetValueOrDefault(client) + 1;
        }

        private void Leave(Waiter waiter, CancellationToken end)
        {
            lock (_gate)
            {
                if (!_waiting.Remove(waiter))
                {
                    return; // it is its turn already
                }
            }

            waiter.Turn.SetCanceled(end);
        }

        private sealed record Waiter(Demand Demand)
        {
            public TaskCompletionSource Turn { get; } = new(TaskCreationOptions.RunContinuationsAsynchronously);
        }
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
