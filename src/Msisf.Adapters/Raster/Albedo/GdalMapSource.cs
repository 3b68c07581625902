using Msisf.Adapters.Interop;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>A map in an image file that GDAL reads: TIFF, JPEG, PNG and others. Of a colour image the red channel counts.</summary>
internal sealed class GdalMapSource : MapSource
{
    /// <summary>1: how far the width in map units may differ from a turn for its unit to be known.</summary>
    private const double UnitTolerance = 1e-3;

    private readonly GdalImage _image;

    /// <inheritdoc cref="GdalImage.Open"/>
    public GdalMapSource(string path, string? libraryPath)
    {
        _image = GdalImage.Open(path, libraryPath);
        Extent = ExtentOf(_image);
    }

    /// <inheritdoc/>
    public override int Width => _image.Width;

    /// <inheritdoc/>
    public override int Height => _image.Height;

    /// <inheritdoc/>
    public override MapExtent? Extent { get; }

    /// <inheritdoc/>
    public override bool IsBytes => _image.IsBytes;

    /// <inheritdoc/>
    public override void Read(int first, int count, Span<float> values)
    {
        _image.Read(first, count, values);
        if (_image.NoData is double noData)
        {
            values[..(count * Width)].Replace((float)noData, float.NaN);
        }
    }

    /// <inheritdoc/>
    public override void Dispose() => _image.Dispose();

    /// <summary>The extent of an image whose map coordinates are degrees, or metres on the reference sphere.</summary>
    private static MapExtent? ExtentOf(GdalImage image)
    {
        if (image.GeoTransform() is not [double left, > 0.0 and double across, 0.0, double top, 0.0, < 0.0 and double down])
        {
            return null;
        }

        double turns = Math.Max(image.Width * across, image.Height * -down * 2.0);
        double perUnit = turns <= 360.0 * (1.0 + UnitTolerance) ? Math.PI / 180.0 : 1.0 / MoonConstants.ReferenceRadius;
        MapExtent extent = new(left * perUnit, top * perUnit, image.Width * across * perUnit, image.Height * -down * perUnit);
        return extent.Width <= 2.0 * Math.PI * (1.0 + UnitTolerance) && extent.Height <= Math.PI * (1.0 + UnitTolerance) ? extent : null;
    }
}
