using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>CK type 2: intervals, in each of which an orientation turns at a constant rate.</summary>
/// <remarks>NAIF, CK Required Reading, "Data Type 2".</remarks>
internal sealed class CkRates : CkSegment
{
    private const int RecordWords = 8;

    private readonly Lazy<(double[] Starts, double[] Ends)> _times;

    /// <summary>Takes the number of intervals from the segment's size, which alone tells it.</summary>
    /// <exception cref="Core.Errors.BadInputException">It is too small.</exception>
    public CkRates(DafFile file, DafSummary summary)
        : base(file, summary)
    {
        // Each interval has a record, a start and an end; each hundred starts that are followed by another have an entry in a directory.
        int count = (int)Math.Min((((Words.Count * 100) - 1) / 1001) + 1, int.MaxValue / 16);
        if (((long)count * (RecordWords + 2)) + ((count - 1) / 100) != Words.Count)
        {
            throw Words.Damaged("no number of intervals fits its size");
        }

        _times = new Lazy<(double[], double[])>(() => (
            Words.ReadRising((long)count * RecordWords, count), Words.ReadRising((long)count * (RecordWords + 1), count)));
    }

    public override IReadOnlyList<TdbInterval> Intervals =>
        [.. _times.Value.Starts.Zip(_times.Value.Ends, (start, end) => new TdbInterval(start, Math.Max(start, end)))];

    protected override CkAttitude? Evaluate(double ticks)
    {
        int index = LastAtOrBefore(_times.Value.Starts, ticks);
        if (index < 0 || ticks > _times.Value.Ends[index])
        {
            return null;
        }

        double[] record = Words.Read((long)index * RecordWords, RecordWords);
        RotationMatrix start = Matrix(record);
        Vector3D rate = new(record[4], record[5], record[6]);
        double angle = (ticks - _times.Value.Starts[index]) * record[7] * rate.Length;
        return new CkAttitude(rate.Length == 0.0 ? start : start * Turn(rate, angle).Transposed, rate);
    }

    /// <summary>The rotation of vectors by an angle about an axis.</summary>
    internal static RotationMatrix Turn(Vector3D axis, double angle)
    {
        UnitQuaternion turn = UnitQuaternion.FromAxisAngle(axis, angle);
        return new RotationMatrix(turn * Vector3D.UnitX, turn * Vector3D.UnitY, turn * Vector3D.UnitZ).Transposed;
    }
}

/// <summary>CK type 1: single orientations, between which nothing is known.</summary>
/// <remarks>NAIF, CK Required Reading, "Data Type 1".</remarks>
internal sealed class CkDiscrete : CkSegment
{
    private readonly int _record;
    private readonly Lazy<double[]> _ticks;

    /// <summary>Reads the segment's sizes.</summary>
    /// <exception cref="Core.Errors.BadInputException">They contradict each other.</exception>
    public CkDiscrete(DafFile file, DafSummary summary)
        : base(file, summary)
    {
        _record = HasRates ? 7 : 4;
        int count = Words.Whole(fromEnd: 1, min: 1, Words.Count / (_record + 1));
        _ticks = new Lazy<double[]>(() => Words.ReadRising((long)count * _record, count));
    }

    public override IReadOnlyList<TdbInterval> Intervals => [.. _ticks.Value.Select(tick => new TdbInterval(tick, tick))];

    protected override CkAttitude? Evaluate(double ticks)
    {
        if (Array.BinarySearch(_ticks.Value, ticks) is not (>= 0 and int index))
        {
            return null;
        }

        double[] record = Words.Read((long)index * _record, _record);
        return new CkAttitude(Matrix(record), HasRates ? new Vector3D(record[4], record[5], record[6]) : null);
    }
}

/// <summary>CK type 3: orientations, between which the instrument turns at a constant rate; intervals tell where there are gaps.</summary>
/// <remarks>NAIF, CK Required Reading, "Data Type 3".</remarks>
internal sealed class CkLinear : CkSegment
{
    private readonly int _record;
    private readonly Lazy<TickIntervals> _times;

    /// <summary>Reads the segment's sizes.</summary>
    /// <exception cref="Core.Errors.BadInputException">They contradict each other.</exception>
    public CkLinear(DafFile file, DafSummary summary)
        : base(file, summary)
    {
        _record = HasRates ? 7 : 4;
        int count = Words.Whole(fromEnd: 1, min: 1, Words.Count / (_record + 1));
        int intervals = Words.Whole(fromEnd: 2, min: 1, count);
        _times = new Lazy<TickIntervals>(() => TickIntervals.Read(Words, _record, count, intervals));
    }

    public override IReadOnlyList<TdbInterval> Intervals => _times.Value.All;

    protected override CkAttitude? Evaluate(double ticks)
    {
        double[] times = _times.Value.Ticks;
        int index = LastAtOrBefore(times, ticks);
        if (index < 0)
        {
            return null;
        }

        if (times[index] == ticks)
        {
            double[] record = Words.Read((long)index * _record, _record);
            return new CkAttitude(Matrix(record), RateOf(record, 0));
        }

        if (index + 1 == times.Length || _times.Value.IsStart(index + 1))
        {
            return null;
        }

        double[] records = Words.Read((long)index * _record, 2 * _record);
        (RotationMatrix before, RotationMatrix after) = (Matrix(records), Matrix(records.AsSpan(_record)));
        UnitQuaternion turn = UnitQuaternion.FromMatrix(after.Transposed * before);
        Vector3D axis = new(turn.X, turn.Y, turn.Z);
        double angle = 2.0 * Trigonometry.Atan2(axis.Length, turn.W);
        double fraction = (ticks - times[index]) / (times[index + 1] - times[index]);
        return new CkAttitude(
            axis.Length == 0.0 ? before : before * CkRates.Turn(axis, fraction * angle).Transposed,
            HasRates ? ((1.0 - fraction) * RateOf(records, 0)) + (fraction * RateOf(records, _record)) : null);
    }

    private Vector3D? RateOf(double[] records, int first) =>
        HasRates ? new Vector3D(records[first + 4], records[first + 5], records[first + 6]) : null;
}
