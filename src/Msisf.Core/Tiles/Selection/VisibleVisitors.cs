using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>Finds out whether any part of a tile may be seen, and whether in sunlight.</summary>
/// <param name="sun">The Moon from the Sun; null if the light is at the camera.</param>
internal sealed class VisibleTileVisitor(SunView? sun) : ISightVisitor
{
    /// <summary>Whether part of the tile may be seen in sunlight.</summary>
    public bool SeenLit { get; private set; }

    /// <summary>Whether a dark part of the tile may be seen.</summary>
    public bool SeenDark { get; private set; }

    public Visit Node(in SeenNode seen)
    {
        PolarBounds? fromSun = sun?.View.Bounds(seen.Node);
        if (fromSun is { } bounds && sun!.Map.Hides(bounds))
        {
            SeenDark |= seen.IsCertain;
            return SeenDark ? Visit.Skip : Visit.Descend;
        }

        SeenLit |= seen.IsCertain && (fromSun is not { } lit || sun!.Map.NeverHides(lit));
        return SeenLit ? Visit.Stop : Visit.Descend;
    }

    public Visit Facet(ReadOnlySpan<Vector3D> part, in PolarBounds bounds, in Facet facet)
    {
        bool isDark = sun is not null && (facet.TurnsAwayFrom(sun.Position) || sun.Map.Hides(sun.View.Bounds(part)));
        SeenDark |= isDark;
        SeenLit |= !isDark;
        return isDark ? Visit.Descend : Visit.Stop;
    }
}

/// <summary>Finds out which of the finest blocks of a tile may be seen, and which of these are certainly dark.</summary>
/// <param name="summary">Bounds of the terrain.</param>
/// <param name="view">Half planes of the camera.</param>
/// <param name="sun">The Moon from the Sun; null if the light is at the camera.</param>
internal sealed class VisibleBlockVisitor(ElevationSummary summary, PolarView view, SunView? sun) : ISightVisitor
{
    private readonly Dictionary<TileId, bool[]> _tiles = [];
    private readonly List<DarkBlock> _dark = [];
    private readonly SummaryLevel _finest = summary.Levels[^1];

    /// <summary>Blocks that may be seen and are as black as the sky.</summary>
    public IReadOnlyList<DarkBlock> Dark => _dark;

    /// <summary>
    /// For a tile that was walked: which of its finest blocks are needed, row by row. Set here for those that may be seen and are not
    /// certainly dark.
    /// </summary>
    public bool[] Of(TileId tile)
    {
        if (!_tiles.TryGetValue(tile, out bool[]? seen))
        {
            _tiles[tile] = seen = new bool[_finest.Subdivisions * _finest.Subdivisions];
        }

        return seen;
    }

    public Visit Node(in SeenNode seen)
    {
        NodePlace place = seen.Place;
        if (!seen.IsCertain && place.Level > 0)
        {
            return Visit.Descend;
        }

        bool isLit = sun is null || sun.Map.NeverHides(sun.View.Bounds(seen.Node));
        int factor = _finest.Subdivisions / summary.LevelOf(place).Subdivisions;
        for (int row = place.Row * factor; row < (place.Row + 1) * factor; row++)
        {
            for (int column = place.Column * factor; column < (place.Column + 1) * factor; column++)
            {
                Note(row, column, isLit);
            }
        }

        return Visit.Skip;
    }

    /// <summary>Blocks are not entered.</summary>
    public Visit Facet(ReadOnlySpan<Vector3D> part, in PolarBounds bounds, in Facet facet) => Visit.Skip;

    private void Note(int row, int column, bool isLit)
    {
        int side = _finest.Subdivisions;
        TileId tile = TileId.At(row / side, column / side);
        int block = (row % side * side) + (column % side);
        if (!isLit && _finest.Node(row, column) is var node && sun!.Map.Hides(sun.View.Bounds(node)))
        {
            _dark.Add(new DarkBlock(tile, block, view.Bounds(node)));
        }
        else
        {
            Of(tile)[block] = true;
        }
    }

    /// <summary>A dark block.</summary>
    /// <param name="Block">Its number in the tile, row by row.</param>
    /// <param name="Bounds">Bounds of the block from the camera.</param>
    public readonly record struct DarkBlock(TileId Tile, int Block, PolarBounds Bounds);
}
