using Msisf.Core.Numerics;

namespace Msisf.Synthesis;

/// <summary>
/// The octaves of roughness below a base model. Their slopes add up, as variances, to what the slope law asks for beyond what the base and
/// the craters have: at the base's own spacing the terrain is as rough as the base, from <see cref="SlopeLaw.LongestBaseline"/> down
/// (a quarter of the base's spacing, if that is shorter) it follows the law, in between it goes evenly, octave by octave, from one to the
/// other.
/// </summary>
/// <remarks>
/// An octave does not depend on the resolution that is asked for: a finer product of the same seed and base has the same hills and more
/// small ones.
/// </remarks>
internal static class DetailSpectrum
{
    /// <summary>
    /// 1: finest lattice spacing in output samples; its waves of 2 to 4 samples are the shortest that the output can hold.
    /// </summary>
    public const double FinestSpacingInSamples = 1.9;

    // The median length of a 2-D Gaussian slope is sqrt(2 ln 2) times the RMS of one component.
    private const double MedianOverRms = 1.1774100225154747;

    // The noise's slope between points half a lattice step apart is 0.84 of its derivative (GradientNoiseTests): so much the finest octave
    // shows between the output's samples, the coarser ones nearly all of theirs.
    private const double VisibleSlope = 0.97;

    // Slope power (tangent squared) that craters add in an octave of diameters, for each crater per square of the diameter (measured,
    // docs/synthetic-ldem.md).
    private const double CraterSlopePower = 0.0108;

    // Craters are sparse: even where they fill the law there is this part of noise between them.
    private const double MinNoisePart = 0.15;

    /// <summary>Octaves from the base's spacing down to the output's.</summary>
    /// <param name="seed">The user's seed.</param>
    /// <param name="baseSpacing">m between the base's samples.</param>
    /// <param name="outputSpacing">m between the output's samples.</param>
    /// <param name="baseSlopes">Measured at the base's spacing.</param>
    public static NoiseOctave[] Octaves(ulong seed, double baseSpacing, double outputSpacing, ModelSlopes baseSlopes)
    {
        List<NoiseOctave> octaves = [];
        for (double spacing = baseSpacing; spacing >= FinestSpacingInSamples * outputSpacing; spacing *= 0.5)
        {
            // Craters twice as wide as the lattice have waves as long as the noise.
            double diameter = 2.0 * spacing;
            double craters = CraterSlopePower * diameter * diameter * CraterPopulation.HighlandsCountAbove(diameter);

            // Sparse craters move the median less than their share of the power.
            double thinned = CraterPopulation.MareDensity(diameter);
            octaves.Add(new NoiseOctave(
                seed,
                spacing,
                Amplitude(SlopeLaw.Highlands, spacing, baseSpacing, baseSlopes.Highlands, craters),
                Amplitude(SlopeLaw.Maria, spacing, baseSpacing, baseSlopes.Maria, craters * thinned * thinned)));
        }

        return [.. octaves];
    }

    private static double Amplitude(SlopeLaw law, double spacing, double baseSpacing, double? baseTangent, double craterPower)
    {
        double fine = Target(law, spacing / 2.0, baseSpacing, baseTangent);
        double coarse = Target(law, spacing, baseSpacing, baseTangent);
        double power = (fine * fine) - (coarse * coarse);
        double noisePower = Math.Max(power - craterPower, MinNoisePart * power);
        return Math.Sqrt(noisePower) * spacing / (MedianOverRms * GradientNoise.RmsSlope * VisibleSlope);
    }

    private static double Target(SlopeLaw law, double baseline, double baseSpacing, double? baseTangent)
    {
        double meeting = Math.Min(SlopeLaw.LongestBaseline, baseSpacing / 4.0);
        if (baseline <= meeting)
        {
            return law.TangentAt(baseline);
        }

        double lawAtBase = law.TangentAt(baseSpacing);
        double atBase = Math.Min(baseTangent ?? lawAtBase, lawAtBase);
        double atMeeting = law.TangentAt(meeting);
        double part = PortableMath.Log2(baseline / meeting) / PortableMath.Log2(baseSpacing / meeting);
        return atMeeting + (part * (atBase - atMeeting));
    }
}
