using Msisf.Adapters.Interop;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// Brings maps in other projections to one that is read: polar stereographic near a pole, else pixels of the whole Moon's grid. Values are
/// bilinear between pixels; where a pixel of the map is not surrounded by data there is none.
/// </summary>
internal static class GeoTiffWarp
{
    /// <summary>deg: maps whose middle lies farther from the equator become polar ones, as pixels of a degree are narrow there.</summary>
    private const double PolarFrom = 60.0;

    /// <summary>deg: what reaches around the Moon farther is cut somewhere, wherever the map begins.</summary>
    private const double Widest = 355.0;

    /// <summary>Relative: pixels whose width and height differ less are square.</summary>
    private const double SquarePixels = 1e-6;

    /// <summary>px/deg: from here on the resolution is a multiple of a power of two, to be halved for levels of detail.</summary>
    private const double FinestAnyNumber = 1024.0;

    /// <summary>px: width and height of an image that says where the map lies.</summary>
    private const int Rough = 64;

    /// <summary>Warps a map.</summary>
    /// <param name="path">The file, for messages.</param>
    /// <param name="gap">Arguments of gdalwarp that say which value means no data; empty if the file says it.</param>
    /// <returns>The map in the other projection, to be closed before it; null if GDAL can't bring it there.</returns>
    /// <exception cref="BadInputException">It goes all around the Moon.</exception>
    public static GdalImage? Of(string path, GdalImage map, string[] gap)
    {
        ProjText proj = new(map.Projection()!);
        double radius = proj.Radius!.Value;
        double metresPerDegree = double.DegreesToRadians(radius);
        string sphere = Invariant($"+R={radius:R}");

        // A map across the meridian at which one of them is cut is whole in the other.
        (string Projection, double Width, double Latitude)[] halves =
            [.. ((string[])["0", "180"]).Select(middle => Extent(map, $"+proj=eqc +lon_0={middle} {sphere}", metresPerDegree))];
        (string projection, double width, double latitude) = halves.MinBy(half => half.Width);
        if (double.IsPositiveInfinity(width))
        {
            return null;
        }

        // A map stays as fine as the finer sides of its pixels.
        double[] transform = map.GeoTransform()!;
        (double across, double down) = (Math.Abs(transform[1]), Math.Abs(transform[5]));
        bool isSquare = Math.Abs((across / down) - 1.0) <= SquarePixels;
        double side = isSquare ? down : Math.Min(across, down);
        double pixel = proj.Name == "longlat" ? side : side * proj.MetresPerUnit / metresPerDegree;
        if (!(pixel > 0.0))
        {
            return null;
        }

        if (Math.Abs(latitude) > PolarFrom)
        {
            string metres = (pixel * metresPerDegree).ToString("R", CultureInfo.InvariantCulture);
            string[] scale = isSquare ? [] : ["-tr", metres, metres];
            return map.Warped(
                [.. gap, .. scale, "-t_srs", $"+proj=stere +lat_0={(latitude < 0.0 ? "-90" : "90")} {sphere}"]);
        }

        if (width > Widest)
        {
            throw new BadInputException(
                $"{path}: goes around the Moon in a projection ({proj}) that is not read, and a warped map would be cut. Warp it to the "
                    + $"whole Moon's grid: gdalwarp -t_srs '+proj=longlat +R=1737400' -te 0 SOUTH 360 NORTH -tr D D, D being a whole part "
                    + $"of a degree.");
        }

        double resolution = Math.Ceiling(1.0 / pixel);
        resolution = resolution < FinestAnyNumber ? resolution : Math.Ceiling(resolution / StepOf(resolution)) * StepOf(resolution);
        string step = (metresPerDegree / resolution).ToString("R", CultureInfo.InvariantCulture);
        return map.Warped([.. gap, "-t_srs", projection, "-tr", step, step, "-tap"]);
    }

    /// <summary>The largest power of two by which a fine resolution can be made a multiple, at most a 64th finer.</summary>
    private static double StepOf(double resolution) => Math.ScaleB(1.0, Math.ILogB(resolution) - 6);

    /// <summary>Width and middle latitude of a map in degrees; infinitely wide if GDAL can't bring it there.</summary>
    private static (string Projection, double Width, double Latitude) Extent(GdalImage map, string projection, double metresPerDegree)
    {
        using GdalImage? extent = map.Warped(["-t_srs", projection, "-ts", $"{Rough}", $"{Rough}"]);
        return extent?.GeoTransform() is [_, double across, _, double north, _, double down]
            ? (projection, across * Rough / metresPerDegree, (north + (0.5 * Rough * down)) / metresPerDegree)
            : (projection, double.PositiveInfinity, 0.0);
    }
}
