using Msisf.Adapters.Layers;
using Msisf.App.Settings;
using Msisf.Core.Render;

namespace Msisf.App.Products;

/// <summary>Rejects images too large for this computer's memory, and runs too large for its disk, before any work is done.</summary>
internal static class ResourceCheck
{
    /// <summary>
    /// Maximum bytes of an image that POV-Ray 3.7 keeps in memory; it keeps the rest in a file (Max_Image_Buffer_Memory).
    /// </summary>
    private const long PovRayImageBuffer = 128L << 20;

    /// <summary>Bytes per pixel in POV-Ray 3.7: five floats.</summary>
    private const long PovRayBytesPerPixel = 20;

    /// <summary>Bytes of a POV-Ray process with a small scene, but for its image.</summary>
    private const long PovRaySmallScene = 256L << 20;

    /// <summary>
    /// Maximum bytes per pixel in the native renderer: the surface seen, light and radiance, shadow receivers, facets. With a shutter two
    /// frames are held: that of the frame's time, and another instant of the exposure.
    /// </summary>
    private const long NativeBytesPerPixel = 200;

    /// <summary>Strips of a scanned image in memory: those that are drawn and those whose ground truth is kept.</summary>
    private const long StripsKept = 16;

    /// <summary>
    /// Bytes per pixel of a detector: electrons, charge, throughput, radiance without the margin (doubles), fixed pattern (two floats),
    /// numbers, saturation, and the FITS file.
    /// </summary>
    private const long DetectorBytesPerPixel = 48;

    /// <summary>Maximum bytes per pixel on disk: POV-Ray's buffer file, its PNG, and the program's copy of that.</summary>
    private const long DiskBytesPerPixel = PovRayBytesPerPixel + 3 + 3;

    /// <summary>Maximum bytes per pixel on disk with the program's own renderer: a PNG of 16 bits, and its copy.</summary>
    private const long NativeDiskBytesPerPixel = 4;

    /// <summary>The number of frames to draw at once: as many as cores and memory allow, unless <c>--jobs</c> gives a number.</summary>
    /// <param name="settings">Settings of the run; the number given by <c>--jobs</c> is not checked here.</param>
    /// <param name="frames">Frames to make.</param>
    /// <param name="cores">Number of cores that may be used.</param>
    /// <param name="memoryThere">Bytes of memory that can be used.</param>
    public static int AtOnce(RenderSettings settings, int frames, int cores, long memoryThere)
    {
        long fitting = Math.Max(1, memoryThere / MemoryOfFrame(settings));
        return (int)Math.Clamp(settings.Jobs ?? Math.Min(cores, fitting), 1, Math.Max(1, frames));
    }

    /// <summary>
    /// The number of POV-Ray processes with small scenes to run at once: POV-Ray sleeps a third of its time with such scenes, so there are
    /// twice as many as large ones, unless memory is scarce or <c>--jobs</c> gives a number.
    /// </summary>
    /// <param name="atOnce">Number of processes with large scenes.</param>
    /// <param name="memoryThere">Bytes of memory that can be used.</param>
    /// <returns><paramref name="atOnce"/>, or a multiple of it.</returns>
    public static int SmallScenesAtOnce(RenderSettings settings, int atOnce, long memoryThere) =>
        settings.Jobs is null && 2 * atOnce * (MemoryOfFrame(settings) + PovRaySmallScene) <= memoryThere ? 2 * atOnce : atOnce;

    /// <summary>
    /// Checks the memory for the images that are made at once, and the disk space for the whole run. The meta file is streamed, so it needs
    /// disk space but no memory.
    /// </summary>
    /// <param name="cameras">Size, grid and annotation of the images of each camera, and how many of them are to make.</param>
    /// <param name="atOnce">Number of images made at once.</param>
    /// <param name="memoryThere">Bytes of memory that can be used.</param>
    /// <param name="diskThere">Bytes that are free in the folder of the outputs.</param>
    /// <exception cref="BadInputException">Memory or disk space is not sufficient.</exception>
    public static void Check(
        IReadOnlyList<(RenderSettings Settings, int Frames)> cameras, int atOnce, long memoryThere, long diskThere)
    {
        double series = 0.0;
        foreach ((RenderSettings settings, int frames) in cameras)
        {
            Refuse(
                settings, "memory", "Use a smaller --width and --height, or fewer --jobs.", atOnce * MemoryOfFrame(settings), memoryThere);
            (long drawing, double finished) = DiskOfFrame(settings);
            Refuse(
                settings,
                $"free disk space in {settings.OutputFolder}",
                "Use a smaller --width and --height, a wider --grid, or another --output-dir.",
                atOnce * drawing,
                diskThere);
            series += frames * finished;
        }

        int all = cameras.Sum(camera => camera.Frames);
        if (all > 1 && series > diskThere)
        {
            throw new BadInputException(Invariant(
                $"{all} frames will take about {Size((long)series)} in {cameras[0].Settings.OutputFolder}, {Size(diskThere)} are free. "
                    + $"Make room, use another --output-dir, or make a part with --frames."));
        }
    }

    /// <summary>Bytes of the files of a frame at most while it is made, and those of its finished files.</summary>
    private static (long Drawing, double Finished) DiskOfFrame(RenderSettings settings)
    {
        double finished = ProductTable.Of(settings).Sum(product => product.DiskBytes(settings));
        long drawing = settings.Renderer == RendererKind.Native ? NativeDiskBytesPerPixel : DiskBytesPerPixel;
        bool isCompressedOnDisk = IsStriped(settings) && settings.Native.LayersCompression == LayerCompression.Gzip;
        return (
            (drawing * Pixels(settings)) + (long)finished + (isCompressedOnDisk ? (long)ProductSizes.LayerBytes(settings) : 0), finished);
    }

    private static bool IsStriped(RenderSettings settings) => StripRules.IsStriped(settings.Scan, settings.Width, settings.Height);

    private static long Pixels(RenderSettings settings) => (long)settings.Width * settings.Height;

    private static long MemoryOfFrame(RenderSettings settings)
    {
        long pixels = IsStriped(settings) ? StripsKept * StripRules.PixelsOfStrip : Pixels(settings);
        long drawing = settings.Renderer == RendererKind.Native
            ? ((NativeBytesPerPixel * (settings.Shutter is null ? 1 : 2))
                + (settings.Native.Detector is null ? 0 : DetectorBytesPerPixel)) * pixels
            : Math.Min(PovRayImageBuffer, PovRayBytesPerPixel * pixels);
        return drawing + (ProductTable.Of(settings).Sum(product => product.MemoryBytesPerPixel) * pixels);
    }

    private static void Refuse(RenderSettings settings, string what, string remedy, long needed, long there)
    {
        if (needed > there)
        {
            throw new BadInputException(Invariant(
                $"an image of {settings.Width} x {settings.Height} px with its meta file needs {Size(needed)} of {what}, "
                    + $"{Size(there)} are there. {remedy}"));
        }
    }

    private static string Size(long bytes) => bytes >= 1 << 20
        ? Invariant($"{bytes >> 20} MiB")
        : Invariant($"{bytes} bytes");
}
