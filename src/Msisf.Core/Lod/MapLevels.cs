using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>
/// The levels of a map of a part of the Moon, computed when they are read. Where a map ends in the middle of a coarse cell, the samples
/// that it has there stand for the cell, so a level ends within half a cell of the map.
/// </summary>
public sealed class MapLevels : TerrainLevels
{
    /// <summary>
    /// Minimum number of lines, and of samples of a line, of a coarser level: a map that fills a pixel or two needs no better one.
    /// </summary>
    private const int LeastSide = 16;

    private readonly List<ITerrainGrid> _levels;

    private MapLevels(List<ITerrainGrid> levels) => _levels = levels;

    /// <inheritdoc/>
    public override int Count => _levels.Count;

    /// <summary>Takes a map; nothing is read or computed yet.</summary>
    /// <param name="cacheBytes">Memory for computed blocks, all levels together.</param>
    /// <param name="keepsGaps">
    /// Whether levels have places without data, for coarser models to fill; a coarse sample has none only if none of its samples has.
    /// Without it such a place is an error.
    /// </param>
    /// <remarks>Those of a map that is raised are the levels of the map, raised: what is kept of it serves them too.</remarks>
    public static MapLevels Open(ITerrainGrid map, long cacheBytes = DefaultCacheBytes, bool keepsGaps = false)
    {
        if (map is OffsetGrid raised)
        {
            return new MapLevels([.. Open(raised.Source, cacheBytes, keepsGaps)._levels.Select(
                (level, index) => index == 0 ? map : new OffsetGrid(level, raised.Offset))]);
        }

        // What is kept of a map holds places without data; a mean is another one if there must be none.
        IReadOnlyList<ITerrainGrid> stored = keepsGaps || !map.MayHaveGaps ? map.StoredLevels : [];
        int firstStored = stored.Count == 0 ? int.MaxValue : map.Projection.Resolution.HalvingsTo(stored[0].Projection.Resolution);

        // The lines of polar maps are long: each line of a block lies on pages of its own, and the system maps fifteen neighbours with it.
        const int SamplesBetweenReleases = SparingSamplesBetweenReleases;
        LodCache cache = new(cacheBytes);
        List<ITerrainGrid> levels = [map];
        for (int count = CountOf(map); levels.Count < count;)
        {
            levels.Add(levels.Count >= firstStored
                ? stored[levels.Count - firstStored]
                : new ReducedGrid(map, levels.Count, levels[^1] as ReducedGrid, cache, SamplesBetweenReleases, keepsGaps));
        }

        return new MapLevels(levels);
    }

    /// <summary>Number of levels of a map, itself included.</summary>
    public static int CountOf(ITerrainGrid map)
    {
        int count = 1;
        (GridWindow window, MapProjection? projection) = (map.Window.Halved(), map.Projection.Halved());
        while (projection is not null && Math.Min(window.Lines, window.Samples) >= LeastSide
            && (projection is not PolarStereographic polar || polar.Holds(window.Lines, window.Samples)))
        {
            count++;
            (window, projection) = (window.Halved(), projection.Halved());
        }

        return count;
    }

    /// <inheritdoc/>
    public override ITerrainGrid Grid(int level) => _levels[level];
}
