using Msisf.Core.Numerics;

namespace Msisf.Core.Terrain;

/// <summary>Selenographic latitude and east longitude in rad; <c>default</c> is the origin of both.</summary>
/// <param name="Latitude">rad, [-pi/2, pi/2].</param>
/// <param name="Longitude">rad, east, [0, 2 pi).</param>
public readonly record struct SelenographicPoint(double Latitude, double Longitude)
{
    /// <summary>The point below a position. On the polar axis the longitude is 0.</summary>
    /// <param name="positionMoonMe">m, MOON_ME; not the centre.</param>
    /// <remarks>Thesis eq. 3.10, by atan2 (docs/deviations.md, row 6).</remarks>
    public static SelenographicPoint Below(Vector3D positionMoonMe)
    {
        double latitude = Math.Atan2(positionMoonMe.Z, double.Hypot(positionMoonMe.X, positionMoonMe.Y));
        return new SelenographicPoint(latitude, AngleReduction.ToFullTurn(Math.Atan2(positionMoonMe.Y, positionMoonMe.X)));
    }

    /// <summary>The unit vector from the Moon's centre to this point, MOON_ME (thesis eq. 3.9).</summary>
    public Vector3D ToDirectionMoonMe()
    {
        (double sinLatitude, double cosLatitude) = Math.SinCos(Latitude);
        (double sinLongitude, double cosLongitude) = Math.SinCos(Longitude);
        return new Vector3D(cosLatitude * cosLongitude, cosLatitude * sinLongitude, sinLatitude);
    }
}
