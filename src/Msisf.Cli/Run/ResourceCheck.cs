using System.Globalization;
using Msisf.Cli.Options;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Metadata;
using Msisf.Core.Render;

namespace Msisf.Cli.Run;

/// <summary>Refuses pictures that this computer can't hold, before any work is done.</summary>
internal static class ResourceCheck
{
    /// <summary>POV-Ray 3.7 keeps a picture of up to this size in memory and the rest of a larger one in a file (Max_Image_Buffer_Memory).</summary>
    private const long PovRayImageBuffer = 128L << 20;

    /// <summary>Bytes that POV-Ray 3.7 keeps for a pixel: five floats.</summary>
    private const long PovRayBytesPerPixel = 20;

    /// <summary>Bytes that the native renderer keeps for a pixel: what it shows, its light and radiance, receivers of shadows, facets at worst.</summary>
    private const long NativeBytesPerPixel = 200;

    /// <summary>Bytes of a pixel that a layer's planes hold while it is written: three numbers.</summary>
    private const long LayerBytesPerPixel = 24;

    /// <summary>Bytes of a pixel of all layers on disk.</summary>
    private const long LayersBytesPerPixel = 160;

    /// <summary>Bytes of a pixel of the annotated picture: cairo's ARGB32, and the PNG beside it at worst.</summary>
    private const long AnnotationBytesPerPixel = 8;

    /// <summary>Bytes of a pixel on disk at worst: POV-Ray's buffer file, its PNG, and our copy.</summary>
    private const long DiskBytesPerPixel = PovRayBytesPerPixel + 3 + 3;

    /// <summary>Bytes of a grid point in the meta file: the text of one Pixel element on the reference sphere.</summary>
    private const long MetaBytesPerPoint = 240;

    /// <summary>The same on the terrain.</summary>
    private const long TerrainMetaBytesPerPoint = 1000;

    /// <summary>Checks one picture's size times the pictures made at once. The meta file is streamed: it needs disk, but no memory.</summary>
    /// <param name="settings">Size, grid and annotation of the pictures.</param>
    /// <param name="atOnce">Pictures made side by side.</param>
    /// <param name="memoryThere">Bytes of memory that can be used.</param>
    /// <param name="diskThere">Bytes that are free in the folder of the outputs.</param>
    /// <exception cref="BadInputException">Memory or disk do not suffice.</exception>
    public static void Check(RenderSettings settings, int atOnce, long memoryThere, long diskThere)
    {
        long pixels = (long)settings.Width * settings.Height;
        bool hasLayers = settings.Native.Layers is not null;
        long drawing = settings.Renderer == RendererKind.Native
            ? (NativeBytesPerPixel + (hasLayers ? LayerBytesPerPixel : 0)) * pixels
            : Math.Min(PovRayImageBuffer, PovRayBytesPerPixel * pixels);
        long memory = atOnce * (drawing + (settings.Annotate ? AnnotationBytesPerPixel * pixels : 0));
        Refuse(settings, "memory", "Use a smaller --width and --height, or fewer --jobs.", memory, memoryThere);
        PixelGrid grid = new(settings.Width, settings.Height, settings.GridHorizontal, settings.GridVertical);
        long metaBytesPerPoint = settings.Surface == PixelSurface.Terrain ? TerrainMetaBytesPerPoint : MetaBytesPerPoint;
        long disk = atOnce * (((DiskBytesPerPixel + (hasLayers ? LayersBytesPerPixel : 0)) * pixels) + (metaBytesPerPoint * grid.Columns * grid.Rows));
        Refuse(
            settings,
            $"free disk space in {settings.OutputFolder}",
            "Use a smaller --width and --height, a wider --grid, or another --output-dir.",
            disk,
            diskThere);
    }

    private static void Refuse(RenderSettings settings, string what, string remedy, long needed, long there)
    {
        if (needed > there)
        {
            throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"a picture of {settings.Width} x {settings.Height} px with its meta file needs {Size(needed)} of {what}, {Size(there)} are there. {remedy}"));
        }
    }

    private static string Size(long bytes) => bytes >= 1 << 20
        ? string.Create(CultureInfo.InvariantCulture, $"{bytes >> 20} MiB")
        : string.Create(CultureInfo.InvariantCulture, $"{bytes} bytes");
}
