using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>
/// The levels of a model of the whole Moon: level k has res / 2^k samples a degree. Pixel-registered grids nest, so a coarse sample lies in
/// the middle of the samples that it replaces. The bits of a level don't depend on whether it is stored or computed. Safe for several
/// threads.
/// </summary>
public sealed class LodLevels : TerrainLevels
{
    private readonly IGlobalGrid[] _levels;

    private LodLevels(IGlobalGrid[] levels) => _levels = levels;

    /// <inheritdoc/>
    /// <remarks>The resolution of every level is a whole number.</remarks>
    public override int Count => _levels.Length;

    /// <summary>Takes a model; nothing is read or computed yet.</summary>
    /// <param name="stored">
    /// Levels that were made before, in any order (their resolutions say which); those without one are computed when they are read.
    /// </param>
    /// <param name="cacheBytes">Memory for computed blocks, all levels together.</param>
    /// <param name="samplesBetweenReleases">Number of samples of the model that are read before their memory is released.</param>
    public static LodLevels Open(
        IGlobalGrid source,
        IReadOnlyList<IGlobalGrid>? stored = null,
        long cacheBytes = DefaultCacheBytes,
        int samplesBetweenReleases = DefaultSamplesBetweenReleases)
    {
        LodCache cache = new(cacheBytes);
        IGlobalGrid[] levels = new IGlobalGrid[CountOf(source.PixelsPerDegree)];
        levels[0] = source;
        for (int level = 1; level < levels.Length; level++)
        {
            int resolution = source.PixelsPerDegree >> level;
            levels[level] = stored?.FirstOrDefault(grid => grid.PixelsPerDegree == resolution)
                ?? new ReducedMoon(source, level, levels[level - 1] as ReducedGrid, cache, samplesBetweenReleases);
        }

        return new LodLevels(levels);
    }

    /// <summary>How many levels a model of a resolution has.</summary>
    public static int CountOf(int pixelsPerDegree) => int.TrailingZeroCount(pixelsPerDegree) + 1;

    /// <summary>One level.</summary>
    /// <param name="level">0 (the model itself) to <see cref="Count"/> - 1.</param>
    public IGlobalGrid Level(int level) => _levels[level];

    /// <inheritdoc/>
    public override ITerrainGrid Grid(int level) => _levels[level];
}

/// <summary>A computed level of a model of the whole Moon.</summary>
public sealed class ReducedMoon : ReducedGrid, IGlobalGrid
{
    /// <inheritdoc cref="ReducedGrid"/>
    internal ReducedMoon(IGlobalGrid source, int halvings, ReducedGrid? below, LodCache cache, int samplesBetweenReleases)
        : base(source, halvings, below, cache, samplesBetweenReleases) => PixelsPerDegree = source.PixelsPerDegree >> halvings;

    /// <inheritdoc/>
    public int PixelsPerDegree { get; }
}
