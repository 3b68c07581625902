using System.Collections.Concurrent;
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

            // The old label goes first: it must never be beside the new image.
            File.Delete(label);
            File.Move(temporary, image, overwrite: true);
            AtomicFile.WriteText(label, writer => writeLabel(writer, extremes));
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

/// <summary>The image of a synthetic product that is being written, in blocks and by several threads.</summary>
/// <param name="file">Open for writing at any offset, with the length of the image and without samples yet.</param>
/// <param name="productId">The product, for messages.</param>
/// <param name="format">How samples are stored.</param>
internal sealed class SyntheticImageFile(SafeFileHandle file, string productId, SyntheticSampleFormat format, int lineSamples)
{
    private readonly Lock _gate = new();
    private double _minimum = double.PositiveInfinity;
    private double _maximum = double.NegativeInfinity;

    /// <summary>The minimum and the maximum sample so far, in the product's unit.</summary>
    public (double Minimum, double Maximum) Extremes => (_minimum, _maximum);

    /// <summary>Does the work of all blocks; each thread keeps the buffers of its worker.</summary>
    /// <param name="options">Number of threads, and what stops them between blocks.</param>
    /// <param name="startWorker">Makes a worker.</param>
    /// <exception cref="MsisfException">The first error of a block.</exception>
    /// <exception cref="ExternalPartException">The file system refuses.</exception>
    public void WriteBlocks<TWorker>(int blocks, ParallelOptions options, Func<TWorker> startWorker, Action<int, TWorker> write)
    {
        ConcurrentBag<TWorker> idle = [];
        try
        {
            Parallel.For(0, blocks, options, block =>
            {
                // Parallel.For starts a new task every now and then; buffers of this size must outlive it.
                TWorker worker = idle.TryTake(out TWorker? waiting) ? waiting : startWorker();
                write(block, worker);
                idle.Add(worker);
            });
        }
        catch (AggregateException exception) when (exception.InnerExceptions.OfType<MsisfException>().FirstOrDefault() is { } first)
        {
            throw first;
        }
        catch (AggregateException exception) when (exception.InnerExceptions.OfType<IOException>().FirstOrDefault() is { } first)
        {
            throw new ExternalPartException($"{productId}: can't be written: {first.Message}", first);
        }
    }

    /// <summary>Writes the rows of a block; rows of zeros are left to the file system, which need not store them.</summary>
    /// <param name="heights">m over the reference radius, line by line.</param>
    /// <param name="bytes">Room for a line of samples.</param>
    /// <param name="place">First line and sample in the image.</param>
    /// <param name="size">Lines, and samples of a line.</param>
    /// <param name="named">First line and sample as messages name them.</param>
    /// <exception cref="BadInputException">A height does not fit 16 bits.</exception>
    public void WriteRows(
        ReadOnlySpan<float> heights, Span<byte> bytes, (int Line, int Sample) place, (int Lines, int Samples) size,
        (int Line, int Sample) named)
    {
        double min = double.PositiveInfinity;
        double max = double.NegativeInfinity;
        Span<byte> row = bytes[..(format.SampleBytes * size.Samples)];
        for (int line = 0; line < size.Lines; line++)
        {
            (double minOfLine, double maxOfLine) = format.Encode(
                named.Line + line, named.Sample, heights.Slice(line * size.Samples, size.Samples), row);
            min = Math.Min(min, minOfLine);
            max = Math.Max(max, maxOfLine);
            if (row.ContainsAnyExcept((byte)0))
            {
                RandomAccess.Write(file, row, format.SampleBytes * (((long)(place.Line + line) * lineSamples) + place.Sample));
            }
        }

        Include(min, max);
    }

    /// <summary>Widens the range of the samples.</summary>
    public void Include(double minimum, double maximum)
    {
        lock (_gate)
        {
            _minimum = Math.Min(_minimum, minimum);
            _maximum = Math.Max(_maximum, maximum);
        }
    }
}
