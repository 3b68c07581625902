using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// The octaves of roughness finer than a base model. The variances of their slopes add up to what the slope law requires beyond base and
/// craters. At the base's own spacing the terrain is as rough as the base. From <see cref="SlopeLaw.LongestBaseline"/> down (a quarter of
/// the base's spacing, if that is shorter) it follows the law. In between, the slope is interpolated octave by octave.
/// </summary>
/// <remarks>
/// An octave does not depend on the output's resolution: a finer product of the same seed and base has the same hills and adds small
/// ones.
/// </remarks>
internal static class DetailSpectrum
{
    /// <summary>
    /// Minimum lattice spacing in output samples; its waves of 2 to 4 samples are the shortest that the output can represent.
    /// </summary>
    public const double FinestSpacingInSamples = 1.9;

    // The median length of a 2-D Gaussian slope is sqrt(2 ln 2) times the RMS of one component.
    private const double MedianOverRms = 1.1774100225154747;

    // The noise's slope between points half a lattice step apart is 0.84 of its derivative (GradientNoiseTests): this is the part that
    // the finest octave shows between the output's samples; the coarser octaves show nearly all of their slope.
    private const double VisibleSlope = 0.97;

    // Slope power (tangent squared) that craters of one octave of diameters add, per crater in an area of diameter x diameter (measured,
    // docs/elevation-models.md).
    private const double CraterSlopePower = 0.0108;

    // Minimum part of the slope power that is noise: craters are sparse, so there is noise between them even where they alone would meet
    // the law.
    private const double MinNoisePart = 0.15;

    // On highlands, craters up to two samples of the model and cells that keep their means bring slopes of their own over hundreds of
    // metres (docs/invented-detail.md): so much of the noise's amplitude is left there from this lattice spacing on, m.
    private const double NoiseAmongLargeCraters = 0.3;
    private const double LeastOfLargeCraters = 256.0;

    /// <summary>Octaves from the base's spacing down to the output's.</summary>
    /// <param name="seed">The user's seed.</param>
    /// <param name="baseSpacing">m between the base's samples.</param>
    /// <param name="outputSpacing">m between the output's samples.</param>
    /// <param name="baseSlopes">Slopes of the base, measured at its own spacing.</param>
    /// <param name="law">Number of craters; null for that of synthetic models.</param>
    public static NoiseOctave[] Octaves(
        ulong seed, double baseSpacing, double outputSpacing, ModelSlopes baseSlopes, CraterLaw? law = null)
    {
        bool isGround = law is not null;
        law ??= CraterLaw.OfModels;
        List<NoiseOctave> octaves = [];
        for (double spacing = baseSpacing; spacing >= FinestSpacingInSamples * outputSpacing; spacing *= 0.5)
        {
            // Craters twice as wide as the lattice spacing have the same wavelength as the noise.
            double diameter = 2.0 * spacing;
            double craters = CraterSlopePower * diameter * diameter * law.CountAbove(diameter);

            // Sparse craters change the median slope less than their share of the power.
            double thinned = law.MareDensity(diameter);
            octaves.Add(new NoiseOctave(
                seed,
                spacing,
                Amplitude(SlopeLaw.Highlands, spacing, baseSpacing, baseSlopes.Highlands, craters, isGround),
                Amplitude(SlopeLaw.Maria, spacing, baseSpacing, baseSlopes.Maria, craters * thinned * thinned, isGround)));
        }

        return [.. octaves];
    }

    private static double Amplitude(
        SlopeLaw law, double spacing, double baseSpacing, double? baseTangent, double craterPower, bool isGround)
    {
        double fine = Target(law, spacing / 2.0, baseSpacing, baseTangent, isGround);
        double coarse = Target(law, spacing, baseSpacing, baseTangent, isGround);
        double power = (fine * fine) - (coarse * coarse);
        double noisePower = Math.Max(power - craterPower, MinNoisePart * power);
        double part = isGround && law == SlopeLaw.Highlands && spacing >= LeastOfLargeCraters ? NoiseAmongLargeCraters : 1.0;
        return part * Math.Sqrt(noisePower) * spacing / (MedianOverRms * GradientNoise.RmsSlope * VisibleSlope);
    }

    private static double Target(SlopeLaw law, double baseline, double baseSpacing, double? baseTangent, bool isGround)
    {
        double meeting = Math.Min(SlopeLaw.LongestBaseline, baseSpacing / 4.0);
        if (baseline <= meeting)
        {
            return isGround ? law.TangentOfGroundAt(baseline) : law.TangentAt(baseline);
        }

        double lawAtBase = law.TangentAt(baseSpacing);
        double atBase = Math.Min(baseTangent ?? lawAtBase, lawAtBase);
        double atMeeting = law.TangentAt(meeting);
        double part = PortableMath.Log2(baseline / meeting) / PortableMath.Log2(baseSpacing / meeting);
        return atMeeting + (part * (atBase - atMeeting));
    }
}

/// <summary>Means of the invented detail over the cells of a model.</summary>
internal static class DetailMeans
{
    /// <summary>Places along a side of a cell at most whose mean is that of the cell; fewer where the ground has wide cells.</summary>
    private const int MostPlacesASide = 20;

    /// <summary>
    /// Cells of the ground along a side of a cell of the model, if narrower ones are drawn: what is too small for them has a mean near 0.
    /// </summary>
    private const double CellsASide = 48.0;

    /// <summary>m: width of the cells in which a mean is computed that is the same for all narrower ones.</summary>
    public static double CellFor(double spacing, double cell) =>
        Math.Max(cell, Math.ScaleB(1.0, (int)Math.Floor(Math.Log2(spacing / CellsASide))));

    /// <summary>Mean of the detail over a cell, m.</summary>
    /// <param name="model">The model.</param>
    /// <param name="maria">Where the ground is smoother.</param>
    /// <param name="layer">The detail in cells of the width for means.</param>
    /// <param name="cell">m: that width.</param>
    /// <param name="line">The model's line.</param>
    /// <param name="sample">Its sample.</param>
    public static double Of(ITerrainGrid model, MareMask maria, DetailLayer layer, double cell, int line, int sample)
    {
        int fours = (int)Math.Ceiling(0.25 * model.Projection.Resolution.MetresPerPixel / cell);
        GroundPoints places = GroundPoints.Within(model, line, sample, Math.Min(4 * fours, MostPlacesASide));
        float[] fractions = new float[places.Count];
        float[] heights = new float[places.Count];
        Vector3D middle = model.Projection.DirectionOf(line, sample);
        double farthest = 0.0;
        for (int i = 0; i < fractions.Length; i++)
        {
            fractions[i] = (float)maria.At(places.Latitudes[i], places.Longitudes[i]);
            farthest = Math.Max(farthest, (places[i] - middle).LengthSquared);
        }

        layer.AddTo(places.X, places.Y, places.Z, middle, Math.Sqrt(farthest), fractions, heights);
        double sum = 0.0;
        foreach (float height in heights)
        {
            sum += height;
        }

        return sum / heights.Length;
    }
}
