using Msisf.Core.Terrain;

namespace Msisf.Core.Maps;

/// <summary>Kinds of maps onto which images are put.</summary>
public enum MapKind
{
    /// <summary>X and Y are longitude and latitude times the radius.</summary>
    Equirectangular,

    /// <summary>About a pole, true to scale there.</summary>
    PolarStereographic,

    /// <summary>As seen from far above the centre.</summary>
    Orthographic,
}

/// <summary>
/// A map of a sphere as PROJ and GDAL have it: X to the right and Y upwards, m. Immutable; <c>default</c> has no meaning.
/// </summary>
/// <param name="Latitude">rad: of the centre; 0 of equirectangular maps, +-pi / 2 of polar ones.</param>
/// <param name="Longitude">rad: of the centre; of polar maps 0, which is down at the north pole and up at the south pole.</param>
/// <param name="Radius">m.</param>
public readonly record struct ImageMapProjection(MapKind Kind, double Latitude, double Longitude, double Radius)
{
    private Vector3D East => new(-Math.Sin(Longitude), Math.Cos(Longitude), 0.0);

    private Vector3D Up => new SelenographicPoint(Latitude, Longitude).ToDirectionBodyFixed();

    private Vector3D North => Vector3D.Cross(Up, East);

    private double PoleSign => Math.Sign(Latitude);

    /// <summary>X and Y of a direction; null if the map does not show it: half the sphere for all but equirectangular maps.</summary>
    /// <param name="direction">Body-fixed, of any length above 0.</param>
    public (double X, double Y)? ToMap(Vector3D direction)
    {
        Vector3D d = direction.Normalized();
        switch (Kind)
        {
            case MapKind.Equirectangular:
                double east = Vector3D.Dot(d, East);
                double forward = (d.X * Math.Cos(Longitude)) + (d.Y * Math.Sin(Longitude));
                return (Radius * Math.Atan2(east, forward), Radius * Math.Atan2(d.Z, double.Hypot(d.X, d.Y)));
            case MapKind.PolarStereographic:
                double height = PoleSign * d.Z;
                double scale = 2.0 * Radius / (1.0 + height);
                return height > 0.0 ? (scale * d.Y, -PoleSign * scale * d.X) : null;
            default:
                return Vector3D.Dot(d, Up) > 0.0 ? (Radius * Vector3D.Dot(d, East), Radius * Vector3D.Dot(d, North)) : null;
        }
    }

    /// <summary>Direction of a place on the map, body-fixed, length 1; null where the map ends.</summary>
    /// <param name="x">m.</param>
    /// <param name="y">m.</param>
    public Vector3D? ToDirection(double x, double y)
    {
        (double a, double b) = (x / Radius, y / Radius);
        double square = (a * a) + (b * b);
        switch (Kind)
        {
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
