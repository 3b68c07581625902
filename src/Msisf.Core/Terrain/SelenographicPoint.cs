namespace Msisf.Core.Terrain;

/// <summary>Selenographic latitude and east longitude in rad; <c>default</c> is the origin of both.</summary>
/// <param name="Latitude">rad, [-pi/2, pi/2].</param>
/// <param name="Longitude">rad, east, [0, 2 pi).</param>
public readonly record struct SelenographicPoint(double Latitude, double Longitude)
{
    /// <summary>The point below a position. On the polar axis the longitude is 0.</summary>
    /// <param name="positionBodyFixed">m, body-fixed; not the centre.</param>
    /// <remarks>Thesis eq. 3.10, by atan2 (docs/deviations.md, row 6).</remarks>
    public static SelenographicPoint Below(Vector3D positionBodyFixed)
    {
        double latitude = Trigonometry.Atan2(positionBodyFixed.Z, double.Hypot(positionBodyFixed.X, positionBodyFixed.Y));
        return new SelenographicPoint(latitude, AngleReduction.ToFullTurn(Trigonometry.Atan2(positionBodyFixed.Y, positionBodyFixed.X)));
    }

    /// <summary>The unit vector from the Moon's centre to this point, body-fixed (thesis eq. 3.9).</summary>
    public Vector3D ToDirectionBodyFixed()
    {
        (double sinLatitude, double cosLatitude) = Trigonometry.SinCos(Latitude);
        (double sinLongitude, double cosLongitude) = Trigonometry.SinCos(Longitude);
        return new Vector3D(cosLatitude * cosLongitude, cosLatitude * sinLongitude, sinLatitude);
    }
}
