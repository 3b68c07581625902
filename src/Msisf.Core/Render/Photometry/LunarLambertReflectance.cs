namespace Msisf.Core.Render.Photometry;

/// <summary>
/// The lunar-Lambert law: a weighted sum of Lommel-Seeliger (weight L) and Lambert (weight 1 - L) (McEwen, Icarus 92 (1991), p. 298). L
/// depends on the phase angle as fitted to the Moon (McEwen, Lunar and Planetary Science XXVII (1996), p. 841).
/// </summary>
public sealed class LunarLambertReflectance : IReflectance
{
    // L = 1 + A g + B g^2 + C g^3, g in degrees. From 104 degrees on the polynomial is negative and I/F could become negative, so L is 0
    // there.
    private const double A = -0.019;
    private const double B = 2.42e-4;
    private const double C = -1.46e-6;

    private readonly double _albedo;
    private readonly double? _weight;

    /// <summary>Makes the law.</summary>
    /// <param name="albedo">Normal albedo: I/F with the Sun and the viewer at the zenith, 0 to 1.</param>
    /// <param name="weight">
    /// L, 0 (Lambert) to 1 (Lommel-Seeliger), the same at all phase angles; null for the function fitted to the Moon.
    /// </param>
    public LunarLambertReflectance(double albedo, double? weight = null)
    {
        _albedo = Guard.InRange(albedo, 0.0, 1.0, "albedo");
        _weight = weight is double given ? Guard.InRange(given, 0.0, 1.0, "lunar-lambert parameter l") : null;
    }

    /// <summary>The law as a user names it.</summary>
    public static ReflectanceLaw Law { get; } =
        new("lunar-lambert", values => new LunarLambertReflectance(values.Albedo, values.Parameter("l"))) { Parameters = ["l"] };

    /// <inheritdoc/>
    public bool DependsOnViewer => true;

    /// <inheritdoc/>
    public double RadianceFactor(double cosIncidence, double cosEmission, double phaseHaversine)
    {
        double weight = _weight ?? MoonWeight(phaseHaversine);
        return _albedo * cosIncidence * ((2.0 * weight / (cosIncidence + cosEmission)) + (1.0 - weight));
    }

    private static double MoonWeight(double phaseHaversine)
    {
        double g = double.RadiansToDegrees(PhaseAngle.FromHaversine(phaseHaversine));
        return Math.Max(0.0, 1.0 + (g * (A + (g * (B + (g * C))))));
    }
}
