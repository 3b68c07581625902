using Msisf.Core.Surface;

namespace Msisf.Core.Tiles;

/// <summary>
/// A level of an elevation summary: blocks of equal size, with a whole number of them along a tile's edge. Rows run from north to south,
/// columns from longitude 0 to the east, as lines and samples do.
/// </summary>
public sealed class SummaryLevel
{
    private readonly BoundsTree _tree;
    private readonly TileLayout _layout;
    private readonly int _level;
    private readonly NodeBounds _limits;

    internal SummaryLevel(BoundsTree tree, TileLayout layout, int level, NodeBounds limits)
    {
        _limits = limits;
        _tree = tree;
        _layout = layout;
        _level = level;
    }

    /// <summary>Number of blocks along a tile's edge.</summary>
    public int Subdivisions => _layout.Subdivisions(_level);

    /// <summary>Rows of blocks from pole to pole.</summary>
    public int Rows => _layout.Rows(_level);

    /// <summary>Columns of blocks around the Moon.</summary>
    public int Columns => _layout.Columns(_level);

    /// <summary>Blocks of the level.</summary>
    internal int Count => Rows * Columns;

    /// <summary>Number of cells along a tile's edge.</summary>
    internal int TileCells => _layout.TileCells;

    /// <summary>Lines of the model.</summary>
    internal int Lines => _layout.Lines;

    /// <summary>Bounds of a block.</summary>
    internal NodeBounds BoundsOf(int row, int column) => _tree.Of(_level, row, column);

    /// <summary>A block with its place and bounds.</summary>
    internal TerrainNode Node(int row, int column) => _tree.Node(_level, row, column);

    /// <summary>Several neighbouring blocks of one row as one node.</summary>
    /// <param name="column">Westernmost block.</param>
    internal TerrainNode Node(int row, int column, int count) => _tree.Node(_level, row, column, count);

    /// <summary>
    /// The same without reading: a block that is not known has the limits of the model. What is true of all surfaces within these is true
    /// of the block.
    /// </summary>
    internal TerrainNode NodeUnread(int row, int column, int count = 1) => _tree.NodeWithin(_level, row, column, count, _limits);

    /// <summary>A tile without reading, as <see cref="NodeUnread(int, int, int)"/>; for the level of tiles.</summary>
    internal TerrainNode NodeUnread(TileId tile) => NodeUnread(tile.RowFromNorth, tile.Column);

    /// <summary>A block with the limits of the model, whatever is known of it.</summary>
    internal TerrainNode NodeOfLimits(int row, int column) =>
        _tree.NodeOf(_tree.CapOf(_level, row, column), _limits) with { IsUnread = true };

    /// <summary>A tile's block with its place and bounds.</summary>
    /// <param name="block">
    /// Row of the block in its tile times <see cref="Subdivisions"/> plus its column; in the level of tiles each tile is one block.
    /// </param>
    internal TerrainNode NodeOf(TileId tile, int block = 0)
    {
        (int row, int column) = PlaceOf(tile, block);
        return Node(row, column);
    }

    /// <summary>Row and column of a tile's block; the numbers are those of <see cref="NodeOf"/>.</summary>
    internal (int Row, int Column) PlaceOf(TileId tile, int block)
    {
        (int row, int column) = int.DivRem(block, Subdivisions);
        return ((tile.RowFromNorth * Subdivisions) + row, (tile.Column * Subdivisions) + column);
    }

    /// <summary>The mesh cells of some neighbouring blocks of one row.</summary>
    internal CellRange Cells(int row, int column, int count = 1) =>
        _layout.Cells(_level, row, column) with { EndSample = Start(column + count) };

    /// <summary>Half of the minimum extent of a block as an angle at the Moon's centre, rad.</summary>
    internal double InnerRadius(int row) =>
        MeshBounds.InnerRadius(Cells(row, 0) with { EndSample = TileCells / Subdivisions }, Lines, _layout.Samples);

    /// <summary>First line or sample of a row or column.</summary>
    internal int Start(int block) => _layout.Start(_level, block);
}
