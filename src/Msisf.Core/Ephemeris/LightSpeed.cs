namespace Msisf.Core.Ephemeris;

/// <summary>What the finite speed of light does to a position, by the formulas of CSPICE.</summary>
public static class LightSpeed
{
    /// <summary>km/s, exact (SI; CLIGHT of CSPICE).</summary>
    public const double KilometresPerSecond = 299_792.458;

    /// <summary>How long light takes over a distance.</summary>
    /// <returns>s.</returns>
    public static double TimeOver(double distanceKm) => distanceKm / KilometresPerSecond;

    /// <summary>
    /// Where a moving observer sees a body: its position, turned towards the observer's motion by the angle whose sine is (v/c) sin(angle
    /// between them). The distance does not change.
    /// </summary>
    /// <param name="positionKm">Position of the body relative to the observer, km, inertial axes.</param>
    /// <param name="observerVelocity">Relative to the solar system's barycentre, km/s, the same axes; slower than light.</param>
    /// <returns>km.</returns>
    /// <remarks>
    /// STELAB of CSPICE, of first order in v/c: for the Moon (1e-4) its angle is within 5e-5 arcseconds of special relativity's
    /// (tests/reference/sun_aberration.py). With h the cross product of direction and v/c, STELAB turns by asin|h| about h; cosine and
    /// sine of that angle are computed without the angle itself.
    /// </remarks>
    public static Vector3D SeenFromMoving(Vector3D positionKm, Vector3D observerVelocity)
    {
        Vector3D velocityInC = observerVelocity / KilometresPerSecond;
        Vector3D axis = Vector3D.Cross(positionKm.Normalized(), velocityInC);
        double cosine = Math.Sqrt(1.0 - axis.LengthSquared); // axis is about 1e-4 long: nothing cancels
        return (cosine * positionKm) + Vector3D.Cross(axis, positionKm);
    }
}
