namespace Msisf.Core.Tiles.Selection;

/// <summary>Bounds of all tiles as seen from one viewpoint, and of the blocks of a tile once they are requested.</summary>
internal sealed class BoundsTable
{
    private readonly SummaryLevel _blockLevel;
    private readonly PolarBounds[] _tiles;
    private readonly PolarBounds[]?[] _blocks;

    public BoundsTable(PolarView view, ElevationSummary summary)
    {
        View = view;
        SummaryLevel tiles = summary.Levels[0];
        _blockLevel = summary.Levels[1];
        _tiles = new PolarBounds[tiles.Count];
        _blocks = new PolarBounds[_tiles.Length][];
        foreach (TileId tile in TileId.All)
        {
            _tiles[tile.Number] = view.Bounds(tiles.NodeOf(tile));
        }
    }

    /// <summary>The viewpoint.</summary>
    public PolarView View { get; }

    /// <summary>Bounds of a tile.</summary>
    public ref readonly PolarBounds this[TileId tile] => ref _tiles[tile.Number];

    /// <summary>Bounds of the tile's blocks, row by row.</summary>
    public ReadOnlySpan<PolarBounds> Blocks(TileId tile) => _blocks[tile.Number] ??= MakeBlocks(tile);

    private PolarBounds[] MakeBlocks(TileId tile)
    {
        PolarBounds[] blocks = new PolarBounds[_blockLevel.Subdivisions * _blockLevel.Subdivisions];
        for (int block = 0; block < blocks.Length; block++)
        {
            blocks[block] = View.Bounds(_blockLevel.NodeOf(tile, block));
        }

        return blocks;
    }
}
