using Microsoft.Win32.SafeHandles;
using Msisf.Core;
using Msisf.Core.Terrain;
using Msisf.Synthesis;

namespace Msisf.Adapters.Synthesis;

/// <summary>Writes a synthetic polar map, block by block, so that memory does not grow with it.</summary>
public static class SyntheticMapWriter
{
    /// <summary>Degrees: the lowest absolute latitude of the middle of a map's sides; its corners then reach to 30 degrees.</summary>
    public const double LowestLatitude = 45.0;

    /// <summary>
    /// Degrees: the lowest latitude of a map that continues a base model. Its corners then reach to 75.9 degrees, where the detail's means
    /// over the base's pixels, which are those of another grid, are hardly taken off any more (docs/elevation-models.md, Polar caps).
    /// </summary>
    public const double LowestLatitudeWithBase = 80.0;

    /// <summary>Computes and writes a map. The same options give the same bytes.</summary>
    /// <param name="options">What and where.</param>
    /// <param name="progress">Told the fraction done, 0 to 1, from any of the threads.</param>
    /// <param name="cancellation">Stops the work; nothing is left behind.</param>
    /// <returns>Path of the label; the image lies beside it.</returns>
    /// <exception cref="BadInputException">
    /// The map has no samples, does not fit the base, a height does not fit 16 bits, or the name is that of a file that is not synthetic.
    /// </exception>
    /// <exception cref="ExternalPartException">The disk is too full, or refuses.</exception>
    public static string Write(SyntheticMapOptions options, IProgress<double>? progress, CancellationToken cancellation)
    {
        double lowest = options.Base is null ? LowestLatitude : LowestLatitudeWithBase;
        Guard.InRange(
            options.LatitudeDegrees,
            lowest,
            90.0,
            options.Base is null ? "The latitude of a polar map (degrees)" : "The latitude of a polar map that continues a base (degrees)");
        if (options.Side < 2)
        {
            throw new BadInputException(
                $"A map from {options.LatitudeDegrees} degrees of latitude to the pole has no samples at {options.MetresPerPixel} m/px. "
                    + $"Take a lower latitude or a finer scale.");
        }

        SyntheticTerrain terrain = SyntheticTerrain.ForMap(options.MetresPerPixel, options.Seed, options.Base, cancellation);
        return SyntheticProductFiles.Write(
            options.OutputFolder,
            options.ProductId,
            options.Bytes,
            options.Bytes,
            file => new SyntheticMapImage(terrain, options).Write(file, progress, cancellation),
            (writer, extremes) => SyntheticMapLabel.Of(options).Write(writer, extremes.Minimum, extremes.Maximum));
    }
}

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

/// <summary>Makes the label of a synthetic polar map.</summary>
internal static class SyntheticMapLabel
{
    /// <summary>Describes a map.</summary>
    /// <param name="options">What is described, and how it was made.</param>
    public static SyntheticLabel Of(SyntheticMapOptions options)
    {
        int pole = options.IsSouth ? -90 : 90;
        double border = options.IsSouth ? -options.LatitudeDegrees : options.LatitudeDegrees;
        double resolution = MoonConstants.ReferenceRadius * Math.PI / 180.0 / options.MetresPerPixel;
        string scale = options.MetresPerPixel.ToString("R", CultureInfo.InvariantCulture);
        string source = options.Base is null ? "nothing (a made-up global shape)" : options.Base.ProductId;
        return new SyntheticLabel
        {
            ProductId = options.ProductId,
            Description = Invariant($"""
                   A shape map (radius) of a Moon at a scale of {scale} m/pix,
                   computed from the seed
                   {options.Seed}, continuing
                   {source},
                   downwards with random craters and roughness that follow the Moon's
                   statistics, in polar stereographic projection, true to scale at the
                   pole. Map values are relative to a radius of 1737.4 km.
                """),
            Lines = options.Side,
            LineSamples = options.Side,
            Format = options.Format,
            Map = new SyntheticLabelMap
            {
                Catalogue = "DSMAP_POLAR.CAT",
                Projection = "POLAR STEREOGRAPHIC",
                Resolution = resolution.ToString("0.0000", CultureInfo.InvariantCulture),
                Scale = scale,
                CentreLatitude = pole,
                CentreLongitude = 0,
                North = Math.Max(pole, border),
                South = Math.Min(pole, border),
                West = 0,
                East = 360,
                LineOffset = options.Projection.LineOffset,
                SampleOffset = options.Projection.SampleOffset,
            },
        };
    }
}
