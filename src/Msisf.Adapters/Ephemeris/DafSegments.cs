using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Adapters.Ephemeris;

/// <summary>Turns a binary kernel's summaries into segments.</summary>
internal static class DafSegments
{
    private const int J2000 = 1;
    private const int ChebyshevAngles = 2;

    /// <summary>The segments of an SPK or PCK, in the order of the file.</summary>
    /// <param name="file">The kernel; must outlive the segments.</param>
    /// <param name="frameFromJ2000">The frame of a number at a time, for positions in other frames than J2000.</param>
    public static IEnumerable<IEphemerisSegment> Of(DafFile file, Func<int, TdbTime, RotationMatrix> frameFromJ2000) =>
        file.Summaries.Select(summary =>
            file.IdWord == "DAF/SPK" ? Position(file, summary, frameFromJ2000) : Orientation(file, summary));

    /// <summary>The segments of a CK, in the order of the file.</summary>
    public static IEnumerable<CkSegment> OfCk(DafFile file) => file.Summaries.Select(summary => OfCk(file, summary));

    public static CkSegment OfCk(DafFile file, DafSummary summary) =>
        summary.Integers[2] switch
        {
            1 => new CkDiscrete(file, summary),
            2 => new CkRates(file, summary),
            3 => new CkLinear(file, summary),
            4 => new CkChebyshev(file, summary),
            5 => new CkInterpolated(file, summary),
            6 => new CkPieces(file, summary),
            int type => new CkUnknown(
                file, summary, $"{file.FileName}: the attitude of {summary.Integers[0]} is given by CK type {type}; 1 to 6 are known"),
        };

    private static IEphemerisSegment Position(DafFile file, DafSummary summary, Func<int, TdbTime, RotationMatrix> frameFromJ2000)
    {
        (
            int target,
            int center,
            int frame,
            int type) = (summary.Integers[0], summary.Integers[1], summary.Integers[2], summary.Integers[3]);
        IEphemerisSegment segment = type switch
        {
            1 or 21 => new SpkDifferences(file, summary, type),
            2 => new ChebyshevSegment(file, summary, target, center, seriesPerRecord: 3),
            3 => new ChebyshevSegment(file, summary, target, center, seriesPerRecord: 6),
            5 => new SpkTwoBody(file, summary),
            8 or 9 or 12 or 13 or 18 => new SpkStates(file, summary, type),
            _ => new UnreadableSegment(target, center, summary.Interval,
                $"{file.FileName}: body {target} is given by SPK type {type}; the built-in reader knows {KnownTypes}"),
        };
        return frame == J2000 ? segment : new FramedSegment(segment, tdb => frameFromJ2000(frame, tdb));
    }

    /// <summary>The SPK types that can be read, for messages.</summary>
    private const string KnownTypes = "the types 1, 2, 3, 5, 8, 9, 12, 13, 18 and 21";

    /// <summary>The segment of a binary PCK.</summary>
    public static IEphemerisSegment Orientation(DafFile file, DafSummary summary)
    {
        (int body, int frame, int type) = (summary.Integers[0], summary.Integers[1], summary.Integers[2]);
        if (frame != J2000 || type != ChebyshevAngles)
        {
            return new UnreadableSegment(body, Center: 0, summary.Interval,
                $"{file.FileName}: orientation {body} is given by PCK type {type} in frame {frame}; "
                    + $"the built-in reader knows type 2 in J2000 (1)");
        }

        return new ChebyshevSegment(file, summary, body, center: 0, seriesPerRecord: 3);
    }

    /// <summary>A segment of a type that is not known; only its use is an error.</summary>
    private sealed class CkUnknown(DafFile file, DafSummary summary, string reason) : CkSegment(file, summary)
    {
        public override IReadOnlyList<TdbInterval> Intervals => [Ticks];

        protected override CkAttitude? Evaluate(double ticks) => throw new SpiceException($"{reason}. Use a kernel of another type.");
    }
}

/// <summary>A segment of a type that the built-in reader does not know. Only its use is an error.</summary>
/// <param name="Body">NAIF's number.</param>
/// <param name="Center">NAIF's number.</param>
/// <param name="Interval">When its data hold.</param>
/// <param name="Reason">What it is, with the file's name.</param>
internal sealed record UnreadableSegment(int Body, int Center, TdbInterval Interval, string Reason) : IEphemerisSegment
{
    public Vector3D ValueAt(TdbTime tdb) => throw Unreadable();

    public Vector3D RateAt(TdbTime tdb) => throw Unreadable();

    private SpiceException Unreadable() => new($"{Reason}. Use --ephemeris cspice, or a kernel of another type.");
}

/// <summary>What a DAF file says about one of its segments.</summary>
/// <param name="Interval">When the segment's data hold; of a CK ticks of the spacecraft's clock.</param>
/// <param name="Integers">
/// SPK: target, centre, frame, type, first and last address. PCK: body, frame, type, first and last address. CK: instrument, frame, type,
/// whether there are rates, first and last address.
/// </param>
public sealed record DafSummary(TdbInterval Interval, IReadOnlyList<int> Integers)
{
    /// <summary>Address of the segment's first double, from 1.</summary>
    public int FirstAddress => Integers[^2];

    /// <summary>Address of the segment's last double, from 1.</summary>
    public int LastAddress => Integers[^1];
}

/// <summary>A segment whose states are given in another frame than J2000.</summary>
/// <param name="frameFromJ2000">The frame at a time.</param>
internal sealed class FramedSegment(IEphemerisSegment segment, Func<TdbTime, RotationMatrix> frameFromJ2000) : IEphemerisSegment
{
    /// <summary>
    /// s: the velocity by a frame that turns as fast as the Earth, 7e-5 rad/s, is then right to 1e-13 km/s; the frame's rounding adds
    /// 1e-11.
    /// </summary>
    private const double Step = 20.0;

    public int Body => segment.Body;

    public int Center => segment.Center;

    public TdbInterval Interval => segment.Interval;

    public Vector3D ValueAt(TdbTime tdb) => frameFromJ2000(tdb).Transposed * segment.ValueAt(tdb);

    public Vector3D RateAt(TdbTime tdb) => StateAt(tdb).Velocity;

    public StateVector StateAt(TdbTime tdb)
    {
        StateVector inFrame = segment.StateAt(tdb);
        StateVector turned = frameFromJ2000(tdb).Transposed * inFrame;
        return turned with { Velocity = turned.Velocity + ((8.0 * Difference(Step) - Difference(2.0 * Step)) / (12.0 * Step)) };

        Vector3D Difference(double step) => (frameFromJ2000(tdb + step).Transposed * inFrame.Position)
            - (frameFromJ2000(tdb + -step).Transposed * inFrame.Position);
    }
}

/// <summary>The numbers of one segment, each checked when it is read. Safe for several threads.</summary>
/// <param name="file">The kernel; must outlive the object.</param>
internal sealed class DafWords(DafFile file, DafSummary summary)
{
    /// <summary>How many numbers the segment has.</summary>
    public long Count { get; } = (long)summary.LastAddress - summary.FirstAddress + 1;

    /// <summary>Reads some numbers.</summary>
    /// <param name="first">The first one, from 0.</param>
    /// <exception cref="BadInputException">They are not all in the segment, or one is not finite.</exception>
    public double[] Read(long first, int count)
    {
        if (first < 0 || count < 0 || first + count > Count)
        {
            throw Damaged("its data lead out of the segment");
        }

        double[] words = new double[count];
        file.ReadDoubles(summary.FirstAddress + first, words);
        return Array.TrueForAll(words, double.IsFinite) ? words : throw Damaged("a number is not finite");
    }

    /// <summary>Reads one of the last numbers, which must be whole.</summary>
    /// <param name="fromEnd">1 for the last one.</param>
    /// <param name="min">The least value that is possible.</param>
    /// <param name="max">The largest one.</param>
    /// <exception cref="BadInputException">It is none of these.</exception>
    public int Whole(int fromEnd, int min, long max)
    {
        double value = Read(Count - fromEnd, 1)[0];
        return value == Math.Truncate(value) && value >= min && value <= Math.Min(max, int.MaxValue)
            ? (int)value
            : throw Damaged(Invariant($"number {fromEnd} from its end is {value:R}, which does not fit its size"));
    }

    /// <summary>Reads times that must rise.</summary>
    /// <param name="first">The first one, from 0.</param>
    /// <exception cref="BadInputException">They do not rise.</exception>
    public double[] ReadRising(long first, int count)
    {
        double[] times = Read(first, count);
        for (int i = 1; i < count; i++)
        {
            if (!(times[i] > times[i - 1]))
            {
                throw Damaged(Invariant($"its times do not rise: {times[i]:R} follows {times[i - 1]:R}"));
            }
        }

        return times;
    }

    /// <summary>The error for a segment that contradicts itself.</summary>
    /// <param name="what">What was found.</param>
    public BadInputException Damaged(string what) => file.Damaged(Invariant($"in the segment of {summary.Integers[0]}, {what}"));
}
