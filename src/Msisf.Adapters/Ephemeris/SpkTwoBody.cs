using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

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

    public override StateVector StateAt(double tdbSeconds)
    {
        double[] epochs = _epochs.Value;
        int found = Array.BinarySearch(epochs, tdbSeconds);
        int after = found < 0 ? ~found : found;
        if (found >= 0 || after == 0 || after == epochs.Length)
        {
            return From(Math.Min(after, epochs.Length - 1), tdbSeconds);
        }

        (StateVector first, StateVector second) = (From(after - 1, tdbSeconds), From(after, tdbSeconds));
        double span = epochs[after] - epochs[after - 1];
        double angle = Math.PI * (tdbSeconds - epochs[after - 1]) / span;
        double weight = 0.5 + (0.5 * Math.Cos(angle));
        double weightRate = -0.5 * Math.PI / span * Math.Sin(angle);
        StateVector mean = (weight * first) + ((1.0 - weight) * second);
        return mean with { Velocity = mean.Velocity + (weightRate * (first.Position - second.Position)) };
    }

    private StateVector From(int index, double tdbSeconds)
    {
        double[] s = Words.Read((long)index * StateWords, StateWords);
        try
        {
            return TwoBody.Propagate(
                new StateVector(new Vector3D(s[0], s[1], s[2]), new Vector3D(s[3], s[4], s[5])), _gm, tdbSeconds - _epochs.Value[index]);
        }
        catch (BadInputException exception)
        {
            throw Words.Damaged(exception.Message.TrimEnd('.'));
        }
    }
}
