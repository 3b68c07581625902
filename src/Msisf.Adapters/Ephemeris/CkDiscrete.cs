using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

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
        _record = summary.Integers[3] == 1 ? 7 : 4;
        int count = Words.Whole(fromEnd: 1, min: 1, Words.Count / (_record + 1));
        _ticks = new Lazy<double[]>(() => Words.ReadRising((long)count * _record, count));
    }

    public override IReadOnlyList<TdbInterval> Intervals => [.. _ticks.Value.Select(tick => new TdbInterval(tick, tick))];

    protected override RotationMatrix? Evaluate(double ticks) => Array.BinarySearch(_ticks.Value, ticks) is >= 0 and int index
        ? Matrix(Words.Read((long)index * _record, 4))
        : null;
}
