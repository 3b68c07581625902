using Msisf.Core.Surface;

namespace Msisf.Core.Tiles;

/// <summary>
/// The levels of an elevation summary: tiles, squares of a quarter of a tile's edge and, for fine models, of a twentieth.
/// </summary>
/// <param name="pixelsPerDegree">Samples a degree of the model.</param>
internal sealed class TileLayout(int pixelsPerDegree) : BoundsLayout(180 * pixelsPerDegree, 360 * pixelsPerDegree)
{
    /// <summary>Minimum number of cells along a node's edge; with fewer, reading the cells is as fast as one more level.</summary>
    private const int MinCells = 4;

    private readonly int[] _subdivisions = TileId.SizeDegrees * pixelsPerDegree >= 20 * MinCells ? [20, 4, 1] : [4, 1];

    /// <summary>Samples a degree of the model.</summary>
    public int PixelsPerDegree { get; } = pixelsPerDegree;

    /// <summary>Number of cells along a tile's edge.</summary>
    public int TileCells { get; } = TileId.SizeDegrees * pixelsPerDegree;

    public override int Levels => _subdivisions.Length;

    public override int CoarsestReadLevel => 0;

    /// <summary>Nodes of a level along a tile's edge.</summary>
    public int Subdivisions(int level) => _subdivisions[level];

    public override int Rows(int level) => TileId.Rows * _subdivisions[level];

    public override int Columns(int level) => TileId.Columns * _subdivisions[level];

    public override int ChildrenPerEdge(int level) => _subdivisions[level - 1] / _subdivisions[level];

    public override CellRange Cells(int level, int row, int column) => new(
        row == 0 ? -1 : Start(level, row), Start(level, row + 1), Start(level, column), Start(level, column + 1));

    /// <summary>First line or sample of a row or column.</summary>
    public int Start(int level, int place)
    {
        (int tile, int inTile) = int.DivRem(place, _subdivisions[level]);
        return (tile * TileCells) + (inTile * TileCells / _subdivisions[level]);
    }
}
