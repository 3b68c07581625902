namespace Msisf.Core.Render.Photometry;

/// <summary>
/// The lunar-Lambert law: a weighted sum of Lommel-Seeliger (weight L) and Lambert (weight 1 - L) (McEwen, Icarus 92 (1991), p. 298). L
/// depends on the phase angle as fitted to the Moon (McEwen, Lunar and Planetary Science XXVII (1996), p. 841).
/// </summary>
public sealed class LunarLambertReflectance : IReflectance, IEnclosedLaw
{
    // L = 1 + A g + B g^2 + C g^3, g in degrees. From 104 degrees on the polynomial is negative and I/F could become negative, so L is 0
    // there.
    private const double A = -0.019;
    private const double B = 2.42e-4;
    private const double C = -1.46e-6;

    /// <summary>Degrees: below, the polynomial is positive.</summary>
    private const double LastPositive = 100.0;

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

    Sloped IEnclosedLaw.Enclose(in Sloped cosIncidence, in Sloped cosEmission, in Sloped phaseHaversine)
    {
        Sloped weight = _weight is { } given ? given : MoonWeight(in phaseHaversine);
        return _albedo * ((2.0 * weight / (1.0 + (cosEmission / cosIncidence))) + ((1.0 - weight) * cosIncidence));
    }

    /// <summary>The weight falls with g, with its slope by the haversine: dg is 1 / sqrt(h (1 - h)) of that.</summary>
    private static Sloped MoonWeight(in Sloped phaseHaversine)
    {
        Interval h = phaseHaversine.Value;
        Interval g = new(
            double.RadiansToDegrees(PhaseAngle.FromHaversine(h.Low)), double.RadiansToDegrees(PhaseAngle.FromHaversine(h.High)));
        Interval perHaversine = new(
            1.0 / Math.Sqrt(h.High * (1.0 - h.Low)), 1.0 / Math.Sqrt(h.Low * (1.0 - h.High)));
        Interval byDegrees = A + (g * ((2.0 * B) + (g * (3.0 * C))));
        Interval slope = double.RadiansToDegrees(1.0) * (byDegrees * perHaversine);
        return phaseHaversine.Then(MoonWeight, g.High > LastPositive ? slope.Hull(0.0) : slope);
    }

    private static double MoonWeight(double phaseHaversine)
    {
        double g = double.RadiansToDegrees(PhaseAngle.FromHaversine(phaseHaversine));
        return Math.Max(0.0, 1.0 + (g * (A + (g * (B + (g * C))))));
    }
}
