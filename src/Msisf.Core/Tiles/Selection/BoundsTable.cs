namespace Msisf.Core.Tiles.Selection;

/// <summary>Bounds of the tiles and of their blocks as seen from one viewpoint; each is computed when it is requested.</summary>
internal sealed class BoundsTable(PolarView view, ElevationSummary summary)
{
    private readonly SummaryLevel _tileLevel = summary.Levels[0];
    private readonly SummaryLevel _blockLevel = summary.Levels[1];
    private readonly PolarBounds?[] _tiles = new PolarBounds?[TileId.Count];
    private readonly PolarBounds?[]?[] _exact = new PolarBounds?[TileId.Count][];
    private readonly PolarBounds?[]?[] _possible = new PolarBounds?[TileId.Count][];

    /// <summary>The viewpoint.</summary>
    public PolarView View => view;

    public int BlocksPerTile { get; } = summary.Levels[1].Subdivisions * summary.Levels[1].Subdivisions;

    /// <summary>
    /// Bounds of a tile with any heights that the model may have, so that it is not read; arcs and azimuths are those of the tile. The
    /// exact bounds if the whole summary was made at once.
    /// </summary>
    public PolarBounds Possible(TileId tile) => _tiles[tile.Number] ??= view.Bounds(
        summary.IsOnDemand ? _tileLevel.NodeOfLimits(tile.RowFromNorth, tile.Column) : _tileLevel.NodeOf(tile));

    /// <summary>Bounds of a tile; it is read if it was not yet.</summary>
    public PolarBounds Exact(TileId tile) => summary.IsOnDemand ? view.Bounds(_tileLevel.NodeOf(tile)) : Possible(tile);

    /// <summary>Bounds of a tile's block, numbered row by row, as <see cref="Possible(TileId)"/>.</summary>
    public ref readonly PolarBounds Possible(TileId tile, int block) =>
        ref Of(summary.IsOnDemand ? _possible : _exact, tile, block, isRead: !summary.IsOnDemand);

    /// <summary>Bounds of a tile's block, numbered row by row; it is read if it was not yet.</summary>
    public ref readonly PolarBounds Exact(TileId tile, int block) => ref Of(_exact, tile, block, isRead: true);

    private ref readonly PolarBounds Of(PolarBounds?[]?[] kept, TileId tile, int block, bool isRead)
    {
        ref PolarBounds? bounds = ref (kept[tile.Number] ??= new PolarBounds?[BlocksPerTile])[block];
        bounds ??= Find(tile, block, isRead);
        return ref Nullable.GetValueRefOrDefaultRef(in bounds);
    }

    private PolarBounds Find(TileId tile, int block, bool isRead)
    {
        (int row, int column) = _blockLevel.PlaceOf(tile, block);
        return view.Bounds(isRead ? _blockLevel.Node(row, column) : _blockLevel.NodeOfLimits(row, column));
    }
}
