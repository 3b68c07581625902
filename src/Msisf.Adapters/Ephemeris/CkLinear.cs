using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

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
        _record = summary.Integers[3] == 1 ? 7 : 4;
        int count = Words.Whole(fromEnd: 1, min: 1, Words.Count / (_record + 1));
        int intervals = Words.Whole(fromEnd: 2, min: 1, count);
        _times = new Lazy<TickIntervals>(() => TickIntervals.Read(Words, _record, count, intervals));
    }

    public override IReadOnlyList<TdbInterval> Intervals => _times.Value.All;

    protected override RotationMatrix? Evaluate(double ticks)
    {
        double[] times = _times.Value.Ticks;
        int index = LastAtOrBefore(times, ticks);
        if (index < 0)
        {
            return null;
        }

        if (times[index] == ticks)
        {
            return Matrix(Words.Read((long)index * _record, 4));
        }

        if (index + 1 == times.Length || _times.Value.IsStart(index + 1))
        {
            return null;
        }

        double[] records = Words.Read((long)index * _record, _record + 4);
        (RotationMatrix before, RotationMatrix after) = (Matrix(records), Matrix(records.AsSpan(_record)));
        UnitQuaternion turn = UnitQuaternion.FromMatrix(after.Transposed * before);
        Vector3D axis = new(turn.X, turn.Y, turn.Z);
        double angle = 2.0 * Math.Atan2(axis.Length, turn.W);
        double fraction = (ticks - times[index]) / (times[index + 1] - times[index]);
        return axis.Length == 0.0 ? before : before * CkRates.Turn(axis, fraction * angle).Transposed;
    }
}
