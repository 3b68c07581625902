using Msisf.Adapters.Interop;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>A map in an image file that GDAL reads: TIFF, JPEG, PNG and others. Of a colour image the red channel counts.</summary>
internal sealed class GdalMapSource(GdalImage image) : MapSource(image.Width, image.Height, ExtentOf(image), image.IsBytes)
{
    /// <summary>1: how far the width in map units may differ from a turn for its unit to be known.</summary>
    private const double UnitTolerance = 1e-3;

    /// <inheritdoc/>
    public override void Read(int first, int count, Span<float> values) => image.Read(first, count, 0, Width, values);

    /// <inheritdoc/>
    public override void Dispose() => image.Dispose();

    /// <summary>The extent of an image whose map coordinates are degrees, or metres on the reference sphere.</summary>
    private static MapExtent? ExtentOf(GdalImage image)
    {
        if (image.GeoTransform() is not [double left, > 0.0 and double across, 0.0, double top, 0.0, < 0.0 and double down])
        {
            return null;
        }

        (double width, double height) = (image.Width * across, image.Height * -down);
        double perUnit = Math.Max(width, height * 2.0) <= 360.0 * (1.0 + UnitTolerance)
            ? Math.PI / 180.0
            : 1.0 / MoonConstants.ReferenceRadius;
        MapExtent extent = new(left * perUnit, top * perUnit, width * perUnit, height * perUnit);
        return extent.Width <= 2.0 * Math.PI * (1.0 + UnitTolerance) && extent.Height <= Math.PI * (1.0 + UnitTolerance) ? extent : null;
    }
}
