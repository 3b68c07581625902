using System.Globalization;
using System.Text;
using Microsoft.Win32.SafeHandles;
using Msisf.Adapters.IO;
using Msisf.Adapters.Terrain;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Msisf.Synthesis;

namespace Msisf.Adapters.Synthesis;

/// <summary>
/// Writes a synthetic elevation model as an image and its label, block by block, so that memory does not grow with the model. The label is
/// written last: an image without a label is not a product.
/// </summary>
public static class SyntheticLdemWriter
{
    /// <summary>Computes and writes a model. The same options give the same bytes.</summary>
    /// <param name="options">What and where.</param>
    /// <param name="progress">Told the fraction done, 0 to 1, from any of the threads.</param>
    /// <param name="cancellation">Stops the work; nothing is left behind.</param>
    /// <returns>Path of the label; the image lies beside it.</returns>
    /// <exception cref="UsageException">The region is none.</exception>
    /// <exception cref="BadInputException">
    /// The resolution does not fit the base, a height does not fit 16 bits, or the name is that of a file that is not synthetic.
    /// </exception>
    /// <exception cref="ExternalPartException">The disk is too full, or refuses.</exception>
    public static string Write(SyntheticLdemOptions options, IProgress<double>? progress, CancellationToken cancellation)
    {
        if (!options.Region.IsValid)
        {
            throw new UsageException($"The region {options.Region} is none: {MoonRegion.ValidValues}.");
        }

        if (options.Rest == SyntheticRest.None && options.Region.CrossesPrimeMeridian)
        {
            throw new UsageException(
                "--rest none writes a part as NASA's products have them, which don't cross the prime meridian. Give --rest base or flat.");
        }

        SyntheticTerrain terrain = new(options.PixelsPerDegree, options.Seed, options.Base, cancellation);
        SyntheticLdemProduct product = new(options.PixelsPerDegree, options.Region, options.Rest, options.Format);
        string label = Path.Combine(options.OutputFolder, product.ProductId + ".LBL");
        string image = Path.Combine(options.OutputFolder, product.ProductId + ".IMG");
        string temporary = AtomicFile.TemporaryNameFor(image);
        try
        {
            Directory.CreateDirectory(options.OutputFolder);
            RequireSynthetic(label, image);
            DriveInfo disk = new(Path.GetFullPath(options.OutputFolder));
            RequireSpace(options.OutputFolder, product.StoredBytes, disk.AvailableFreeSpace);
            (double Minimum, double Maximum) extremes;
            using (SafeFileHandle file = File.OpenHandle(
                temporary, FileMode.CreateNew, FileAccess.Write, FileShare.None, FileOptions.None))
            {
                RandomAccess.SetLength(file, product.Bytes); // what is not written stays zero
                extremes = new SyntheticLdemImage(terrain, product, options.Threads).Write(file, progress, cancellation);
                RandomAccess.FlushToDisk(file);
            }

            // The old label goes first: it must never stand beside the new image.
            File.Delete(label);
            File.Move(temporary, image, overwrite: true);
            AtomicFile.Write(label, stream =>
            {
                using StreamWriter writer = new(stream, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false), leaveOpen: true);
                SyntheticLdemLabel.Write(writer, product, options, extremes.Minimum, extremes.Maximum);
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
            throw new ExternalPartException(string.Create(
                CultureInfo.InvariantCulture,
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
