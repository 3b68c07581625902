using Msisf.Adapters.Interop;
using Msisf.Core.Ephemeris;
using Msisf.Core.Maps;

namespace Msisf.Adapters.Maps;

/// <summary>
/// The world coordinates of a map in FITS: M. Calabretta and E. Greisen, Astron. Astrophys. 395 (2002) 1077; C. Marmo et al., Earth Space
/// Sci. 5 (2018) 640, for bodies other than the sky.
/// </summary>
internal static class MapWcs
{
    /// <summary>Adds the keywords to an image whose first row is the map's top.</summary>
    public static void Put(FitsUnit image, MapGrid grid, CelestialBody body)
    {
        GroundProjection map = grid.Projection;
        (string projection, double latitude, double longitude) = map.Kind switch
        {
            MapKind.LongitudeLatitude => ("CAR", 0.0, double.RadiansToDegrees(map.Longitude)),
            MapKind.PolarStereographic => ("STG", double.RadiansToDegrees(map.Latitude), 0.0),
            _ => throw new NotSupportedException($"FITS files have no {map.Kind}."),
        };
        double degrees = map.IsInDegrees ? 1.0 : double.RadiansToDegrees(1.0 / map.Radius);
        string prefix = PrefixOf(body);
        image.Put("WCSAXES", 2, "number of axes");
        image.Put("WCSNAME", "planetocentric", "longitude to the east");
        image.Put("CTYPE1", $"{prefix}LN-{projection}", "longitude");
        image.Put("CTYPE2", $"{prefix}LT-{projection}", "latitude");
        image.Put("CUNIT1", "deg", string.Empty);
        image.Put("CUNIT2", "deg", string.Empty);
        image.Put("CRPIX1", 0.5 + (((map.IsInDegrees ? longitude : 0.0) - grid.Left) / grid.CellWidth), "reference pixel");
        image.Put("CRPIX2", 0.5 + (grid.Top / grid.CellHeight), string.Empty);
        image.Put("CRVAL1", longitude, "[deg] its longitude");
        image.Put("CRVAL2", latitude, "[deg] its latitude");
        image.Put("CDELT1", degrees * grid.CellWidth, "[deg] a pixel, there");
        image.Put("CDELT2", -degrees * grid.CellHeight, string.Empty);
        if (map.Kind == MapKind.PolarStereographic)
        {
            image.Put("LONPOLE", 180.0, "[deg] so that longitude 0 is as on maps");
        }

        image.Put("A_RADIUS", map.Radius, "[m] of the sphere");
        image.Put("B_RADIUS", map.Radius, string.Empty);
        image.Put("C_RADIUS", map.Radius, string.Empty);
    }

    /// <summary>The first two letters of the body's name, as GDAL writes them for planets; those of the Moon are of Selene.</summary>
    private static string PrefixOf(CelestialBody body) => body.IsMoon ? "SE" : body.CapitalName[..2];
}
