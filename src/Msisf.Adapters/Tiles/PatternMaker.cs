using System.Collections.Concurrent;
using System.Diagnostics;
using System.Runtime.ExceptionServices;
using Msisf.Adapters.IO;

namespace Msisf.Adapters.Tiles;

/// <summary>
/// Makes the patterns that are missing. A thread claims a pattern before it makes it; the others, in this process or another, go on with
/// the rest and look for that pattern at the end. The system releases the claims of a process that dies. No claim is waited for longer than
/// a limit, since two that make the same pattern make the same bytes.
/// </summary>
internal sealed class PatternMaker
{
    /// <summary>
    /// The longest wait for a claim. Even at 1024 px/deg a part takes far less; over a network file system the claims of a lost node can
    /// stay for longer.
    /// </summary>
    public static readonly TimeSpan LongestWait = TimeSpan.FromSeconds(60);

    private static readonly TimeSpan PollInterval = TimeSpan.FromMilliseconds(20); // a part takes about as long

    private readonly Func<ClaimFile> _claims;
    private readonly ParallelOptions _parallel;
    private readonly TimeSpan _longestWait;

    /// <param name="claims">Opens the claims on patterns, when the first one has to be made; from any thread.</param>
    /// <param name="maxParallelism">How many patterns to work on at once, at least 1.</param>
    /// <param name="longestWait">So long others may make what is waited for without getting anything done.</param>
    /// <param name="cancellation">Stops between two patterns.</param>
    public PatternMaker(Func<ClaimFile> claims, int maxParallelism, TimeSpan longestWait, CancellationToken cancellation)
    {
        _claims = claims;
        _parallel = new ParallelOptions { MaxDegreeOfParallelism = maxParallelism, CancellationToken = cancellation };
        _longestWait = longestWait;
    }

    /// <summary>Makes the patterns that are missing.</summary>
    /// <param name="progress">Is told, from any thread, how many are ready.</param>
    /// <returns>How many were made here.</returns>
    public int Ensure(IReadOnlyCollection<PatternOrder> orders, IProgress<int>? progress)
    {
        int ready = 0;
        int written = 0;
        ConcurrentBag<PatternOrder> taken = [];
        void Work(PatternOrder order, bool isNew, bool mayWait)
        {
            if (TryEnsure(order, isNew, mayWait) is not bool isMade)
            {
                taken.Add(order);
                return;
            }

            Interlocked.Add(ref written, isMade ? 1 : 0);
            progress?.Report(Interlocked.Increment(ref ready));
        }

        ForEach(orders, order => Work(order, isNew: true, mayWait: true));
        long lastProgress = Stopwatch.GetTimestamp();
        while (!taken.IsEmpty)
        {
            _parallel.CancellationToken.WaitHandle.WaitOne(PollInterval);
            bool mayWait = Stopwatch.GetElapsedTime(lastProgress) < _longestWait;
            PatternOrder[] open = [.. taken];
            taken.Clear();
            ForEach(open, order => Work(order, isNew: false, mayWait));
            lastProgress = taken.Count < open.Length ? Stopwatch.GetTimestamp() : lastProgress;
        }

        return written;
    }

    /// <returns>Whether it was made now; null if another one is making it.</returns>
    private bool? TryEnsure(PatternOrder order, bool isNew, bool mayWait)
    {
        // What has been seen missing is not read again until its claim is free.
        PatternOrder.Content? content = isNew ? order.Read() : null;
        if (content?.IsThere() == true)
        {
            return false;
        }

        using Claim? claim = _claims().TryTake(Path.GetFileName(order.Path));
        if (claim is null && mayWait)
        {
            return null;
        }

        content ??= order.Read();
        if (content.IsThere())
        {
            return false; // made by another one meanwhile
        }

        content.Write(isClaimed: claim is { IsExclusive: true });
        return true;
    }

    private void ForEach(IEnumerable<PatternOrder> orders, Action<PatternOrder> work)
    {
        try
        {
            Parallel.ForEach(orders, _parallel, work);
        }
        catch (AggregateException exception)
        {
            // Which tiles fail first depends on the threads; for a repeatable message, take the first by text.
            ExceptionDispatchInfo.Throw(exception.InnerExceptions.OrderBy(inner => inner.Message, StringComparer.Ordinal).First());
        }
    }
}
