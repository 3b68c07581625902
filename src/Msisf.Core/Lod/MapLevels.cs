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
    public static MapLevels Open(ITerrainGrid map, long cacheBytes = DefaultCacheBytes, bool keepsGaps = false)
    {
        // A map that has a level at hand has those above it from that one; without data a mean is another one if it must not be.
        ITerrainGrid? stored = keepsGaps || !map.MayHaveGaps ? map.StoredLevel : null;
        // The lines of polar maps are long: each line of a block lies on pages of its own, and the system maps fifteen neighbours with it.
        const int SamplesBetweenReleases = SparingSamplesBetweenReleases;
        LodCache cache = new(cacheBytes);
        List<ITerrainGrid> levels = [map];
        while (HasNext(levels[^1]))
        {
            int above = stored is null ? 0 : levels.Count - map.Projection.Resolution.HalvingsTo(stored.Projection.Resolution);
            levels.Add(above switch
            {
                _ when stored is null || above < 0 =>
                    new ReducedGrid(map, levels.Count, levels[^1] as ReducedGrid, cache, SamplesBetweenReleases, keepsGaps),
                0 => stored,
                _ => new ReducedGrid(stored, above, levels[^1] as ReducedGrid, cache, SamplesBetweenReleases, keepsGaps),
            });
        }

        return new MapLevels(levels);
    }

    /// <inheritdoc/>
    public override ITerrainGrid Grid(int level) => _levels[level];

    private static bool HasNext(ITerrainGrid level)
    {
        GridWindow window = level.Window.Halved();
        return Math.Min(window.Lines, window.Samples) >= LeastSide && level.Projection.Halved() switch
        {
            null => false,
            PolarStereographic polar => polar.Holds(window.Lines, window.Samples),
            _ => true,
        };
    }
}
