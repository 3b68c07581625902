using System.Globalization;
using Msisf.Adapters.Interop;

namespace Msisf.Adapters.Terrain;

/// <summary>
/// Brings maps in other projections to one that is read: polar stereographic near a pole, else pixels of the whole Moon's grid. Values are
/// bilinear between pixels; where a pixel of the map is not surrounded by data there is none.
/// </summary>
internal static class GeoTiffWarp
{
    /// <summary>deg: maps whose middle lies farther from the equator become polar ones, as pixels of a degree are narrow there.</summary>
    private const double PolarFrom = 60.0;

    /// <summary>deg: what reaches around the Moon farther is no map of a place.</summary>
    private const double Widest = 180.0;

    /// <summary>px: width and height of an image that says where the map lies.</summary>
    private const int Rough = 64;

    /// <summary>Warps a map.</summary>
    /// <param name="map">The map.</param>
    /// <returns>The map in the other projection, to be closed before it; null if it is none of a place.</returns>
    public static GdalImage? Of(GdalImage map)
    {
        ProjText proj = new(map.Projection()!);
        string sphere = string.Create(CultureInfo.InvariantCulture, $"+R={proj.Radius!.Value:R}");
        string degrees = $"+proj=longlat {sphere}";

        // The scales: always between four pixels, as GDAL otherwise takes the mean of more where its pixels are a little larger.
        string[] always = ["-ot", "Float32", "-r", "bilinear", "-wo", "XSCALE=1", "-wo", "YSCALE=1", "-et", "0", "-dstnodata", "nan"];
        using GdalImage? extent = map.Warped([.. always, "-t_srs", degrees, "-ts", $"{Rough}", $"{Rough}"]);
        if (extent?.GeoTransform() is not [_, double across, _, double north, _, double down])
        {
            return null;
        }

        double middle = north + (0.5 * Rough * down);
        if (Math.Abs(middle) > PolarFrom)
        {
            return map.Warped([.. always, "-t_srs", $"+proj=stere +lat_0={(middle < 0.0 ? "-90" : "90")} {sphere}"]);
        }

        double height = Math.Abs(map.GeoTransform()![5]);
        double pixel = proj.Name == "longlat" ? height : double.RadiansToDegrees(height * proj.MetresPerUnit / proj.Radius.Value);
        if (across * Rough > Widest || !(pixel > 0.0))
        {
            return null;
        }

        string step = (1.0 / Math.Ceiling(1.0 / pixel)).ToString("R", CultureInfo.InvariantCulture);
        return map.Warped([.. always, "-t_srs", degrees, "-tr", step, step, "-tap"]);
    }
}
