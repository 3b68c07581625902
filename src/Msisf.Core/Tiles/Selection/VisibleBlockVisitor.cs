using Msisf.Core.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>Finds out which of the finest blocks of a tile may be seen, and which of these are certainly dark.</summary>
internal sealed class VisibleBlockVisitor : ISurfaceVisitor
{
    private readonly ElevationSummary _summary;
    private readonly SunView? _sun;
    private readonly PolarView _view;
    private readonly Dictionary<TileId, bool[]> _tiles = [];
    private readonly List<DarkBlock> _dark = [];

    /// <param name="summary">Bounds of the terrain.</param>
    /// <param name="view">Half planes of the camera.</param>
    /// <param name="sun">The Moon from the Sun; null if the light is at the camera.</param>
    public VisibleBlockVisitor(ElevationSummary summary, PolarView view, SunView? sun)
    {
        _summary = summary;
        _view = view;
        _sun = sun;
    }

    /// <summary>Blocks that may be seen and are as black as the sky.</summary>
    public IReadOnlyList<DarkBlock> Dark => _dark;

    private SummaryLevel Finest => _summary.Levels[^1];

    /// <summary>
    /// For a tile that was walked: which of its finest blocks are needed, row by row. Set here for those that may be seen and are not
    /// certainly dark.
    /// </summary>
    public bool[] Of(TileId tile)
    {
        if (!_tiles.TryGetValue(tile, out bool[]? seen))
        {
            seen = new bool[Finest.Subdivisions * Finest.Subdivisions];
            _tiles.Add(tile, seen);
        }

        return seen;
    }

    public Visit Node(in TerrainNode node, in PolarBounds bounds, bool certain, NodePlace place)
    {
        if (!certain && place.Depth + 1 < _summary.Levels.Count)
        {
            return Visit.Descend;
        }

        bool isLit = _sun is null || _sun.Map.NeverHides(_sun.View.Bounds(node));
        int factor = Finest.Subdivisions / _summary.Levels[place.Depth].Subdivisions;
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
        int side = Finest.Subdivisions;
        TileId tile = TileId.At(row / side, column / side);
        int block = (row % side * side) + (column % side);
        if (!isLit)
        {
            TerrainNode node = Finest.Node(row, column);
            if (_sun!.Map.Hides(_sun.View.Bounds(node)))
            {
                _dark.Add(new DarkBlock(tile, block, _view.Bounds(node)));
                return;
            }
        }

        Of(tile)[block] = true;
    }

    /// <summary>A dark block.</summary>
    /// <param name="Tile">Its tile.</param>
    /// <param name="Block">Its number in the tile, row by row.</param>
    /// <param name="Bounds">Bounds of the block from the camera.</param>
    public readonly record struct DarkBlock(TileId Tile, int Block, PolarBounds Bounds);
}
