using Msisf.Core;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// A synthetic Moon: detail from a seed that is added to a base model below the base's own resolution, or to an invented global shape.
/// Immutable and safe for several threads; each thread takes a <see cref="TileSynthesizer"/> of its own.
/// </summary>
/// <remarks>Method, sources and measurements: docs/elevation-models.md.</remarks>
public sealed class SyntheticTerrain
{
    /// <summary>Maximum resolution, samples a degree, as of NASA's finest product; the samples are then 30 m apart.</summary>
    public const int LargestResolution = 1024;

    /// <summary>
    /// Maximum ratio of a model's resolution to that of its base; a tile then still holds at least seven base pixels along each side.
    /// </summary>
    public const int LargestRatio = 512;

    // Minimum crater diameter in samples: three samples are needed to show a bowl.
    private const double SmallestCraterInSamples = 3.0;

    // Maximum crater diameter in samples of the base, which shows larger craters itself.
    private const double LargestCraterInBaseSamples = 2.0;

    // Maximum crater diameter without a base; larger ones would be basins, which the low ground of the invented shape represents.
    private const double LargestCraterWithoutBase = 120_000.0; // m

    private readonly CraterPopulation _craters;

    /// <summary>Prepares a model: reads the base once, coarsely, for its maria and its slopes.</summary>
    /// <param name="pixelsPerDegree">1 to <see cref="LargestResolution"/>; with a base, an even multiple of its resolution.</param>
    /// <param name="seed">Another seed gives another terrain.</param>
    /// <param name="baseModel">The model to refine; null for an invented shape.</param>
    /// <param name="cancellation">Stops the reading.</param>
    /// <exception cref="BadInputException">The resolution does not fit.</exception>
    public SyntheticTerrain(int pixelsPerDegree, ulong seed, IGlobalGrid? baseModel, CancellationToken cancellation = default)
    {
        Guard.InRange(pixelsPerDegree, 1, LargestResolution, "the synthetic model's resolution (samples a degree)");
        if (baseModel is not null)
        {
            RequireFit(pixelsPerDegree, baseModel);
        }

        PixelsPerDegree = pixelsPerDegree;
        HasBase = baseModel is not null;
        IGlobalGrid model = baseModel ?? new SyntheticShape(seed);
        Base = new BaseHeights(model);
        SamplesPerPixel = pixelsPerDegree / model.PixelsPerDegree;
        Kernel = new PixelMeanKernel(SamplesPerPixel);
        Maria = new MareMask(model, cancellation);
        (Octaves, _craters) = DetailOf(ModelSlopes.Spacing(pixelsPerDegree), seed, model);
    }

    private SyntheticTerrain(ulong seed, IGlobalGrid? baseModel, double metresPerPixel, CancellationToken cancellation)
    {
        HasBase = baseModel is not null;
        IGlobalGrid model = baseModel ?? new SyntheticShape(seed);
        Base = new BaseHeights(model);
        SamplesPerPixel = Math.Clamp(
            2 * (int)Math.Round(0.5 * ModelSlopes.Spacing(model.PixelsPerDegree) / metresPerPixel), 2, LargestRatio);
        PixelsPerDegree = SamplesPerPixel * model.PixelsPerDegree;
        Kernel = new PixelMeanKernel(SamplesPerPixel);
        Maria = new MareMask(model, cancellation);
        (Octaves, _craters) = DetailOf(metresPerPixel, seed, model);
    }

    /// <summary>Prepares the same ground for a map whose samples are not those of a grid of latitude and longitude.</summary>
    /// <param name="metresPerPixel">m between the map's samples, above 0.</param>
    /// <param name="seed">Another seed gives another terrain.</param>
    /// <param name="baseModel">The model to refine; null for an invented shape.</param>
    /// <param name="cancellation">Stops the reading.</param>
    public static SyntheticTerrain ForMap(
        double metresPerPixel, ulong seed, IGlobalGrid? baseModel, CancellationToken cancellation = default) =>
        new(seed, baseModel, metresPerPixel, cancellation);

    private (NoiseOctave[] Octaves, CraterPopulation Craters) DetailOf(double spacing, ulong seed, IGlobalGrid model)
    {
        double baseSpacing = ModelSlopes.Spacing(model.PixelsPerDegree);
        return (
            DetailSpectrum.Octaves(seed, baseSpacing, spacing, ModelSlopes.Of(model, Maria)),
            new CraterPopulation(
                seed,
                Maria,
                SmallestCraterInSamples * spacing,
                HasBase ? LargestCraterInBaseSamples * baseSpacing : LargestCraterWithoutBase));
    }

    /// <summary>Samples a degree; of a map those of the nearest grid that continues the base.</summary>
    public int PixelsPerDegree { get; }

    /// <summary>
    /// Whether a base was given. If so, between 70 degrees south and north the mean of the samples in each base pixel is the base's
    /// value.
    /// </summary>
    public bool HasBase { get; }

    /// <summary>The base, or the invented shape.</summary>
    internal BaseHeights Base { get; }

    /// <summary>Samples along one side of a base pixel.</summary>
    internal int SamplesPerPixel { get; }

    /// <summary>Samples of the base that the detail takes to fade out beyond the border of a region.</summary>
    private const int FadeInBaseSamples = 2;

    /// <summary>How far, in degrees, detail reaches beyond the border of a region until it has faded out.</summary>
    public double FadeDegrees => (double)FadeInBaseSamples / Base.PixelsPerDegree;

    /// <summary>Interpolates the base.</summary>
    internal PixelMeanKernel Kernel { get; }

    /// <summary>Where the ground is smoother and has fewer craters.</summary>
    internal MareMask Maria { get; }

    /// <summary>The roughness below the base.</summary>
    internal IReadOnlyList<NoiseOctave> Octaves { get; }

    /// <summary>The craters that may reach into a range of latitudes and longitudes.</summary>
    internal IEnumerable<Crater> CratersNear(double southDegrees, double northDegrees, double westDegrees, double widthDegrees) =>
        _craters.Near(southDegrees, northDegrees, westDegrees, widthDegrees);

    /// <summary>The craters that may reach into a frame.</summary>
    internal IEnumerable<Crater> CratersNear(TileFrame frame) => _craters.Near(
        90.0 - ((double)(frame.FirstLine + frame.Lines) / PixelsPerDegree),
        90.0 - ((double)frame.FirstLine / PixelsPerDegree),
        (double)frame.FirstSample / PixelsPerDegree,
        (double)frame.Samples / PixelsPerDegree);

    private static void RequireFit(int pixelsPerDegree, IGlobalGrid baseModel)
    {
        int ratio = pixelsPerDegree / baseModel.PixelsPerDegree;
        if (ratio * baseModel.PixelsPerDegree != pixelsPerDegree || ratio % 2 != 0 || ratio is < 2 or > LargestRatio)
        {
            throw new BadInputException(
                $"{pixelsPerDegree} samples a degree can't continue {baseModel.ProductId} ({baseModel.PixelsPerDegree} a degree); "
                + $"take an even multiple of its resolution, up to {LargestRatio} times.");
        }
    }
}
