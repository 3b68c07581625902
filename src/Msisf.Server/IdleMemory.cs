using System.Runtime;

namespace Msisf.Server;

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

    /// <summary>Notes that large work has ended.</summary>
    public void LargeWorkEnded()
    {
        Volatile.Write(ref _collections, 0);
        _timer.Change(AfterWork, ForPools);
    }

    /// <summary>Ends the watch.</summary>
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
