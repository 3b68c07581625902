using Msisf.Core.Blocks;
using Msisf.Core.Surface;

namespace Msisf.Core.Tiles.Selection;

/// <summary>A model of the whole Moon as the thesis's tiles.</summary>
/// <param name="patch">Its facets.</param>
/// <param name="pixelsPerDegree">Its resolution.</param>
internal sealed class TileGroups(GridPatch patch, int pixelsPerDegree) : ISceneGroups<TileId>
{
    private readonly int _side = TileId.SizeDegrees * pixelsPerDegree;

    /// <summary>The level of the nodes.</summary>
    public int Level { get; } = SceneSelection.LevelOf(patch);

    /// <remarks>A cell belongs to the tile of its north-west sample, the northern fan to the tiles of line 0.</remarks>
    public IEnumerable<TileId> GroupsOf(SurfaceNode node)
    {
        CellRange cells = patch.Layout.Cells(node.Place.Level, node.Place.Row, node.Place.Column);
        (int firstRow, int lastRow) = (Math.Max(cells.FirstLine, 0) / _side, Math.Max(cells.EndLine - 1, 0) / _side);
        (int firstColumn, int lastColumn) = (cells.FirstSample / _side, (cells.EndSample - 1) / _side);
        return
            from row in Enumerable.Range(firstRow, lastRow - firstRow + 1)
            from column in Enumerable.Range(firstColumn, lastColumn - firstColumn + 1)
            select TileId.At(row, column);
    }

    public IEnumerable<SurfaceNode> NodesOf(TileId tile)
    {
        CellRange all = patch.Layout.AllCells;
        int side = SquareLayout.Side(Level);
        int firstLine = tile.RowFromNorth == 0 ? all.FirstLine : tile.FirstLine(pixelsPerDegree);
        (int firstRow, int lastRow) =
            ((firstLine - all.FirstLine) / side, (tile.FirstLine(pixelsPerDegree) + _side - 1 - all.FirstLine) / side);
        int firstSample = tile.FirstSample(pixelsPerDegree);
        return
            from row in Enumerable.Range(firstRow, lastRow - firstRow + 1)
            from column in Enumerable.Range(firstSample / side, ((firstSample + _side - 1) / side) - (firstSample / side) + 1)
            select new SurfaceNode(0, new NodePlace(Level, row, column));
    }
}
