using Microsoft.Win32.SafeHandles;
using Msisf.Synthesis;

namespace Msisf.Adapters.Synthesis;

/// <summary>Computes the image of a synthetic polar map on several threads and writes each block to its place.</summary>
/// <param name="terrain">The ground.</param>
internal sealed class SyntheticMapImage(SyntheticTerrain terrain, SyntheticMapOptions options)
{
    private const int BlockSide = 512;

    /// <summary>Writes all samples.</summary>
    /// <param name="file">Open for writing at any offset, with the length of the image.</param>
    /// <param name="progress">Told the fraction done.</param>
    /// <param name="cancellation">Stops between blocks.</param>
    /// <returns>The minimum and the maximum sample, in the product's unit.</returns>
    /// <exception cref="BadInputException">A height does not fit 16 bits.</exception>
    public (double Minimum, double Maximum) Write(SafeFileHandle file, IProgress<double>? progress, CancellationToken cancellation)
    {
        int blocks = (options.Side + BlockSide - 1) / BlockSide;
        int blocksDone = 0;
        SyntheticImageFile image = new(file, options.ProductId, options.Format, options.Side);
        image.WriteBlocks(
            blocks * blocks,
            new ParallelOptions { MaxDegreeOfParallelism = Math.Max(1, options.Threads), CancellationToken = cancellation },
            () => new Worker(new MapSynthesizer(terrain, options.Projection)),
            (block, worker) =>
            {
                WriteBlock(image, worker, block / blocks * BlockSide, block % blocks * BlockSide);
                progress?.Report((double)Interlocked.Increment(ref blocksDone) / (blocks * blocks));
            });
        return image.Extremes;
    }

    private void WriteBlock(SyntheticImageFile image, Worker worker, int line0, int sample0)
    {
        int lines = Math.Min(BlockSide, options.Side - line0);
        int samples = Math.Min(BlockSide, options.Side - sample0);
        worker.Synthesizer.Synthesize(line0, lines, sample0, samples, worker.Heights);
        image.WriteRows(worker.Heights, worker.Bytes, (line0, sample0), (lines, samples), (line0, sample0));
    }

    /// <summary>The memory of a thread.</summary>
    private sealed class Worker(MapSynthesizer synthesizer)
    {
        public MapSynthesizer Synthesizer { get; } = synthesizer;

        public float[] Heights { get; } = new float[BlockSide * BlockSide];

        public byte[] Bytes { get; } = new byte[sizeof(float) * BlockSide];
    }
}
