using Microsoft.Win32.SafeHandles;
using Msisf.Synthesis;

namespace Msisf.Adapters.Synthesis;

/// <summary>Computes the image of a synthetic product on several threads and writes each block to its place.</summary>
internal sealed class SyntheticLdemImage
{
    private const long LargestMemory = 220_000_000; // bytes of all threads' blocks: many cores do not mean much memory

    private readonly SyntheticTerrain _terrain;
    private readonly SyntheticLdemOptions _product;
    private readonly RegionWeights _weights;
    private long _samplesDone;

    /// <summary>An image to write.</summary>
    /// <param name="terrain">The model.</param>
    /// <param name="product">The part of it.</param>
    public SyntheticLdemImage(SyntheticTerrain terrain, SyntheticLdemOptions product)
    {
        _terrain = terrain;
        _product = product;
        _weights = new RegionWeights(
            product.Region, product.PixelsPerDegree, product.Rest == SyntheticRest.Base ? terrain.FadeDegrees : 0.0);
    }

    /// <summary>Writes all samples.</summary>
    /// <param name="file">Open for writing at any offset, with the length of the image.</param>
    /// <param name="progress">Told the fraction done.</param>
    /// <param name="cancellation">Stops between blocks.</param>
    /// <returns>The minimum and the maximum sample, in the product's unit.</returns>
    /// <exception cref="BadInputException">A height does not fit 16 bits.</exception>
    public (double Minimum, double Maximum) Write(SafeFileHandle file, IProgress<double>? progress, CancellationToken cancellation)
    {
        TileSynthesizer typical = new(_terrain);
        int side = typical.PreferredSide;
        int fitting = (int)Math.Clamp(LargestMemory / typical.PreferredBytes, 1, Math.Max(1, _product.Threads));
        int blocksAcross = (_product.LineSamples + side - 1) / side;
        int blocksDown = (_product.Lines + side - 1) / side;
        SyntheticImageFile image = new(file, _product.ProductId, _product.Format, _product.LineSamples);
        if (_product.Rest == SyntheticRest.Flat)
        {
            image.Include(0.0, 0.0);
        }

        image.WriteBlocks(
            blocksAcross * blocksDown,
            new ParallelOptions { MaxDegreeOfParallelism = fitting, CancellationToken = cancellation },
            () => new SyntheticBlock(_terrain, _product.Rest, _weights, side),
            (block, worker) =>
            {
                WriteBlock(image, worker, block / blocksAcross * side, block % blocksAcross * side, side);
                Report(progress, block / blocksAcross * side, block % blocksAcross * side, side);
            });
        return image.Extremes;
    }

    private void WriteBlock(SyntheticImageFile image, SyntheticBlock worker, int line0, int sample0, int side)
    {
        int lines = Math.Min(side, _product.Lines - line0);
        int samples = Math.Min(side, _product.LineSamples - sample0);
        int moonLine = line0 + ((90 - _product.Cover.NorthDegrees) * _product.PixelsPerDegree);
        int moonSample = sample0 + (_product.Cover.WestDegrees * _product.PixelsPerDegree);
        if (worker.TryCompute(moonLine, lines, moonSample, samples))
        {
            image.WriteRows(worker.Heights, worker.Bytes, (line0, sample0), (lines, samples), (moonLine, moonSample));
        }
    }

    private void Report(IProgress<double>? progress, int line0, int sample0, int side)
    {
        long block = (long)Math.Min(side, _product.Lines - line0) * Math.Min(side, _product.LineSamples - sample0);
        double fraction = (double)Interlocked.Add(ref _samplesDone, block) / ((long)_product.Lines * _product.LineSamples);
        progress?.Report(fraction);
    }
}
