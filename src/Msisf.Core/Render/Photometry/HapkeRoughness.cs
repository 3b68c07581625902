using Msisf.Core.Numerics;

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
        double azimuth = PhaseAngle.FromHaversine(azimuthHaversine);
        double hidden = Math.Exp(-2.0 * PhaseAngle.HalfTangent(azimuthHaversine));

        // The formulas for i <= e and for e <= i differ only in which of the two directions is nearer to the horizon.
        bool isSunLower = sun.Cosine < viewer.Cosine;
        Slant lower = isSunLower ? sun : viewer;
        Slant upper = isSunLower ? viewer : sun;
        double below = _tangent / (2.0 - lower.E1 - (azimuth / Math.PI * upper.E1));
        double lowerEffective = _chi * (lower.Cosine + (lower.Sine * below * (lower.E2 - (azimuthHaversine * upper.E2))));
        double upperEffective = _chi
            * (upper.Cosine + (upper.Sine * below * (((1.0 - (2.0 * azimuthHaversine)) * lower.E2) + (azimuthHaversine * upper.E2))));
        double cosIncidenceEffective = isSunLower ? lowerEffective : upperEffective;
        double cosEmissionEffective = isSunLower ? upperEffective : lowerEffective;

        double shadowing = cosEmissionEffective / viewer.Eta * (sun.Cosine / sun.Eta) * _chi
            / (1.0 - hidden + (hidden * _chi * upper.Cosine / upper.Eta));
        return new RoughSurface(cosIncidenceEffective, cosEmissionEffective, shadowing);
    }

    private Slant SlantOf(double givenCosine)
    {
        double cosine = Math.Max(givenCosine, Tolerances.GrazingCosine);
        double sine = Math.Sqrt((1.0 - cosine) * (1.0 + cosine));
        double x = _cotangent * cosine / sine;
        double e1 = Math.Exp(-2.0 / Math.PI * x);
        double e2 = Math.Exp(-1.0 / Math.PI * x * x);
        return new Slant(cosine, sine, e1, e2, _chi * (cosine + (sine * _tangent * e2 / (2.0 - e1))));
    }

    /// <summary>The values of one direction that the formulas use; Eta is its effective cosine at azimuth 0.</summary>
    private readonly record struct Slant(double Cosine, double Sine, double E1, double E2, double Eta);
}
