using Msisf.Core.Maps;
using Msisf.Core.Metadata;

namespace Msisf.Adapters.Maps;

/// <summary>Says in the words of the OGC (WKT, version 1) how a map lies on a body.</summary>
internal static class MapReference
{
    /// <summary>The text.</summary>
    public static string WktOf(ImageMapProjection projection, DrawnGlobe globe)
    {
        string body = globe.Body.IsMoon ? "Moon_2000" : $"{globe.Body.Name}_sphere";
        string latitude = Degrees(projection.Latitude);
        (string name, string method, string parameters) = projection.Kind switch
        {
            MapKind.Equirectangular =>
                ("equirectangular", "Equirectangular", "PARAMETER[\"latitude_of_origin\",0],PARAMETER[\"standard_parallel_1\",0]"),
            MapKind.PolarStereographic =>
                ("polar stereographic", "Polar_Stereographic",
                    $"PARAMETER[\"latitude_of_origin\",{latitude}],PARAMETER[\"scale_factor\",1]"),
            _ => ("orthographic", "Orthographic", $"PARAMETER[\"latitude_of_origin\",{latitude}]"),
        };
        return Invariant(
            $"PROJCS[\"{globe.Body.Name} {name}\",GEOGCS[\"GCS_{body}\",DATUM[\"D_{body}\","
                + $"SPHEROID[\"{body}\",{globe.ReferenceRadius:R},0]],PRIMEM[\"Reference_Meridian\",0],"
                + $"UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"{method}\"],{parameters},"
                + $"PARAMETER[\"central_meridian\",{Degrees(projection.Longitude)}],PARAMETER[\"false_easting\",0],"
                + $"PARAMETER[\"false_northing\",0],UNIT[\"metre\",1]]");
    }

    private static string Degrees(double angle) =>
        Math.Round(double.RadiansToDegrees(angle), 9).ToString("R", CultureInfo.InvariantCulture);
}
