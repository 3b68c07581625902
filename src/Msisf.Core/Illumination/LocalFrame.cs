namespace Msisf.Core.Illumination;

/// <summary>A place with its own east, north and up, all unit vectors in MOON_ME; <c>default</c> means nothing.</summary>
/// <param name="PositionBodyFixed">m, body-fixed.</param>
/// <param name="East">At a pole that of longitude 0.</param>
/// <param name="North">At a right angle to both others.</param>
/// <param name="Up">Away from the body's centre.</param>
public readonly record struct LocalFrame(Vector3D PositionBodyFixed, Vector3D East, Vector3D North, Vector3D Up)
{
    /// <summary>Below it, m, the distance from the axis has no direction.</summary>
    private const double OnAxis = 1e-6;

    /// <summary>The frame at a position.</summary>
    /// <param name="positionBodyFixed">m, body-fixed; not the centre.</param>
    public static LocalFrame At(Vector3D positionBodyFixed)
    {
        Vector3D up = positionBodyFixed.Normalized();
        Vector3D east = double.Hypot(positionBodyFixed.X, positionBodyFixed.Y) > OnAxis
            ? new Vector3D(-up.Y, up.X, 0.0).Normalized()
            : Vector3D.UnitY;
        return new LocalFrame(positionBodyFixed, east, Vector3D.Cross(up, east), up);
    }

    /// <summary>Components of a direction along east, north and up.</summary>
    /// <param name="moonMe">MOON_ME.</param>
    public Vector3D ToLocal(Vector3D moonMe) => new(Vector3D.Dot(moonMe, East), Vector3D.Dot(moonMe, North), Vector3D.Dot(moonMe, Up));

    /// <summary>A direction by azimuth and elevation, body-fixed, length 1.</summary>
    /// <param name="azimuth">rad, from north over east.</param>
    /// <param name="elevation">rad, over the plane at a right angle to up.</param>
    public Vector3D DirectionOf(double azimuth, double elevation)
    {
        (double sine, double cosine) = Trigonometry.SinCos(azimuth);
        (double up, double across) = Trigonometry.SinCos(elevation);
        return (across * ((sine * East) + (cosine * North))) + (up * Up);
    }
}
