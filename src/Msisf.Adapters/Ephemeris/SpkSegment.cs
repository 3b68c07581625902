using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Adapters.Ephemeris;

/// <summary>A segment of an SPK whose data give positions and velocities together.</summary>
/// <param name="file">The kernel; must outlive the segment.</param>
internal abstract class SpkSegment(DafFile file, DafSummary summary) : IEphemerisSegment
{
    public int Body => summary.Integers[0];

    public int Center => summary.Integers[1];

    public TdbInterval Interval => summary.Interval;

    /// <summary>The segment's numbers.</summary>
    protected DafWords Words { get; } = new(file, summary);

    public Vector3D ValueAt(TdbTime tdb) => StateAt(tdb).Position;

    public Vector3D RateAt(TdbTime tdb) => StateAt(tdb).Velocity;

    public abstract StateVector StateAt(TdbTime tdb);
}

/// <summary>SPK type 1 or 21: differences of an integration, as JPL's navigation and Horizons write them.</summary>
/// <remarks>NAIF, SPK Required Reading, "Type 1", "Type 21".</remarks>
internal sealed class SpkDifferences : SpkSegment
{
    private const int TermsOfType1 = 15;
    private const int MaximumTerms = 25;

    private readonly int _terms;
    private readonly Lazy<double[]> _ends;

    /// <summary>Reads the segment's sizes.</summary>
    /// <exception cref="BadInputException">They contradict each other.</exception>
    public SpkDifferences(DafFile file, DafSummary summary, int type)
        : base(file, summary)
    {
        _terms = type == 1 ? TermsOfType1 : Words.Whole(fromEnd: 2, min: 1, MaximumTerms);
        int words = DifferenceLine.Words(_terms);
        int count = Words.Whole(fromEnd: 1, min: 1, Words.Count / (words + 1));
        _ends = new Lazy<double[]>(() => Words.ReadRising((long)count * words, count));
    }

    public override StateVector StateAt(TdbTime tdb)
    {
        // Each record serves the times up to its end; past the last end, which a summary may name, the last one goes on.
        int found = Array.BinarySearch(_ends.Value, tdb.Seconds);
        int index = Math.Min(found < 0 ? ~found : found, _ends.Value.Length - 1);
        int words = DifferenceLine.Words(_terms);
        try
        {
            return DifferenceLine.Evaluate(Words.Read((long)index * words, words), _terms, tdb);
        }
        catch (BadInputException exception) when (!exception.Message.EndsWith('.'))
        {
            throw Words.Damaged(exception.Message);
        }
    }
}

/// <summary>SPK type 5: states, between which a body moves about one mass; the paths from both neighbours are blended.</summary>
/// <remarks>NAIF, SPK Required Reading, "Type 5".</remarks>
internal sealed class SpkTwoBody : SpkSegment
{
    private const int StateWords = 6;

    private readonly double _gm;
    private readonly Lazy<double[]> _epochs;

    /// <summary>Reads the segment's sizes.</summary>
    /// <exception cref="BadInputException">They contradict each other.</exception>
    public SpkTwoBody(DafFile file, DafSummary summary)
        : base(file, summary)
    {
        int count = Words.Whole(fromEnd: 1, min: 1, Words.Count / (StateWords + 1));
        _gm = Words.Read(Words.Count - 2, 1)[0];
        _epochs = new Lazy<double[]>(() => Words.ReadRising((long)count * StateWords, count));
    }

    public override StateVector StateAt(TdbTime tdb)
    {
        double[] epochs = _epochs.Value;
        int found = Array.BinarySearch(epochs, tdb.Seconds);
        int after = found < 0 ? ~found : found;
        if (found >= 0 || after == 0 || after == epochs.Length)
        {
            return From(Math.Min(after, epochs.Length - 1), tdb);
        }

        (StateVector first, StateVector second) = (From(after - 1, tdb), From(after, tdb));
        double span = epochs[after] - epochs[after - 1];
        double angle = Math.PI * (tdb - epochs[after - 1]) / span;
        double weight = 0.5 + (0.5 * Trigonometry.Cos(angle));
        double weightRate = -0.5 * Math.PI / span * Trigonometry.Sin(angle);
        StateVector mean = (weight * first) + ((1.0 - weight) * second);
        return mean with { Velocity = mean.Velocity + (weightRate * (first.Position - second.Position)) };
    }

    private StateVector From(int index, TdbTime tdb)
    {
        double[] s = Words.Read((long)index * StateWords, StateWords);
        try
        {
            return TwoBody.Propagate(
                new StateVector(new Vector3D(s[0], s[1], s[2]), new Vector3D(s[3], s[4], s[5])), _gm, tdb - _epochs.Value[index]);
        }
        catch (BadInputException exception)
        {
            throw Words.Damaged(exception.Message.TrimEnd('.'));
        }
    }
}
