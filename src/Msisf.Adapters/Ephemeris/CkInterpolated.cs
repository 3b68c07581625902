using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>CK type 5, ESOC's: quaternions with polynomials through those nearest to a time; intervals tell where there are gaps.</summary>
/// <remarks>NAIF, CK Required Reading, "Data Type 5".</remarks>
internal sealed class CkInterpolated : CkSegment
{
    private readonly CkPolynomials _polynomials;
    private readonly Lazy<TickIntervals> _times;

    /// <summary>Reads the segment's sizes.</summary>
    /// <exception cref="Core.Errors.BadInputException">They contradict each other.</exception>
    public CkInterpolated(DafFile file, DafSummary summary)
        : base(file, summary)
    {
        _polynomials = CkPolynomials.Read(Words, Words.Count - 2);
        int record = _polynomials.Packet;
        int count = Words.Whole(fromEnd: 1, min: 1, Words.Count / (record + 1));
        int intervals = Words.Whole(fromEnd: 2, min: 1, count);
        _times = new Lazy<TickIntervals>(() => TickIntervals.Read(Words, record, count, intervals));
    }

    public override IReadOnlyList<TdbInterval> Intervals => _times.Value.All;

    protected override RotationMatrix? Evaluate(double ticks)
    {
        TickIntervals times = _times.Value;
        (int first, int end) = times.Of(ticks);
        return ticks >= times.Ticks[first] && ticks <= times.Ticks[end - 1]
            ? Matrix(_polynomials.At(ticks, times.Ticks.AsSpan(first, end - first), (long)first * _polynomials.Packet))
            : null;
    }
}
