using Msisf.Core.Ephemeris;
using Msisf.Core.Maps;

namespace Msisf.Adapters.Maps;

/// <summary>The coordinate reference system of a map.</summary>
/// <param name="Wkt">In the words of the OGC (WKT, version 1).</param>
/// <param name="Name">Authority and number, as in IAU_2015:30135; null where none has one.</param>
public sealed record MapReference(string Wkt, string? Name)
{
    /// <summary>Systems that the IAU's working group numbers for each body: 100 times NAIF's number, and this.</summary>
    private static readonly (MapKind Kind, double Latitude, double Longitude, int Number, string Words)[] Numbered =
    [
        (MapKind.LongitudeLatitude, 0.0, 0.0, 0, string.Empty),
        (MapKind.Equirectangular, 0.0, 0.0, 10, " / Equirectangular, clon = 0"),
        (MapKind.Equirectangular, 0.0, 180.0, 15, " / Equirectangular, clon = 180"),
        (MapKind.PolarStereographic, 90.0, 0.0, 30, " / North Polar"),
        (MapKind.PolarStereographic, -90.0, 0.0, 35, " / South Polar"),
        (MapKind.Orthographic, 0.0, 0.0, 65, " / Orthographic, clon = 0"),
        (MapKind.Orthographic, 0.0, 180.0, 70, " / Orthographic, clon = 180"),
    ];

    /// <summary>m: radii of the IAU's spheres (2015), where they are not the body's mean radius.</summary>
    private static readonly Dictionary<int, double> OtherRadii = new() { [199] = 2_440_530.0, [499] = 3_396_190.0 };

    /// <summary>The name, for files that can't hold it otherwise (GeoTIFF has numbers of the EPSG only); empty without one.</summary>
    internal IEnumerable<(string Key, string Value)> Items => Name is { } name ? [("CRS", name)] : [];

    /// <summary>The system of a projection of a body's sphere.</summary>
    public static MapReference Of(GroundProjection projection, CelestialBody body)
    {
        (double latitude, double longitude) = (Degrees(projection.Latitude), Degrees(projection.Longitude));
        bool isOfIau = projection.Radius == OtherRadii.GetValueOrDefault(body.NaifNumber, body.MeanRadius);
        (_, _, _, int number, string? words) = isOfIau
            ? Numbered.FirstOrDefault(row => row.Kind == projection.Kind
                && (projection.IsInDegrees || (row.Latitude == latitude && row.Longitude == longitude)))
            : default;
        string globe = isOfIau ? $"{body.Name} (2015) - Sphere" : $"{body.Name} sphere";
        string geographic = isOfIau ? $"{globe} / Ocentric" : globe;
        string ofGlobe = Invariant(
            $"GEOGCS[\"{geographic}\",DATUM[\"{globe}\",SPHEROID[\"{globe}\",{projection.Radius:R},0]],"
                + $"PRIMEM[\"Reference Meridian\",0],UNIT[\"degree\",0.0174532925199433]]");
        string? name = words is null ? null : Invariant($"IAU_2015:{(100 * body.NaifNumber) + number}");
        if (projection.IsInDegrees)
        {
            return new MapReference(ofGlobe, name);
        }

        (string method, string parameters) = projection.Kind switch
        {
            MapKind.Equirectangular => ("Equirectangular", "PARAMETER[\"standard_parallel_1\",0]"),
            MapKind.PolarStereographic =>
                ("Polar_Stereographic", $"PARAMETER[\"latitude_of_origin\",{Text(latitude)}],PARAMETER[\"scale_factor\",1]"),
            _ => ("Orthographic", $"PARAMETER[\"latitude_of_origin\",{Text(latitude)}]"),
        };
        string title = words is null ? $"{geographic} / {method.Replace('_', ' ')}" : geographic + words;
        return new MapReference(
            $"PROJCS[\"{title}\",{ofGlobe},PROJECTION[\"{method}\"],{parameters},PARAMETER[\"central_meridian\",{Text(longitude)}],"
                + "PARAMETER[\"false_easting\",0],PARAMETER[\"false_northing\",0],UNIT[\"metre\",1]]",
            name);
    }

    /// <summary>Degrees of an angle that was given in degrees; the rounding of the radians is removed.</summary>
    private static double Degrees(double angle) => Math.Round(double.RadiansToDegrees(angle), 9);

    private static string Text(double number) => number.ToString("R", CultureInfo.InvariantCulture);
}
