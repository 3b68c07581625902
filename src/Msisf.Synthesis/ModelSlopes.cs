using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// Median slopes of the smooth surface through an elevation model's samples, as tangents; null where the model has too few samples of the
/// terrain.
/// </summary>
/// <param name="Highlands">Tangent, where the mare fraction is 0.</param>
/// <param name="Maria">Tangent, where the mare fraction is 1.</param>
internal sealed record ModelSlopes(double? Highlands, double? Maria)
{
    private const int MinCount = 200; // samples; a median of fewer says little
    private const int NorthernmostDegree = 60; // nearer the poles the samples of a line crowd together

    /// <summary>Measures a model on lines and samples about a degree apart.</summary>
    /// <param name="model">Any resolution.</param>
    /// <param name="maria">Its mare mask.</param>
    public static ModelSlopes Of(IGlobalGrid model, MareMask maria)
    {
        int resolution = model.PixelsPerDegree;
        int around = 360 * resolution;
        double spacing = Spacing(resolution);
        double[] radii = new double[around];
        double[][] lines = [new double[around], new double[around], new double[around], new double[around]];
        List<double> highlandSlopes = [];
        List<double> mareSlopes = [];
        for (int degree = -NorthernmostDegree; degree <= NorthernmostDegree; degree++)
        {
            int line = (90 - degree) * resolution;
            double latitude = 90.0 - ((line + 0.5) / resolution);
            double cosLatitude = PortableMath.SinCosDegrees(latitude).Cos;
            for (int i = 0; i < lines.Length; i++)
            {
                model.ReadRadii(line - 1 + i, 0, lines[i]);
            }

            for (int sample = 0; sample < around; sample += resolution)
            {
                double fraction = maria.At(latitude, (sample + 0.5) / resolution);
                List<double>? slopes = fraction <= 0.0 ? highlandSlopes : fraction >= 1.0 ? mareSlopes : null;
                double toEast = Derivative(At(lines[1], sample - 1), lines[1][sample], At(lines[1], sample + 1), At(lines[1], sample + 2));
                double toSouth = Derivative(lines[0][sample], lines[1][sample], lines[2][sample], lines[3][sample]) * cosLatitude;
                slopes?.Add(Math.Sqrt((toEast * toEast) + (toSouth * toSouth)) / (spacing * cosLatitude));
            }
        }

        return new ModelSlopes(Median(highlandSlopes), Median(mareSlopes));
    }

    /// <summary>Distance between neighbouring lines of a model, m.</summary>
    public static double Spacing(double pixelsPerDegree) => MoonConstants.ReferenceRadius * Math.PI / (180.0 * pixelsPerDegree);

    // Change of height per spacing where the two middle pixels meet, of the cubic with these four pixel means; a plain difference is too
    // small by a quarter.
    private static double Derivative(double a, double b, double c, double d) => ((15.0 * (c - b)) - (d - a)) / 12.0;

    private static double At(double[] line, int sample) => line[(sample + line.Length) % line.Length];

    private static double? Median(List<double> values)
    {
        values.Sort();
        return values.Count < MinCount ? null : values[values.Count / 2];
    }
}

/// <summary>How the median slope of a terrain falls with the baseline: tan(slope) ~ baseline^(H - 1).</summary>
/// <param name="TangentAt17Metres">Tangent of the median slope at a baseline of 17 m.</param>
/// <param name="HurstExponent">H, 0 to 1.</param>
/// <remarks>
/// M. A. Rosenburg et al., "Global surface slopes and roughness of the Moon from the Lunar Orbiter Laser Altimeter", JGR 116, E02001
/// (2011).
/// </remarks>
internal sealed record SlopeLaw(double TangentAt17Metres, double HurstExponent)
{
    /// <summary>
    /// m: longest baseline for which the law holds; beyond about a kilometre the Moon's slopes fall faster (Rosenburg et al., figure of
    /// the breakover points).
    /// </summary>
    public const double LongestBaseline = 1000.0;

    private const double BelowMetre = 0.86; // H at most

    private const double ReferenceBaseline = 17.0; // m: between LOLA's neighbouring spots

    /// <summary>The maria: 2.0 degrees at 17 m and H = 0.76.</summary>
    public static SlopeLaw Maria { get; } = new(TangentOfDegrees(2.0), 0.76);

    /// <summary>The highlands: 7.5 degrees at 17 m and H = 0.95.</summary>
    public static SlopeLaw Highlands { get; } = new(TangentOfDegrees(7.5), 0.95);

    /// <summary>Tangent of the median slope at a baseline in m.</summary>
    public double TangentAt(double baseline) =>
        TangentAt17Metres * PortableMath.Pow(baseline / ReferenceBaseline, HurstExponent - 1.0);

    /// <summary>
    /// The same, but below a metre slopes grow at least as with H = 0.86: with the highlands' 0.95 ground would look like snow. Stereo
    /// pictures of Apollo's show 0.5 to 0.8 over millimetres and centimetres (P. Helfenstein, M. K. Shepard, Icarus 141 (1999), 107).
    /// </summary>
    public double TangentOfGroundAt(double baseline) => baseline >= 1.0
        ? TangentAt(baseline)
        : TangentAt(1.0) * PortableMath.Pow(baseline, Math.Min(HurstExponent, BelowMetre) - 1.0);

    private static double TangentOfDegrees(double degrees)
    {
        (double sin, double cos) = PortableMath.SinCosDegrees(degrees);
        return sin / cos;
    }
}
