using Msisf.Core.Terrain;

namespace Msisf.Core.Tiles.Selection;

/// <summary>Polar bounds of all tiles from one viewpoint, and of the blocks of those tiles that are asked for.</summary>
internal sealed class BoundsTable
{
    private readonly SummaryLevel _tileLevel;
    private readonly SummaryLevel _blockLevel;
    private readonly PolarBounds[] _tiles;
    private readonly PolarBounds[]?[] _blocks;

    public BoundsTable(PolarView view, ElevationSummary summary)
    {
        View = view;
        _tileLevel = summary.Levels[0];
        _blockLevel = summary.Levels[1];
        _tiles = new PolarBounds[_tileLevel.Bounds.Length];
        _blocks = new PolarBounds[_tiles.Length][];
        for (int tile = 0; tile < _tiles.Length; tile++)
        {
            _tiles[tile] = view.Bounds(_tileLevel.Node(tile / _tileLevel.Columns, tile % _tileLevel.Columns));
        }
    }

    /// <summary>From where.</summary>
    public PolarView View { get; }

    /// <summary>Bounds of a tile by row (0 northernmost) times columns plus column.</summary>
    public ref readonly PolarBounds this[int tile] => ref _tiles[tile];

    /// <summary>Bounds of the tile's blocks, row by row.</summary>
    public ReadOnlySpan<PolarBounds> Blocks(int tile) => _blocks[tile] ??= MakeBlocks(tile);

    /// <summary>Row and column at the block level of a tile's block.</summary>
    public (int Row, int Column) BlockPlace(int tile, int block)
    {
        int factor = _blockLevel.Subdivisions;
        return ((tile / _tileLevel.Columns * factor) + (block / factor), (tile % _tileLevel.Columns * factor) + (block % factor));
    }

    private PolarBounds[] MakeBlocks(int tile)
    {
        PolarBounds[] blocks = new PolarBounds[_blockLevel.Subdivisions * _blockLevel.Subdivisions];
        for (int block = 0; block < blocks.Length; block++)
        {
            (int row, int column) = BlockPlace(tile, block);
            blocks[block] = View.Bounds(_blockLevel.Node(row, column));
        }

        return blocks;
    }
}
