namespace Msisf.Core.Tiles.Selection;

/// <summary>Bounds of the tiles and of their blocks as seen from one viewpoint; each is computed when it is requested.</summary>
internal sealed class BoundsTable
{
    private readonly SummaryLevel _tileLevel;
    private readonly SummaryLevel _blockLevel;
    private readonly bool _isOnDemand;
    private readonly PolarBounds?[] _tiles;
    private readonly Blocks _blocks;
    private readonly Blocks _possibleBlocks;

    public BoundsTable(PolarView view, ElevationSummary summary)
    {
        View = view;
        _tileLevel = summary.Levels[0];
        _blockLevel = summary.Levels[1];
        _isOnDemand = summary.IsOnDemand;
        _tiles = new PolarBounds?[_tileLevel.Count];
        BlocksPerTile = _blockLevel.Subdivisions * _blockLevel.Subdivisions;
        _blocks = new Blocks(BlocksPerTile);
        _possibleBlocks = new Blocks(BlocksPerTile);
    }

    /// <summary>The viewpoint.</summary>
    public PolarView View { get; }

    /// <summary>Number of blocks of a tile.</summary>
    public int BlocksPerTile { get; }

    /// <summary>
    /// Bounds of a tile with any heights that the model may have, so that it is not read; arcs and azimuths are those of the tile. The
    /// exact bounds if the whole summary was made at once.
    /// </summary>
    public PolarBounds Possible(TileId tile) => _tiles[tile.Number] ??= View.Bounds(
        _isOnDemand ? _tileLevel.NodeOfLimits(tile.RowFromNorth, tile.Column) : _tileLevel.NodeOf(tile));

    /// <summary>Bounds of a tile; it is read if it was not yet.</summary>
    public PolarBounds Exact(TileId tile) => _isOnDemand ? View.Bounds(_tileLevel.NodeOf(tile)) : Possible(tile);

    /// <summary>Bounds of a tile's block, as <see cref="Possible(TileId)"/>.</summary>
    /// <param name="tile">The tile.</param>
    /// <param name="block">Number of the block, row by row.</param>
    public ref readonly PolarBounds Possible(TileId tile, int block)
    {
        if (!_isOnDemand)
        {
            return ref Exact(tile, block);
        }

        ref PolarBounds bounds = ref _possibleBlocks.Of(tile, block, out bool isNew);
        if (isNew)
        {
            (int row, int column) = _blockLevel.PlaceOf(tile, block);
            bounds = View.Bounds(_blockLevel.NodeOfLimits(row, column));
        }

        return ref bounds;
    }

    /// <summary>Bounds of a tile's block; it is read if it was not yet.</summary>
    /// <param name="tile">The tile.</param>
    /// <param name="block">Number of the block, row by row.</param>
    public ref readonly PolarBounds Exact(TileId tile, int block)
    {
        ref PolarBounds bounds = ref _blocks.Of(tile, block, out bool isNew);
        if (isNew)
        {
            bounds = View.Bounds(_blockLevel.NodeOf(tile, block));
        }

        return ref bounds;
    }

    /// <summary>Bounds of blocks, tile by tile.</summary>
    private sealed class Blocks(int blocksPerTile)
    {
        private readonly PolarBounds[]?[] _bounds = new PolarBounds[TileId.Count][];
        private readonly uint[] _isThere = new uint[TileId.Count];

        public ref PolarBounds Of(TileId tile, int block, out bool isNew)
        {
            PolarBounds[] bounds = _bounds[tile.Number] ??= new PolarBounds[blocksPerTile];
            ref uint isThere = ref _isThere[tile.Number];
            isNew = (isThere & (1U << block)) == 0;
            isThere |= 1U << block;
            return ref bounds[block];
        }
    }
}
