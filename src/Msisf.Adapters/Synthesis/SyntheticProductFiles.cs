using System.Text;
using Microsoft.Win32.SafeHandles;
using Msisf.Adapters.IO;
using Msisf.Adapters.Raster.Heights;

namespace Msisf.Adapters.Synthesis;

/// <summary>
/// Writes the two files of a synthetic product. The label is written last: an image without a label is not a product.
/// </summary>
internal static class SyntheticProductFiles
{
    /// <summary>Writes image and label; if that fails, nothing is left behind.</summary>
    /// <param name="folder">Made if it is missing.</param>
    /// <param name="productId">Name of both files.</param>
    /// <param name="bytes">Length of the image.</param>
    /// <param name="storedBytes">Bytes of it that take room on the disk.</param>
    /// <param name="writeImage">Writes the samples that are not 0; returns the minimum and maximum sample.</param>
    /// <returns>Path of the label.</returns>
    /// <exception cref="BadInputException">The name is that of a file that is not synthetic.</exception>
    /// <exception cref="ExternalPartException">The disk is too full, or refuses.</exception>
    public static string Write(
        string folder,
        string productId,
        long bytes,
        long storedBytes,
        Func<SafeFileHandle, (double Minimum, double Maximum)> writeImage,
        Action<TextWriter, (double Minimum, double Maximum)> writeLabel)
    {
        string label = Path.Combine(folder, productId + ".LBL");
        string image = Path.Combine(folder, productId + ".IMG");
        string temporary = AtomicFile.TemporaryNameFor(image);
        try
        {
            Directory.CreateDirectory(folder);
            RequireSynthetic(label, image);
            DriveInfo disk = new(Path.GetFullPath(folder));
            RequireSpace(folder, storedBytes, disk.AvailableFreeSpace);
            (double Minimum, double Maximum) extremes;
            using (SafeFileHandle file = File.OpenHandle(
                temporary, FileMode.CreateNew, FileAccess.Write, FileShare.None, FileOptions.None))
            {
                RandomAccess.SetLength(file, bytes); // what is not written stays zero
                extremes = writeImage(file);
                RandomAccess.FlushToDisk(file);
            }

            // The old label goes first: it must never stand beside the new image.
            File.Delete(label);
            File.Move(temporary, image, overwrite: true);
            AtomicFile.Write(label, stream =>
            {
                using StreamWriter writer = new(stream, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false), leaveOpen: true);
                writeLabel(writer, extremes);
            });
            return label;
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            throw new ExternalPartException($"{image}: can't be written: {exception.Message}", exception);
        }
        finally
        {
            // Not of a folder that could not be made: deleting there throws.
            if (File.Exists(temporary))
            {
                File.Delete(temporary);
            }
        }
    }

    /// <summary>Refuses to begin what the disk can't hold.</summary>
    /// <param name="folder">Where, for the message.</param>
    /// <param name="needed">Bytes of the image.</param>
    /// <param name="free">Bytes that the disk has left.</param>
    /// <exception cref="ExternalPartException">There is too little.</exception>
    internal static void RequireSpace(string folder, long needed, long free)
    {
        const double Megabyte = 1e6;
        const long ForTheLabel = 65536;
        if (free < needed + ForTheLabel)
        {
            throw new ExternalPartException(Invariant(
                $"{folder}: the model needs {needed / Megabyte:0.0} MB and the disk has {free / Megabyte:0.0} MB free. "
                    + $"Make room, take another folder, or a --region with --rest flat."));
        }
    }

    private static void RequireSynthetic(string label, string image)
    {
        bool replaceable = File.Exists(label)
            ? File.ReadLines(label).Any(
                line => line.StartsWith("DATA_SET_ID", StringComparison.Ordinal)
                    && line.Contains(LdemLabel.SyntheticMark, StringComparison.Ordinal))
            : !File.Exists(image);
        if (!replaceable)
        {
            throw new BadInputException(
                $"{label}: the files of that name are not a synthetic product; they stay as they are. Move them, or take another folder.");
        }
    }
}
