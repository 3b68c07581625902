namespace Msisf.Core.Sky;

/// <summary>Where a body of the sky is seen at one time, and how it is lit.</summary>
/// <param name="ApparentJ2000">Direction of its centre, length 1, J2000: with its light time, and the observer's aberration.</param>
/// <param name="Distance">m: from the camera to its centre when the light left it.</param>
/// <param name="ToSunJ2000">From it to the Sun, length 1, J2000; 0 for the Sun.</param>
/// <param name="Phase">rad: Sun, body, observer.</param>
/// <param name="Magnitude">V of the whole body; of the Sun too.</param>
public sealed record BodyPlace(
    SkyBody Body, Vector3D ApparentJ2000, double Distance, Vector3D ToSunJ2000, double Phase, double Magnitude)
{
    /// <summary>m: the way from the camera to its centre when the light left it, J2000.</summary>
    public Vector3D WayJ2000 { get; init; }

    /// <summary>m/s: over the drawn body, J2000.</summary>
    public Vector3D VelocityJ2000 { get; init; }

    /// <summary>rad: angular radius of the equator.</summary>
    public double AngularRadius => Trigonometry.Atan2(
        Body.EquatorialRadius, Math.Sqrt((Distance - Body.EquatorialRadius) * (Distance + Body.EquatorialRadius)));

    /// <summary>Light of the whole body over sunlight at 1 au.</summary>
    public double OverSunlight => Math.Pow(10.0, -0.4 * (Magnitude - PlanetMagnitude.OfSun));
}
