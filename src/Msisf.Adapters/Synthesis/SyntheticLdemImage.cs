using System.Buffers.Binary;
using System.Collections.Concurrent;
using System.Globalization;
using Microsoft.Win32.SafeHandles;
using Msisf.Core.Errors;
using Msisf.Synthesis;

namespace Msisf.Adapters.Synthesis;

/// <summary>Computes the image of a synthetic product on several threads and writes each block to its place.</summary>
internal sealed class SyntheticLdemImage
{
    private const double ScalingFactor = 0.5; // m a unit, as in the archive
    private const int SampleBytes = 2;
    private const long LargestMemory = 220_000_000; // bytes of all threads' blocks: many cores do not mean much memory

    private readonly SyntheticTerrain _terrain;
    private readonly SyntheticLdemProduct _product;
    private readonly int _threads;
    private readonly Lock _gate = new();
    private short _minimum = short.MaxValue;
    private short _maximum = short.MinValue;
    private long _samplesDone;

    /// <summary>An image to write.</summary>
    /// <param name="terrain">The model.</param>
    /// <param name="product">The part of it.</param>
    /// <param name="threads">At least 1.</param>
    public SyntheticLdemImage(SyntheticTerrain terrain, SyntheticLdemProduct product, int threads)
    {
        _terrain = terrain;
        _product = product;
        _threads = Math.Max(1, threads);
    }

    /// <summary>Writes all samples.</summary>
    /// <param name="file">Open for writing at any offset.</param>
    /// <param name="progress">Told the fraction done.</param>
    /// <param name="cancellation">Stops between blocks.</param>
    /// <returns>The minimum and the maximum sample.</returns>
    /// <exception cref="BadInputException">A height does not fit 16 bits.</exception>
    public (short Minimum, short Maximum) Write(SafeFileHandle file, IProgress<double>? progress, CancellationToken cancellation)
    {
        TileSynthesizer typical = new(_terrain);
        int side = typical.PreferredSide;
        int fitting = (int)Math.Clamp(LargestMemory / typical.PreferredBytes, 1, _threads);
        int blocksAcross = (_product.LineSamples + side - 1) / side;
        int blocksDown = (_product.Lines + side - 1) / side;
        ConcurrentBag<Worker> idle = [];
        ParallelOptions options = new() { MaxDegreeOfParallelism = fitting, CancellationToken = cancellation };
        try
        {
            Parallel.For(
                0,
                blocksAcross * blocksDown,
                options,
                block =>
                {
                    // Parallel.For starts a new task every now and then; buffers of this size must outlive it.
                    if (!idle.TryTake(out Worker? worker))
                    {
                        worker = new Worker(new TileSynthesizer(_terrain), new float[side * side], new byte[SampleBytes * side]);
                    }

                    WriteBlock(file, worker, block / blocksAcross * side, block % blocksAcross * side, side);
                    Report(progress, block / blocksAcross * side, block % blocksAcross * side, side);
                    idle.Add(worker);
                });
        }
        catch (AggregateException exception) when (exception.InnerExceptions.OfType<MsisfException>().FirstOrDefault() is { } first)
        {
            throw first;
        }
        catch (AggregateException exception) when (exception.InnerExceptions.OfType<IOException>().FirstOrDefault() is { } first)
        {
            throw new ExternalPartException($"{_product.ProductId}: can't be written: {first.Message}", first);
        }

        return (_minimum, _maximum);
    }

    private void WriteBlock(SafeFileHandle file, Worker worker, int line0, int sample0, int side)
    {
        int lines = Math.Min(side, _product.Lines - line0);
        int samples = Math.Min(side, _product.LineSamples - sample0);
        int moonLine = line0 + ((90 - _product.Region.NorthDegrees) * _product.PixelsPerDegree);
        int moonSample = sample0 + (_product.Region.WestDegrees * _product.PixelsPerDegree);
        worker.Synthesizer.Synthesize(moonLine, lines, moonSample, samples, worker.Heights);
        short min = short.MaxValue;
        short max = short.MinValue;
        Span<byte> bytes = worker.Bytes.AsSpan(0, SampleBytes * samples);
        for (int line = 0; line < lines; line++)
        {
            ReadOnlySpan<float> row = worker.Heights.AsSpan(line * samples, samples);
            for (int sample = 0; sample < samples; sample++)
            {
                double units = Math.Round(row[sample] / ScalingFactor);
                if (!(units >= short.MinValue && units <= short.MaxValue))
                {
                    throw new BadInputException(string.Create(
                        CultureInfo.InvariantCulture,
                        $"Line {moonLine + line}, sample {moonSample + sample}: the height {row[sample]} m does not fit 16 bits of 0.5 m. "
                            + $"Take another seed or base."));
                }

                short value = (short)units;
                min = Math.Min(min, value);
                max = Math.Max(max, value);
                BinaryPrimitives.WriteInt16LittleEndian(bytes[(SampleBytes * sample)..], value);
            }

            RandomAccess.Write(file, bytes, SampleBytes * (((long)(line0 + line) * _product.LineSamples) + sample0));
        }

        lock (_gate)
        {
            _minimum = Math.Min(_minimum, min);
            _maximum = Math.Max(_maximum, max);
        }
    }

    private void Report(IProgress<double>? progress, int line0, int sample0, int side)
    {
        long block = (long)Math.Min(side, _product.Lines - line0) * Math.Min(side, _product.LineSamples - sample0);
        double fraction = (double)Interlocked.Add(ref _samplesDone, block) / ((long)_product.Lines * _product.LineSamples);
        progress?.Report(fraction);
    }

    private sealed record Worker(TileSynthesizer Synthesizer, float[] Heights, byte[] Bytes);
}
