using Msisf.Adapters.Interop;
using Msisf.Adapters.Raster.Pds;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>A map in an image file that GDAL reads: TIFF, JPEG, PNG and others. The red channel of a colour image counts.</summary>
internal sealed class GdalMapSource : MapSource
{
    /// <summary>1: how far the width in map units may differ from a turn for its unit to be known.</summary>
    private const double UnitTolerance = 1e-3;

    private readonly GdalImage _file;
    private readonly GdalImage _image;

    private GdalMapSource(GdalImage file, GdalImage image)
        : base(image.Width, image.Height, ExtentOf(image), image.IsBytes && image.Scale == (1.0, 0.0)) => (_file, _image) = (file, image);

    /// <summary>Opens an image, which is warped if it has a projection that does not run in rows of latitude.</summary>
    /// <param name="libraryPath">MSISF_GDAL, or null.</param>
    /// <exception cref="Core.Errors.MsisfException">GDAL is missing, or the file is not an image or not of the Moon.</exception>
    public static GdalMapSource Open(string path, string? libraryPath)
    {
        GdalImage file = GdalImage.Open(path, libraryPath);
        try
        {
            if (file.Driver == "PDS")
            {
                PdsLongitudes.RequireGdals(path);
            }

            return new GdalMapSource(file, MapWarp.Of(path, file) ?? file);
        }
        catch
        {
            file.Dispose();
            throw;
        }
    }

    /// <inheritdoc/>
    /// <remarks>With the factor and the offset that the file has for its numbers.</remarks>
    public override void Read(int first, int count, Span<float> values)
    {
        _image.Read(first, count, 0, Width, values);
        (double factor, double offset) = _image.Scale;
        for (int i = 0; (factor, offset) != (1.0, 0.0) && i < count * Width; i++)
        {
            values[i] = (float)((values[i] * factor) + offset);
        }
    }

    /// <inheritdoc/>
    public override void Dispose()
    {
        if (!ReferenceEquals(_image, _file))
        {
            _image.Dispose();
        }

        _file.Dispose();
    }

    /// <summary>The extent of an image whose map coordinates are degrees, or lengths on the reference sphere.</summary>
    private static MapExtent? ExtentOf(GdalImage image)
    {
        if (image.GeoTransform() is not [double left, > 0.0 and double across, 0.0, double top, 0.0, < 0.0 and double down])
        {
            return null;
        }

        (double width, double height) = (image.Width * across, image.Height * -down);
        ProjText? proj = image.Projection() is { } projection ? new ProjText(projection) : null;
        bool isDegrees = proj is null ? Math.Max(width, height * 2.0) <= 360.0 * (1.0 + UnitTolerance) : proj.Name == "longlat";
        double perUnit = isDegrees ? Math.PI / 180.0 : (proj?.MetresPerUnit ?? 1.0) / (proj?.Radius ?? MoonConstants.ReferenceRadius);
        double west = (left * perUnit) + double.DegreesToRadians(proj?.MiddleLongitude ?? 0.0);
        MapExtent extent = new(west, top * perUnit, width * perUnit, height * perUnit);
        return extent.Width <= 2.0 * Math.PI * (1.0 + UnitTolerance) && extent.Height <= Math.PI * (1.0 + UnitTolerance) ? extent : null;
    }
}

/// <summary>
/// Brings images in other projections, such as ortho-images of a site, to latitude and longitude. Values are bilinear between pixels, and
/// pixels are nowhere larger than the image's own.
/// </summary>
internal static class MapWarp
{
    /// <summary>px: width and height of an image that says where the map lies.</summary>
    private const int Rough = 64;

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
        if (proj.Unread is { } unread)
        {
            throw new BadInputException(
                $"{path}: its coordinate system has {unread}, which is not read. If it means nothing for this map, write it anew without: "
                    + $"gdal_translate -a_srs '{proj.WithoutUnread}'.");
        }

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
                $"{path}: its pixels ({proj}) lie nowhere on the Moon. Say where they lie: gdal_translate -a_srs PROJECTION -a_ullr "
                    + "LEFT TOP RIGHT BOTTOM.");
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

        return image.Warped([.. box.Words(radius), "-ts", $"{Math.Max(width, 1.0):F0}", $"{Math.Max(height, 1.0):F0}"]);
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
        using GdalImage? rough = image.Warped([.. nowhere.Projection(radius), "-ts", $"{Rough}", $"{Rough}"]);
        double pole = 0.5 * Math.PI * radius;
        return rough?.GeoTransform() is [var left, var across, _, var top, _, var down]
            ? new Box(middle, left, left + (Rough * across), Math.Min(top, pole), Math.Max(top + (Rough * down), -pole))
            : null;
    }

    /// <summary>Bounds of a map in <c>+proj=eqc</c>, m.</summary>
    private readonly record struct Box(double Middle, double Left, double Right, double Top, double Bottom)
    {
        public string[] Projection(double radius) =>
            ["-t_srs", Invariant($"+proj=eqc +lon_0={Middle:R} +R={radius:R}")];

        public string[] Words(double radius) =>
        [
            .. Projection(radius), "-te", .. ((double[])[Left, Bottom, Right, Top]).Select(
                number => number.ToString("R", CultureInfo.InvariantCulture)),
        ];
    }
}
