using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>A segment of a CK: how an instrument or a spacecraft is turned. Safe for several threads.</summary>
/// <param name="file">The kernel; must outlive the segment.</param>
internal abstract class CkSegment(DafFile file, DafSummary summary)
{
    /// <summary>NAIF's number of the instrument, which is the class ID of its frame.</summary>
    public int Instrument => summary.Integers[0];

    /// <summary>NAIF's number of the frame relative to which it is turned.</summary>
    public int Reference => summary.Integers[1];

    /// <summary>Ticks of the spacecraft's clock between which the segment holds; within it there may be gaps.</summary>
    public TdbInterval Ticks => summary.Interval;

    /// <summary>The intervals of ticks without gaps, rising; not cut to <see cref="Ticks"/>.</summary>
    /// <exception cref="Core.Errors.BadInputException">The kernel is damaged.</exception>
    public abstract IReadOnlyList<TdbInterval> Intervals { get; }

    /// <summary>The segment's numbers.</summary>
    protected DafWords Words { get; } = new(file, summary);

    /// <summary>Whether the segment says how fast the instrument turns.</summary>
    protected bool HasRates { get; } = summary.Integers[3] == 1;

    /// <summary>How the instrument is turned.</summary>
    /// <param name="ticks">Time in ticks of the spacecraft's clock.</param>
    /// <returns>Null in a gap.</returns>
    /// <exception cref="Core.Errors.BadInputException">The kernel is damaged, or of a type that is not known.</exception>
    public CkAttitude? At(double ticks) => Ticks.Contains(ticks) ? Evaluate(ticks) : null;

    /// <summary>How the instrument is turned at the nearest single instant that the segment has.</summary>
    /// <param name="tolerance">How many ticks it may be away.</param>
    /// <returns>Null if there is none.</returns>
    /// <exception cref="Core.Errors.BadInputException">The kernel is damaged, or of a type that is not known.</exception>
    public CkAttitude? AtInstant(double ticks, double tolerance)
    {
        double? nearest = null;
        foreach (TdbInterval interval in Intervals)
        {
            if (interval.IsInstant && Ticks.Contains(interval.Start)
                && Math.Abs(interval.Start - ticks) <= Math.Min(tolerance, Math.Abs((nearest ?? double.PositiveInfinity) - ticks)))
            {
                nearest = interval.Start;
            }
        }

        return nearest is { } tick ? Evaluate(tick) : null;
    }

    /// <inheritdoc cref="At"/>
    protected abstract CkAttitude? Evaluate(double ticks);

    /// <summary>The C-matrix of a quaternion of SPICE's, scalar first, of any length but 0.</summary>
    /// <exception cref="Core.Errors.BadInputException">Its length is 0.</exception>
    protected RotationMatrix Matrix(ReadOnlySpan<double> q) =>
        SpiceQuaternion.ToMatrix(q) ?? throw Words.Damaged("a quaternion has no length");

    /// <summary>The attitude of a quaternion and a rate, which counts if the segment says that there are rates.</summary>
    protected CkAttitude Attitude((double[] Quaternion, Vector3D Rate) values) =>
        new(Matrix(values.Quaternion), HasRates ? values.Rate : null);

    /// <summary>The last of some rising times that is not after a time; -1 if all are.</summary>
    protected static int LastAtOrBefore(double[] times, double time)
    {
        int found = Array.BinarySearch(times, time);
        return found < 0 ? ~found - 1 : found;
    }
}

/// <summary>How an instrument is turned, and how fast.</summary>
/// <param name="InstrumentFromReference">Turns components in the reference frame into those in the instrument's: SPICE's C-matrix.</param>
/// <param name="Rate">
/// rad/s of the instrument in the reference frame, about the axes of the latter; null if the kernel does not say it.
/// </param>
internal readonly record struct CkAttitude(RotationMatrix InstrumentFromReference, Vector3D? Rate);

/// <summary>The ticks of a CK's records, and the intervals that they form (types 3 and 5).</summary>
/// <param name="Ticks">Times of the records in ticks, rising.</param>
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
