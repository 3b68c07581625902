using Msisf.Adapters.Interop;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>A map in an image file that GDAL reads: TIFF, JPEG, PNG and others. Of a colour image the red channel counts.</summary>
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
    /// <exception cref="Core.Errors.MsisfException">GDAL is missing, or the file is no image or not of the Moon.</exception>
    public static GdalMapSource Open(string path, string? libraryPath)
    {
        GdalImage file = GdalImage.Open(path, libraryPath);
        try
        {
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

    /// <summary>The extent of an image whose map coordinates are degrees, or metres on the reference sphere.</summary>
    private static MapExtent? ExtentOf(GdalImage image)
    {
        if (image.GeoTransform() is not [double left, > 0.0 and double across, 0.0, double top, 0.0, < 0.0 and double down])
        {
            return null;
        }

        (double width, double height) = (image.Width * across, image.Height * -down);
        ProjText? proj = image.Projection() is { } projection ? new ProjText(projection) : null;
        bool isDegrees = proj is null ? Math.Max(width, height * 2.0) <= 360.0 * (1.0 + UnitTolerance) : proj.Name == "longlat";
        double perUnit = isDegrees ? Math.PI / 180.0 : 1.0 / (proj?.Radius ?? MoonConstants.ReferenceRadius);
        double west = (left * perUnit) + double.DegreesToRadians(isDegrees ? 0.0 : proj?.Number("lon_0") ?? 0.0);
        MapExtent extent = new(west, top * perUnit, width * perUnit, height * perUnit);
        return extent.Width <= 2.0 * Math.PI * (1.0 + UnitTolerance) && extent.Height <= Math.PI * (1.0 + UnitTolerance) ? extent : null;
    }
}
