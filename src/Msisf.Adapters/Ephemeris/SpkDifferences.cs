using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

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

    public override StateVector StateAt(double tdbSeconds)
    {
        // Each record serves the times up to its end; past the last end, which a summary may name, the last one goes on.
        int found = Array.BinarySearch(_ends.Value, tdbSeconds);
        int index = Math.Min(found < 0 ? ~found : found, _ends.Value.Length - 1);
        int words = DifferenceLine.Words(_terms);
        try
        {
            return DifferenceLine.Evaluate(Words.Read((long)index * words, words), _terms, tdbSeconds);
        }
        catch (BadInputException exception) when (!exception.Message.EndsWith('.'))
        {
            throw Words.Damaged(exception.Message);
        }
    }
}
