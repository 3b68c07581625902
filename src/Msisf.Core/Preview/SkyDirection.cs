namespace Msisf.Core.Preview;

/// <summary>Where something is in the sky of a point of the Moon.</summary>
/// <param name="Elevation">rad over the horizontal plane of the sphere through the point, [-pi/2, pi/2].</param>
/// <param name="Azimuth">
/// rad, clockwise from north, [0, 2 pi); null where it is undefined: at a pole, or for something in the zenith or nadir.
/// </param>
public readonly record struct SkyDirection(double Elevation, double? Azimuth)
{
    /// <summary>The direction from a point to something else.</summary>
    /// <param name="pointBodyFixed">The point, m; not the Moon's centre.</param>
    /// <param name="targetBodyFixed">What is seen from there, m; not the point itself.</param>
    public static SkyDirection Of(Vector3D pointBodyFixed, Vector3D targetBodyFixed)
    {
        Vector3D up = pointBodyFixed.Normalized();
        Vector3D toTarget = (targetBodyFixed - pointBodyFixed).Normalized();
        Vector3D across = Vector3D.Cross(up, toTarget);
        double elevation = Math.Atan2(Vector3D.Dot(up, toTarget), across.Length);
        double fromAxis = double.Hypot(up.X, up.Y);
        if (fromAxis < Tolerances.AzimuthSine || across.Length < Tolerances.AzimuthSine)
        {
            return new SkyDirection(elevation, Azimuth: null);
        }

        Vector3D east = new(-up.Y / fromAxis, up.X / fromAxis, 0.0);
        Vector3D north = Vector3D.Cross(up, east);
        return new SkyDirection(
            elevation, AngleReduction.ToFullTurn(Math.Atan2(Vector3D.Dot(toTarget, east), Vector3D.Dot(toTarget, north))));
    }
}
