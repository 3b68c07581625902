namespace Msisf.Core.Tiles.Selection;

/// <summary>Bounds of the tiles and of their blocks as seen from one viewpoint; each is computed when it is requested.</summary>
internal sealed class BoundsTable
{
    private readonly SummaryLevel _tileLevel;
    private readonly SummaryLevel _blockLevel;
    private readonly PolarBounds?[] _tiles;
    private readonly PolarBounds?[] _unread;
    private readonly PolarBounds[]?[] _blocks;

    public BoundsTable(PolarView view, ElevationSummary summary)
    {
        View = view;
        _tileLevel = summary.Levels[0];
        _blockLevel = summary.Levels[1];
        _tiles = new PolarBounds?[_tileLevel.Count];
        _unread = new PolarBounds?[_tiles.Length];
        _blocks = new PolarBounds[_tiles.Length][];
    }

    /// <summary>The viewpoint.</summary>
    public PolarView View { get; }

    /// <summary>Bounds of a tile.</summary>
    public PolarBounds this[TileId tile] => _tiles[tile.Number] ??= View.Bounds(_tileLevel.NodeOf(tile));

    /// <summary>Bounds of a tile that hold without reading it; arcs and azimuths are those of the tile, slopes may be wider.</summary>
    public PolarBounds Unread(TileId tile) => _tiles[tile.Number] ?? (_unread[tile.Number] ??= View.Bounds(_tileLevel.NodeUnread(tile)));

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
