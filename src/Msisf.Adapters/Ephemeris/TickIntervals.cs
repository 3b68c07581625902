using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>The ticks of a CK's records, and the intervals that they form (types 3 and 5).</summary>
/// <param name="Ticks">Of the records, rising.</param>
/// <param name="Starts">First tick of each interval, rising; each is a record's.</param>
internal sealed record TickIntervals(double[] Ticks, double[] Starts)
{
    private const int DirectoryStep = 100;

    /// <summary>The intervals from their starts to their last records.</summary>
    public IReadOnlyList<TdbInterval> All =>
    [
        .. Starts.Select((start, i) => new TdbInterval(
            start, Ticks[i + 1 < Starts.Length ? IndexOf(Starts[i + 1]) - 1 : Ticks.Length - 1])),
    ];

    /// <summary>Reads them: records, their ticks with a directory, starts with a directory.</summary>
    /// <param name="words">The segment.</param>
    /// <exception cref="Core.Errors.BadInputException">Ticks do not rise, or an interval does not start at a record.</exception>
    public static TickIntervals Read(DafWords words, int record, int count, int intervals)
    {
        double[] ticks = words.ReadRising((long)count * record, count);
        long first = ((long)count * (record + 1)) + ((count - 1) / DirectoryStep);
        double[] starts = words.ReadRising(first, intervals);
        return starts[0] == ticks[0] && Array.TrueForAll(starts, start => Array.BinarySearch(ticks, start) >= 0)
            ? new TickIntervals(ticks, starts)
            : throw words.Damaged("an interval does not start at a record");
    }

    /// <summary>Whether an interval starts at a record.</summary>
    /// <param name="index">The record, from 0.</param>
    public bool IsStart(int index) => Array.BinarySearch(Starts, Ticks[index]) >= 0;

    /// <summary>The records of the interval that holds a tick: the first one, and the one behind its last.</summary>
    public (int First, int End) Of(double tick)
    {
        int found = Array.BinarySearch(Starts, tick);
        int interval = Math.Max(0, found < 0 ? ~found - 1 : found);
        return (IndexOf(Starts[interval]), interval + 1 < Starts.Length ? IndexOf(Starts[interval + 1]) : Ticks.Length);
    }

    private int IndexOf(double tick) => Array.BinarySearch(Ticks, tick);
}
