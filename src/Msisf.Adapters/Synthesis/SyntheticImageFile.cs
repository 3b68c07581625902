using System.Collections.Concurrent;
using Microsoft.Win32.SafeHandles;

namespace Msisf.Adapters.Synthesis;

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
