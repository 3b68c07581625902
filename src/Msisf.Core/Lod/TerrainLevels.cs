using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>
/// A model at its own resolution and at coarser ones, each half as fine as the one before: a sample of level k is the mean of 2^k by 2^k
/// samples of the model, and lies in the middle of them. Safe for several threads.
/// </summary>
public abstract class TerrainLevels
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

    /// <summary>Number of levels, the model itself included.</summary>
    public abstract int Count { get; }

    /// <summary>One level.</summary>
    /// <param name="level">0 (the model itself) to <see cref="Count"/> - 1.</param>
    public abstract ITerrainGrid Grid(int level);
}
