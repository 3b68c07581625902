namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Hapke's correction for roughness: the shadows of unresolved slopes (Hapke, Icarus 59 (1984), p. 41). Equation numbers are those of his
/// book of 2012, eq. 12.45-12.54.
/// </summary>
internal sealed class HapkeRoughness
{
    private readonly double _tangent;
    private readonly double _cotangent;
    private readonly double _chi;

    /// <summary>Makes the correction.</summary>
    /// <param name="meanSlope">Theta-bar, rad, 0 (no correction) to below pi/2.</param>
    public HapkeRoughness(double meanSlope)
    {
        _tangent = Math.Tan(meanSlope);
        _cotangent = 1.0 / _tangent;
        _chi = 1.0 / Math.Sqrt(1.0 + (Math.PI * _tangent * _tangent));
    }

    /// <summary>
    /// The smooth surface that replaces the rough one at a point; arguments as in <see cref="IReflectance.RadianceFactor"/>.
    /// </summary>
    public RoughSurface At(double cosIncidence, double cosEmission, double phaseHaversine)
    {
        Slant sun = SlantOf(cosIncidence);
        Slant viewer = SlantOf(cosEmission);

        // The law of haversines: hav g = hav(i - e) + sin i sin e hav(psi). For a vertical direction the azimuth psi is undefined and has
        // no effect.
        double product = sun.Sine * viewer.Sine;
        double meridian = 0.5 * (1.0 - (sun.Cosine * viewer.Cosine) - product);
        double azimuthHaversine = product > 0.0 ? Math.Clamp((phaseHaversine - meridian) / product, 0.0, 1.0) : 0.0;
        double azimuthRest = 1.0 - azimuthHaversine;
        double azimuth = PhaseAngle.FromHaversine(azimuthHaversine) / Math.PI;
        double azimuthFromBehind = 2.0 / Math.PI * Math.Atan2(Math.Sqrt(azimuthRest), Math.Sqrt(azimuthHaversine));
        double shown = OneMinusExp(-2.0 * PhaseAngle.HalfTangent(azimuthHaversine));
        double hidden = 1.0 - shown;

        // The formulas for i <= e and for e <= i differ only in which of the two directions is nearer to the horizon.
        bool isSunLower = sun.Cosine < viewer.Cosine;
        Slant lower = isSunLower ? sun : viewer;
        Slant upper = isSunLower ? viewer : sun;

        // With both at the horizon, E1 and E2 are near 1 and the formulas of the book are differences of almost equal numbers. So they are
        // written with 1 - E1 and 1 - E2: 2 - E1 - E1' psi / pi, E2 - E2' hav psi, and E2 cos psi + E2' hav psi.
        double below = _tangent / (lower.OneMinusE1 + (azimuth * upper.OneMinusE1) + azimuthFromBehind);
        double between = upper.OneMinusE2 - lower.OneMinusE2;
        double lowerEffective = _chi * (lower.Cosine + (lower.Sine * below * ((azimuthRest * (1.0 - upper.OneMinusE2)) + between)));
        double upperEffective = _chi
            * (upper.Cosine + (upper.Sine * below * ((azimuthRest * (1.0 - lower.OneMinusE2)) - (azimuthHaversine * between))));
        double cosIncidenceEffective = isSunLower ? lowerEffective : upperEffective;
        double cosEmissionEffective = isSunLower ? upperEffective : lowerEffective;

        double shadowing = cosEmissionEffective / viewer.Eta * (sun.Cosine / sun.Eta) * _chi
            / (shown + (hidden * _chi * upper.Cosine / upper.Eta));
        return new RoughSurface(cosIncidenceEffective, cosEmissionEffective, shadowing);
    }

    private Slant SlantOf(double givenCosine)
    {
        double cosine = Math.Max(givenCosine, Tolerances.GrazingCosine);
        double sine = Math.Sqrt((1.0 - cosine) * (1.0 + cosine));
        double x = _cotangent * cosine / sine;
        double oneMinusE1 = OneMinusExp(-2.0 / Math.PI * x);
        double oneMinusE2 = OneMinusExp(-1.0 / Math.PI * x * x);
        double eta = _chi * (cosine + (sine * _tangent * (1.0 - oneMinusE2) / (1.0 + oneMinusE1)));
        return new Slant(cosine, sine, oneMinusE1, oneMinusE2, eta);
    }

    /// <summary>1 - e^x for x up to 0, also beside 0 with all its digits.</summary>
    /// <remarks>W. Kahan's way: N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., 2002, 1.14.1.</remarks>
    private static double OneMinusExp(double x)
    {
        double exponential = Math.Exp(x);
        return exponential switch
        {
            1.0 => -x,
            < 1e-17 => 1.0,
            _ => (1.0 - exponential) * (x / Math.Log(exponential)),
        };
    }

    /// <summary>The values of one direction that the formulas use; Eta is its effective cosine at azimuth 0.</summary>
    private readonly record struct Slant(double Cosine, double Sine, double OneMinusE1, double OneMinusE2, double Eta);
}

/// <summary>The smooth surface that replaces a rough surface in Hapke's law.</summary>
/// <param name="CosIncidence">Cosine of the effective incidence angle, mu_0e.</param>
/// <param name="CosEmission">Cosine of the effective emission angle, mu_e.</param>
/// <param name="Shadowing">Shadowing factor S: the fraction of the light that remains after shadowing.</param>
internal readonly record struct RoughSurface(double CosIncidence, double CosEmission, double Shadowing);
