using System.Collections.Concurrent;
using Microsoft.Win32.SafeHandles;
using Msisf.Core.Errors;
using Msisf.Synthesis;

namespace Msisf.Adapters.Synthesis;

/// <summary>Computes the image of a synthetic polar map on several threads and writes each block to its place.</summary>
/// <param name="terrain">The ground.</param>
/// <param name="options">The map.</param>
internal sealed class SyntheticMapImage(SyntheticTerrain terrain, SyntheticMapOptions options)
{
    private const int BlockSide = 512;

    private readonly Lock _gate = new();
    private double _minimum = double.PositiveInfinity;
    private double _maximum = double.NegativeInfinity;
    private int _blocksDone;

    /// <summary>Writes all samples.</summary>
    /// <param name="file">Open for writing at any offset, with the length of the image.</param>
    /// <param name="progress">Told the fraction done.</param>
    /// <param name="cancellation">Stops between blocks.</param>
    /// <returns>The minimum and the maximum sample, in the product's unit.</returns>
    /// <exception cref="BadInputException">A height does not fit 16 bits.</exception>
    public (double Minimum, double Maximum) Write(SafeFileHandle file, IProgress<double>? progress, CancellationToken cancellation)
    {
        int blocks = (options.Side + BlockSide - 1) / BlockSide;
        ConcurrentBag<Worker> idle = [];
        ParallelOptions parallel = new() { MaxDegreeOfParallelism = Math.Max(1, options.Threads), CancellationToken = cancellation };
        try
        {
            Parallel.For(0, blocks * blocks, parallel, block =>
            {
                if (!idle.TryTake(out Worker? worker))
                {
                    worker = new Worker(new MapSynthesizer(terrain, options.Projection));
                }

                WriteBlock(file, worker, block / blocks * BlockSide, block % blocks * BlockSide);
                progress?.Report((double)Interlocked.Increment(ref _blocksDone) / (blocks * blocks));
                idle.Add(worker);
            });
        }
        catch (AggregateException exception) when (exception.InnerExceptions.OfType<MsisfException>().FirstOrDefault() is { } first)
        {
            throw first;
        }
        catch (AggregateException exception) when (exception.InnerExceptions.OfType<IOException>().FirstOrDefault() is { } first)
        {
            throw new ExternalPartException($"{options.ProductId}: can't be written: {first.Message}", first);
        }

        return (_minimum, _maximum);
    }

    private void WriteBlock(SafeFileHandle file, Worker worker, int line0, int sample0)
    {
        int lines = Math.Min(BlockSide, options.Side - line0);
        int samples = Math.Min(BlockSide, options.Side - sample0);
        worker.Synthesizer.Synthesize(line0, lines, sample0, samples, worker.Heights);
        double min = double.PositiveInfinity;
        double max = double.NegativeInfinity;
        int sampleBytes = options.Format.SampleBytes;
        Span<byte> bytes = worker.Bytes.AsSpan(0, sampleBytes * samples);
        for (int line = 0; line < lines; line++)
        {
            (double minOfLine, double maxOfLine) = options.Format.Encode(
                line0 + line, sample0, worker.Heights.AsSpan(line * samples, samples), bytes);
            min = Math.Min(min, minOfLine);
            max = Math.Max(max, maxOfLine);
            RandomAccess.Write(file, bytes, sampleBytes * (((long)(line0 + line) * options.Side) + sample0));
        }

        lock (_gate)
        {
            _minimum = Math.Min(_minimum, min);
            _maximum = Math.Max(_maximum, max);
        }
    }

    /// <summary>The memory of a thread.</summary>
    private sealed class Worker(MapSynthesizer synthesizer)
    {
        public MapSynthesizer Synthesizer { get; } = synthesizer;

        public float[] Heights { get; } = new float[BlockSide * BlockSide];

        public byte[] Bytes { get; } = new byte[sizeof(float) * BlockSide];
    }
}
