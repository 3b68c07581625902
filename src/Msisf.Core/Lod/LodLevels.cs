using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>
/// A model at its own resolution and at coarser ones: level k has res / 2^k samples a degree, each the mean of 2^k by 2^k samples of the
/// model. Pixel-registered grids nest, so a coarse sample lies in the middle of those that it stands for. The bits of a level don't depend
/// on whether it is stored or computed. Safe for several threads.
/// </summary>
public sealed class LodLevels
{
    /// <summary>Bytes of computed blocks that are kept if nothing else is asked for.</summary>
    public const long DefaultCacheBytes = 256L << 20;

    /// <summary>
    /// 128 MB of 16-bit samples: reading goes on at full speed. The system maps several times that, as it reads around what is asked for.
    /// </summary>
    public const int DefaultSamplesBetweenReleases = 1 << 26;

    /// <summary>8 MB of 16-bit samples: the levels take little memory, and more time to compute.</summary>
    public const int SparingSamplesBetweenReleases = 1 << 22;

    private readonly IElevationGrid[] _levels;

    private LodLevels(IElevationGrid[] levels) => _levels = levels;

    /// <summary>How many levels there are, the model itself included: the resolution stays whole.</summary>
    public int Count => _levels.Length;

    /// <summary>Takes a model; nothing is read or computed yet.</summary>
    /// <param name="source">The model.</param>
    /// <param name="stored">
    /// Levels that were made before, in any order (their resolutions say which); those without one are computed when they are read.
    /// </param>
    /// <param name="cacheBytes">Memory for computed blocks, all levels together.</param>
    /// <param name="samplesBetweenReleases">Samples of the model that are read before their memory is given back.</param>
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
