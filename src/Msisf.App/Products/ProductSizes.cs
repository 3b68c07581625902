using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Layers;
using Msisf.Core.Metadata;

namespace Msisf.App.Products;

/// <summary>How large products are, on disk and in memory.</summary>
internal static class ProductSizes
{
    /// <summary>
    /// Typical bytes per pixel in the PNG of an image of the Moon: 0.12 to 0.31 in the README's images; an annotated image doubles it.
    /// </summary>
    private const double PngBytes = 0.3;

    /// <summary>Bytes per pixel on disk of a detector's image: noise is not compressed; the same of its numbers as FITS.</summary>
    public const double NumberBytes = 2.0;

    /// <summary>The same of a cube.</summary>
    public const double CubeBytes = 4.0;

    /// <summary>Bytes per pixel of the annotated image in memory: four bytes, and the PNG at its largest.</summary>
    public const long AnnotationMemory = 8;

    /// <summary>Bytes per pixel in memory while a layer is written: three numbers.</summary>
    public const long LayerMemory = 24;

    /// <summary>Bytes per grid point in the meta file: the text of one Pixel element on the reference sphere.</summary>
    private const double PointBytes = 240.0;

    /// <summary>The same on the terrain.</summary>
    private const double TerrainPointBytes = 1000.0;

    /// <summary>Bytes of the layers of a frame.</summary>
    public static double LayerBytes(RenderSettings settings) => PixelsOf(settings) * (settings.Native.Layers?.Layers.Sum(
        layer => layer.Planes * layer.StoredType(settings.Native.LayersPrecision).Size()) ?? 0.0);

    /// <summary>Bytes of layers of derivatives or bounds.</summary>
    /// <param name="count">How many layers.</param>
    public static double LayerBytes(RenderSettings settings, int count) =>
        PixelsOf(settings) * count * (settings.Native.LayersPrecision == LayerPrecision.Real32 ? sizeof(float) : sizeof(double));

    /// <summary>px of an image.</summary>
    public static double PixelsOf(RenderSettings settings) => (double)settings.Width * settings.Height;

    /// <summary>Bytes of a pixel in the PNG.</summary>
    public static double PngOf(RenderSettings settings) => PngBytes * settings.Native.BitDepth / 8.0;

    /// <summary>Bytes of the meta file.</summary>
    public static double MetaBytes(RenderSettings settings)
    {
        PixelGrid grid = new(settings.Width, settings.Height, settings.GridHorizontal, settings.GridVertical);
        return (settings.Surface == PixelSurface.Terrain ? TerrainPointBytes : PointBytes) * grid.Columns * grid.Rows;
    }
}
