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
        PatternContent? content = isNew ? order.Read() : null;
        if (content?.IsIn(order.Path) == true)
        {
            return false;
        }

        using Claim? claim = _claims().TryTake(Path.GetFileName(order.Path));
        if (claim is null && mayWait)
        {
            return null;
        }

        content ??= order.Read();
        if (content.IsIn(order.Path))
        {
            return false; // made by another one meanwhile
        }

        content.WriteTo(order.Path, isClaimed: claim is { IsExclusive: true });
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

/// <summary>A pattern that a scene needs.</summary>
/// <param name="Path">Its file.</param>
/// <param name="Read">Reads the model, which says what the file must hold; a damaged model is a <see cref="BadInputException"/>.</param>
internal sealed record PatternOrder(string Path, Func<PatternContent> Read);

/// <summary>What the file of a pattern must hold.</summary>
/// <param name="Header">Its header, without the length (<see cref="PatternHeader"/>).</param>
/// <param name="MakeWriter">Makes what writes the whole file.</param>
internal sealed record PatternContent(byte[] Header, Func<Action<Stream>> MakeWriter)
{
    /// <summary>Whether the file is there and complete; one read, whatever its size.</summary>
    /// <exception cref="BadInputException">The file is not of this program.</exception>
    /// <exception cref="ExternalPartException">The file is there but can't be read.</exception>
    public bool IsIn(string path) => PatternFile.Inspect(path, Header) switch
    {
        PatternFile.State.Good => true,
        PatternFile.State.Foreign => throw new BadInputException(
            $"{path}: has a pattern's name, but this program has not made it, so it stays as it is. "
                + $"Move it away, or choose another pattern repository."),
        _ => false,
    };

    /// <summary>Makes the file.</summary>
    /// <param name="isClaimed">Whether no other process or thread can be making it.</param>
    /// <exception cref="ExternalPartException">The repository can't be written.</exception>
    public void WriteTo(string path, bool isClaimed)
    {
        Action<Stream> write = MakeWriter();
        Action<string, Action<Stream>, bool> writeFile = isClaimed ? AtomicFile.WriteClaimed : AtomicFile.Write;
        writeFile(path, write, false); // a power cut's short file is found by its header
    }
}
