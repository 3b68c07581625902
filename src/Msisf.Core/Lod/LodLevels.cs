using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>
/// A model at its own resolution and at coarser ones: level k has res / 2^k samples a degree, each the mean of 2^k by 2^k samples of the
/// model. Pixel-registered grids nest, so a coarse sample lies in the middle of the samples that it replaces. The bits of a level don't
/// depend on whether it is stored or computed. Safe for several threads.
/// </summary>
public sealed class LodLevels
{
    /// <summary>Default size of the computed blocks that are kept, bytes.</summary>
    public const long DefaultCacheBytes = 256L << 20;

    /// <summary>
    /// Default number of samples between releases of memory: 128 MB of 16-bit samples, with no loss of reading speed. The system maps
    /// several times as much, as it also reads the neighbouring pages.
    /// </summary>
    public const int DefaultSamplesBetweenReleases = 1 << 26;

    /// <summary>
    /// Number of samples between releases where memory is short: 8 MB of 16-bit samples; the levels take longer to compute.
    /// </summary>
    public const int SparingSamplesBetweenReleases = 1 << 22;

    private readonly IElevationGrid[] _levels;

    private LodLevels(IElevationGrid[] levels) => _levels = levels;

    /// <summary>Number of levels, the model itself included; the resolution of every level is a whole number.</summary>
    public int Count => _levels.Length;

    /// <summary>Takes a model; nothing is read or computed yet.</summary>
    /// <param name="source">The model.</param>
    /// <param name="stored">
    /// Levels that were made before, in any order (their resolutions say which); those without one are computed when they are read.
    /// </param>
    /// <param name="cacheBytes">Memory for computed blocks, all levels together.</param>
    /// <param name="samplesBetweenReleases">Number of samples of the model that are read before their memory is released.</param>
    public static LodLevels Open(
        IElevationGrid source,
        IReadOnlyList<IElevationGrid>? stored = null,
        long cacheBytes = DefaultCacheBytes,
        int samplesBetweenReleases = DefaultSamplesBetweenReleases)
    {
        LodCache cache = new(cacheBytes);
        IElevationGrid[] levels = new IElevationGrid[CountOf(source.PixelsPerDegree)];
        levels[0] = source;
        for (int level = 1; level < levels.Length; level++)
        {
            int resolution = source.PixelsPerDegree >> level;
            levels[level] = stored?.FirstOrDefault(grid => grid.PixelsPerDegree == resolution)
                ?? new ReducedGrid(source, level, levels[level - 1] as ReducedGrid, cache, samplesBetweenReleases);
        }

        return new LodLevels(levels);
    }

    /// <summary>How many levels a model of a resolution has.</summary>
    public static int CountOf(int pixelsPerDegree) => int.TrailingZeroCount(pixelsPerDegree) + 1;

    /// <summary>One level.</summary>
    /// <param name="level">0 (the model itself) to <see cref="Count"/> - 1.</param>
    public IElevationGrid Level(int level) => _levels[level];
}
