namespace Msisf.App.Rendering;

/// <summary>
/// Limits how many POV-Ray processes run at once, with a higher limit for small ones, which sleep a good part of their time. Thread-safe.
/// </summary>
internal sealed class ProcessSlots : IDisposable
{
    private readonly SemaphoreSlim _all;
    private readonly SemaphoreSlim _taking = new(1);
    private readonly int _ofLarge;

    /// <param name="large">Maximum number of processes if all are large, at least 1.</param>
    /// <param name="small">Maximum number of processes if all are small, a multiple of that.</param>
    public ProcessSlots(int large, int small)
    {
        _all = new SemaphoreSlim(small);
        _ofLarge = small / large;
    }

    /// <summary>Waits until a process may run.</summary>
    /// <param name="cancellation">Ends the waiting.</param>
    /// <returns>Is disposed when the process has ended.</returns>
    public async Task<IDisposable> TakeAsync(bool isSmall, CancellationToken cancellation)
    {
        int slots = isSmall ? 1 : _ofLarge;
        int taken = 0;
        await _taking.WaitAsync(cancellation).ConfigureAwait(false); // two that have half of their slots would wait for each other
        try
        {
            for (; taken < slots; taken++)
            {
                await _all.WaitAsync(cancellation).ConfigureAwait(false);
            }

            return new Taken(_all, slots);
        }
        catch (OperationCanceledException) when (taken > 0)
        {
            _all.Release(taken);
            throw;
        }
        finally
        {
            _taking.Release();
        }
    }

    public void Dispose()
    {
        _all.Dispose();
        _taking.Dispose();
    }

    private sealed class Taken(SemaphoreSlim all, int slots) : IDisposable
    {
        public void Dispose() => all.Release(slots);
    }
}
