using Msisf.Adapters.Interop;
using Msisf.Adapters.Raster.Heights;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>
/// Brings images in other projections, such as ortho-images of a site, to latitude and longitude. Values are bilinear between pixels, and
/// pixels are nowhere larger than the image's own.
/// </summary>
internal static class MapWarp
{
    /// <summary>px: width and height of an image that says where the map lies.</summary>
    private const int Rough = 64;

    private static readonly string[] Bilinear =
        ["-ot", "Float32", "-r", "bilinear", "-wo", "XSCALE=1", "-wo", "YSCALE=1", "-et", "0", "-dstnodata", "nan"];

    /// <summary>Warps an image.</summary>
    /// <param name="path">The file, for messages.</param>
    /// <returns>
    /// The image in <c>+proj=eqc</c>, to be closed before the other; null if it has rows of latitude already, or does not say where it
    /// lies.
    /// </returns>
    /// <exception cref="BadInputException">It is not of the Moon, or GDAL can't bring it there.</exception>
    public static GdalImage? Of(string path, GdalImage image)
    {
        if (image.Projection() is not { } projection || image.GeoTransform() is not { } transform)
        {
            return null;
        }

        ProjText proj = new(projection);
        if (IsOfLatitude(proj) && transform is [_, > 0.0, 0.0, _, 0.0, < 0.0])
        {
            return null;
        }

        if (proj.Radius is not double radius || !GeoTiffPlacement.IsMoonRadius(radius))
        {
            throw new BadInputException(
                $"{path}: its coordinate system ({proj}) is not one on a sphere of the Moon (R = 1737400 m). Take a lunar map, or correct "
                    + $"it with gdal_translate -a_srs.");
        }

        double unit = proj.Name == "longlat" ? double.DegreesToRadians(radius) : proj.MetresPerUnit;
        double pixel = unit * Math.Sqrt(Math.Abs((transform[1] * transform[5]) - (transform[2] * transform[4])));
        Box? found = BoxAroundPole(proj, transform, image, radius)
            ?? ((double[])[0.0, 180.0]).Select(middle => BoxOf(image, middle, radius)).MinBy(box => box?.Right - box?.Left);
        if (found is not { } box || !(pixel > 0.0))
        {
            throw new BadInputException(
                $"{path}: GDAL can't bring its projection ({proj}) to latitude and longitude. Warp it with gdalwarp "
                    + $"-t_srs '+proj=longlat +R=1737400'.");
        }

        double nearest = box.Top * box.Bottom <= 0.0 ? 0.0 : Math.Min(Math.Abs(box.Top), Math.Abs(box.Bottom)) / radius;
        double width = Math.Ceiling((box.Right - box.Left) * Math.Cos(nearest) / pixel);
        double height = Math.Ceiling((box.Top - box.Bottom) / pixel);
        if (!(width * height <= int.MaxValue))
        {
            throw new BadInputException(
                $"{path}: has {width:F0} x {height:F0} pixels in latitude and longitude; maps of up to {int.MaxValue} pixels are read. "
                    + $"Give a coarser one.");
        }

        return image.Warped([.. Bilinear, .. box.Words(radius), "-ts", $"{Math.Max(width, 1.0):F0}", $"{Math.Max(height, 1.0):F0}"]);
    }

    /// <summary>Whether rows have one latitude each, and lie as <see cref="GdalMapSource"/> takes them to.</summary>
    private static bool IsOfLatitude(ProjText proj) => proj.Name == "longlat"
        || (proj.Name == "eqc" && ((string[])["lat_ts", "lat_0", "lon_0", "x_0", "y_0"]).All(name => (proj.Number(name) ?? 0.0) == 0.0));

    /// <summary>The box of a polar stereographic image that holds its pole: all longitudes, down to its farthest corner.</summary>
    private static Box? BoxAroundPole(ProjText proj, double[] transform, GdalImage image, double radius)
    {
        if (proj.Name != "stere" || Math.Abs(proj.Number("lat_0") ?? 0.0) != 90.0 || transform is not [_, _, 0.0, _, 0.0, _])
        {
            return null;
        }

        double unit = proj.MetresPerUnit;
        (double left, double right) = (transform[0] * unit, (transform[0] + (image.Width * transform[1])) * unit);
        (double top, double bottom) = (transform[3] * unit, (transform[3] + (image.Height * transform[5])) * unit);
        (double poleX, double poleY) = (proj.Number("x_0") ?? 0.0, proj.Number("y_0") ?? 0.0);
        if ((left - poleX) * (right - poleX) > 0.0 || (top - poleY) * (bottom - poleY) > 0.0)
        {
            return null;
        }

        // A map that is true to scale elsewhere than at the pole is smaller, so this holds it too.
        double reach = double.Hypot(
            Math.Max(Math.Abs(left - poleX), Math.Abs(right - poleX)), Math.Max(Math.Abs(top - poleY), Math.Abs(bottom - poleY)));
        double smallest = proj.Number("k") ?? proj.Number("k_0") ?? 0.5;
        double latitude = (0.5 * Math.PI) - (2.0 * Math.Atan(0.5 * reach / radius / Math.Min(smallest, 1.0)));
        (double half, double pole) = (Math.PI * radius, 0.5 * Math.PI * radius);
        return proj.Number("lat_0") > 0.0
            ? new Box(0.0, -half, half, pole, latitude * radius)
            : new Box(0.0, -half, half, -latitude * radius, -pole);
    }

    private static Box? BoxOf(GdalImage image, double middle, double radius)
    {
        Box nowhere = new(middle, 0.0, 0.0, 0.0, 0.0);
        using GdalImage? rough = image.Warped([.. Bilinear, .. nowhere.Projection(radius), "-ts", $"{Rough}", $"{Rough}"]);
        double pole = 0.5 * Math.PI * radius;
        return rough?.GeoTransform() is [var left, var across, _, var top, _, var down]
            ? new Box(middle, left, left + (Rough * across), Math.Min(top, pole), Math.Max(top + (Rough * down), -pole))
            : null;
    }

    /// <summary>Bounds of a map in <c>+proj=eqc</c>, m.</summary>
    private readonly record struct Box(double Middle, double Left, double Right, double Top, double Bottom)
    {
        public string[] Projection(double radius) =>
            ["-t_srs", string.Create(CultureInfo.InvariantCulture, $"+proj=eqc +lon_0={Middle:R} +R={radius:R}")];

        public string[] Words(double radius) =>
        [
            .. Projection(radius), "-te", .. ((double[])[Left, Bottom, Right, Top]).Select(
                number => number.ToString("R", CultureInfo.InvariantCulture)),
        ];
    }
}
