using System.Globalization;
using Msisf.Core.Errors;

namespace Msisf.Cli.Run;

/// <summary>Refuses pictures that this computer can't hold, before any work is done.</summary>
internal static class ResourceCheck
{
    /// <summary>POV-Ray 3.7 keeps a picture of up to this size in memory and the rest of a larger one in a file (Max_Image_Buffer_Memory).</summary>
    private const long PovRayImageBuffer = 128L << 20;

    /// <summary>Bytes that POV-Ray 3.7 keeps for a pixel: five floats.</summary>
    private const long PovRayBytesPerPixel = 20;

    /// <summary>Bytes of a pixel of the annotated picture: cairo's ARGB32, and the PNG beside it at worst.</summary>
    private const long AnnotationBytesPerPixel = 8;

    /// <summary>Bytes of a pixel on disk at worst: POV-Ray's buffer file, its PNG, and our copy.</summary>
    private const long DiskBytesPerPixel = PovRayBytesPerPixel + 3 + 3;

    /// <summary>Checks one picture's size times the pictures made at once.</summary>
    /// <param name="width">px.</param>
    /// <param name="height">px.</param>
    /// <param name="annotate">With a second, annotated picture.</param>
    /// <param name="atOnce">Pictures made side by side.</param>
    /// <param name="outputFolder">Existing folder that takes the files.</param>
    /// <exception cref="BadInputException">Memory or disk do not suffice.</exception>
    public static void Check(int width, int height, bool annotate, int atOnce, string outputFolder)
    {
        long pixels = (long)width * height;
        long memory = atOnce * (Math.Min(PovRayImageBuffer, PovRayBytesPerPixel * pixels) + (annotate ? AnnotationBytesPerPixel * pixels : 0));
        long memoryThere = GC.GetGCMemoryInfo().TotalAvailableMemoryBytes;
        Refuse("memory", width, height, memory, memoryThere);
        long disk = atOnce * DiskBytesPerPixel * pixels;
        Refuse($"free disk space in {outputFolder}", width, height, disk, new DriveInfo(Path.GetFullPath(outputFolder)).AvailableFreeSpace);
    }

    private static string Size(long bytes) => bytes >= 1 << 20
        ? string.Create(CultureInfo.InvariantCulture, $"{bytes >> 20} MiB")
        : string.Create(CultureInfo.InvariantCulture, $"{bytes} bytes");

    private static void Refuse(string what, int width, int height, long needed, long there)
    {
        if (needed > there)
        {
            throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"a picture of {width} x {height} px needs {Size(needed)} of {what}, {Size(there)} are there. Use a smaller --width and --height, or fewer --jobs."));
        }
    }
}
