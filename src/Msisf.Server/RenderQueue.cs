using System.Diagnostics;
using System.Globalization;
using Microsoft.AspNetCore.Http;

namespace Msisf.Server;

/// <summary>
/// Runs the work of requests in the order in which they came, as many at once as there are cores, which they share. Thread-safe.
/// </summary>
/// <param name="cores">Number of cores.</param>
/// <param name="maxWaiting">Number of requests that may wait.</param>
/// <param name="limit">Longest time of a request, waiting included.</param>
internal sealed class RenderQueue(int cores, int maxWaiting, TimeSpan limit) : IDisposable
{
    private static readonly TimeSpan BetweenLooks = TimeSpan.FromMilliseconds(10);

    private readonly SemaphoreSlim _slots = new(cores);
    private int _waiting;
    private int _running;

    /// <summary>Number of requests that wait.</summary>
    public int Waiting => Volatile.Read(ref _waiting);

    /// <summary>Number of requests whose work is done at the moment.</summary>
    public int Running => Volatile.Read(ref _running);

    /// <summary>Runs the work of a request.</summary>
    /// <param name="work">Receives the number of threads that it may use, and what stops it.</param>
    /// <param name="client">Stops the work when the client goes away.</param>
    /// <exception cref="RefusedException">Too many requests wait, or the work took too long.</exception>
    public async Task<T> RunAsync<T>(Func<int, CancellationToken, T> work, CancellationToken client)
    {
        using CancellationTokenSource end = CancellationTokenSource.CreateLinkedTokenSource(client);
        end.CancelAfter(limit);
        try
        {
            await WaitAsync(end.Token).ConfigureAwait(false);
            try
            {
                int threads = Math.Max(1, cores / Interlocked.Increment(ref _running));
                return await Task.Run(() => work(threads, end.Token), end.Token).ConfigureAwait(false);
            }
            finally
            {
                Interlocked.Decrement(ref _running);
                _slots.Release();
            }
        }
        catch (OperationCanceledException) when (!client.IsCancellationRequested)
        {
            throw new RefusedException(
                StatusCodes.Status503ServiceUnavailable,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"the image took longer than the server's --max-seconds of {limit.TotalSeconds} s. Ask for a smaller one or for fewer "
                        + $"samples."));
        }
    }

    /// <summary>Waits for the end of all work.</summary>
    /// <returns>Whether it has ended in time.</returns>
    public async Task<bool> EndsWithinAsync(TimeSpan limit)
    {
        long start = Stopwatch.GetTimestamp();
        while (Running > 0 && Stopwatch.GetElapsedTime(start) < limit)
        {
            await Task.Delay(BetweenLooks).ConfigureAwait(false);
        }

        return Running == 0;
    }

    /// <summary>Frees the queue.</summary>
    public void Dispose() => _slots.Dispose();

    private async Task WaitAsync(CancellationToken end)
    {
        try
        {
            if (Interlocked.Increment(ref _waiting) > maxWaiting + _slots.CurrentCount)
            {
                throw new RefusedException(
                    StatusCodes.Status429TooManyRequests,
                    $"{maxWaiting} requests are waiting already (--queue of the server). Ask again later.");
            }

            await _slots.WaitAsync(end).ConfigureAwait(false);
        }
        finally
        {
            Interlocked.Decrement(ref _waiting);
        }
    }
}
