using Msisf.Core.Terrain;

namespace Msisf.Core.Maps;

/// <summary>Kinds of maps of the ground.</summary>
public enum MapKind
{
    /// <summary>X and Y are longitude and latitude in degrees.</summary>
    LongitudeLatitude,

    /// <summary>X and Y are longitude and latitude times the radius.</summary>
    Equirectangular,

    /// <summary>About a pole, true to scale there.</summary>
    PolarStereographic,

    /// <summary>As seen from far above the centre.</summary>
    Orthographic,
}

/// <summary>
/// A map of a sphere as PROJ and GDAL have it: X to the right and Y upwards, in m, or in degrees where the map is one of longitude and
/// latitude. Immutable; <c>default</c> has no meaning.
/// </summary>
/// <param name="Latitude">Latitude of the centre, rad; +-pi / 2 for polar maps, 0 for maps of longitude and latitude.</param>
/// <param name="Longitude">
/// Longitude of the centre, rad; 0 for polar maps, which is down at the north pole and up at the south pole. The X of a map of longitude
/// and latitude lies within 180 degrees of it.
/// </param>
/// <param name="Radius">m.</param>
public readonly record struct GroundProjection(MapKind Kind, double Latitude, double Longitude, double Radius)
{
    /// <summary>Whether X and Y are degrees, and not m.</summary>
    public bool IsInDegrees => Kind == MapKind.LongitudeLatitude;

    private Vector3D East => new(-Math.Sin(Longitude), Math.Cos(Longitude), 0.0);

    private Vector3D Up => new SelenographicPoint(Latitude, Longitude).ToDirectionBodyFixed();

    private Vector3D North => Vector3D.Cross(Up, East);

    private double PoleSign => Math.Sign(Latitude);

    /// <summary>X and Y of a direction; null if the map does not show it: polar and orthographic maps show half the sphere.</summary>
    /// <param name="direction">Body-fixed, of any length above 0.</param>
    public (double X, double Y)? ToMap(Vector3D direction)
    {
        Vector3D d = direction.Normalized();
        switch (Kind)
        {
            case MapKind.LongitudeLatitude or MapKind.Equirectangular:
                double east = Vector3D.Dot(d, East);
                double forward = (d.X * Math.Cos(Longitude)) + (d.Y * Math.Sin(Longitude));
                (double across, double up) = (Math.Atan2(east, forward), Math.Atan2(d.Z, double.Hypot(d.X, d.Y)));
                return IsInDegrees
                    ? (double.RadiansToDegrees(Longitude + across), double.RadiansToDegrees(up))
                    : (Radius * across, Radius * up);
            case MapKind.PolarStereographic:
                double height = PoleSign * d.Z;
                double scale = 2.0 * Radius / (1.0 + height);
                return height > 0.0 ? (scale * d.Y, -PoleSign * scale * d.X) : null;
            default:
                return Vector3D.Dot(d, Up) > 0.0 ? (Radius * Vector3D.Dot(d, East), Radius * Vector3D.Dot(d, North)) : null;
        }
    }

    /// <summary>Direction of a place on the map, body-fixed, length 1; null where the map ends.</summary>
    /// <param name="x">m or degrees.</param>
    /// <param name="y">m or degrees.</param>
    public Vector3D? ToDirection(double x, double y)
    {
        (double a, double b) = (x / Radius, y / Radius);
        double square = (a * a) + (b * b);
        switch (Kind)
        {
            case MapKind.LongitudeLatitude:
                return Math.Abs(y) <= 90.0
                    ? new SelenographicPoint(double.DegreesToRadians(y), double.DegreesToRadians(x)).ToDirectionBodyFixed()
                    : null;
            case MapKind.Equirectangular:
                return Math.Abs(a) <= Math.PI && Math.Abs(b) <= 0.5 * Math.PI
                    ? new SelenographicPoint(b, Longitude + a).ToDirectionBodyFixed()
                    : null;
            case MapKind.PolarStereographic:
                double f = 1.0 / (1.0 + (0.25 * square));
                return square < 4.0 ? new Vector3D(-PoleSign * f * b, f * a, PoleSign * ((2.0 * f) - 1.0)) : null;
            default:
                return square < 1.0 ? (a * East) + (b * North) + (Math.Sqrt(1.0 - square) * Up) : null;
        }
    }
}
