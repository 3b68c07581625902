namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Akimov's law: his disk function times an exponential of the phase angle (Shkuratov et al., Planetary and Space Science 59 (2011),
/// p. 1326). It has the brightness of a rough body towards limb and terminator and no parameter for that.
/// </summary>
/// <remarks>
/// I/F = A exp(-mu g) cos(g/2) cos[pi/(pi - g) (lambda - g/2)] cos(beta)^(g/(pi - g)) / cos(lambda), with the phase angle g and the
/// photometric longitude and latitude lambda and beta: cos e = cos(beta) cos(lambda), cos i = cos(beta) cos(lambda - g).
/// </remarks>
public sealed class AkimovReflectance : IReflectance
{
    /// <summary>
    /// rad^-1: slope of the Moon's phase curve beyond the opposition surge (Korokhin et al., Solar System Research 41 (2007), p. 19).
    /// </summary>
    private const double MoonSlope = 0.7;

    private readonly double _albedo;
    private readonly double _slope;

    /// <summary>Makes the law.</summary>
    /// <param name="albedo">Normal albedo: I/F with the Sun and the viewer at the zenith, 0 to 1.</param>
    /// <param name="slope">mu, rad^-1: decay of the brightness with the phase angle, 0 to 10; null for the Moon's.</param>
    public AkimovReflectance(double albedo, double? slope = null)
    {
        _albedo = Guard.InRange(albedo, 0.0, 1.0, "albedo");
        _slope = Guard.InRange(slope ?? MoonSlope, 0.0, 10.0, "akimov parameter mu (rad^-1)");
    }

    /// <summary>The law as a user names it.</summary>
    public static ReflectanceLaw Law { get; } = new("akimov", values => new AkimovReflectance(values.Albedo, values.Parameter("mu")))
    {
        Parameters = ["mu"],
    };

    /// <inheritdoc/>
    public bool DependsOnViewer => true;

    /// <inheritdoc/>
    public double RadianceFactor(double cosIncidence, double cosEmission, double phaseHaversine)
    {
        if (phaseHaversine is 0.0 or 1.0)
        {
            return _albedo * (1.0 - phaseHaversine); // the coordinates are undefined there, the law's limits are not
        }

        // The differences are formed before anything is multiplied, so that opposition and forward scattering keep their digits.
        double phase = PhaseAngle.FromHaversine(phaseHaversine);
        double supplement = PhaseAngle.FromHaversine(1.0 - phaseHaversine); // pi - phase
        double sine = 2.0 * Math.Sqrt(phaseHaversine * (1.0 - phaseHaversine));
        double fromLimb = Math.Atan2(cosEmission * sine, cosIncidence - cosEmission + (2.0 * phaseHaversine * cosEmission));
        double fromTerminator = Math.Atan2(cosIncidence * sine, cosEmission - cosIncidence + (2.0 * phaseHaversine * cosIncidence));

        // Both angles lie on the photometric equator, with the sum pi - phase. In the smaller one the law's ratio of cosines is
        // sin(pi/(pi - phase) limb) / sin(limb): it has its finite limit at the limb and is 0 at the terminator.
        bool isNearLimb = fromLimb < fromTerminator;
        double near = isNearLimb ? fromLimb : fromTerminator;
        double sineOfFar = Math.Sin(phase + near);
        double longitudes = Math.Sin(Math.PI / supplement * near) / (isNearLimb ? Math.Sin(near) : sineOfFar);
        double cosLatitude = (isNearLimb ? cosIncidence : cosEmission) / sineOfFar;
        return _albedo * Math.Exp(-_slope * phase) * Math.Sqrt(1.0 - phaseHaversine)
            * longitudes * Math.Pow(Math.Min(1.0, cosLatitude), phase / supplement);
    }
}
