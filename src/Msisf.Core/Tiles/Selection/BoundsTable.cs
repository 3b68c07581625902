using Msisf.Core.Mesh.Bounds;

namespace Msisf.Core.Tiles.Selection;

/// <summary>Polar bounds of all tiles from one viewpoint, and of the blocks of those tiles that are asked for.</summary>
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
        _tiles = new PolarBounds[tiles.Bounds.Length];
        _blocks = new PolarBounds[_tiles.Length][];
        for (int tile = 0; tile < _tiles.Length; tile++)
        {
            _tiles[tile] = view.Bounds(tiles.NodeOf(tile));
        }
    }

    /// <summary>From where.</summary>
    public PolarView View { get; }

    /// <summary>Bounds of a tile by row (0 northernmost) times columns plus column.</summary>
    public ref readonly PolarBounds this[int tile] => ref _tiles[tile];

    /// <summary>Bounds of the tile's blocks, row by row.</summary>
    public ReadOnlySpan<PolarBounds> Blocks(int tile) => _blocks[tile] ??= MakeBlocks(tile);

    private PolarBounds[] MakeBlocks(int tile)
    {
        PolarBounds[] blocks = new PolarBounds[_blockLevel.Subdivisions * _blockLevel.Subdivisions];
        for (int block = 0; block < blocks.Length; block++)
        {
            blocks[block] = View.Bounds(_blockLevel.NodeOf(tile, block));
        }

        return blocks;
    }
}
