using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Core.Layers;

/// <summary>Numbers for the tiles and the cells of the surface (docs/formats.md).</summary>
public static class CellNumber
{
    /// <summary>The tile that a cell belongs to (docs/pattern-format.md): 72 row + column, rows from the south, columns from longitude 0 eastwards.</summary>
    /// <param name="facet">A facet of the cell.</param>
    /// <param name="pixelsPerDegree">Of the grid in which the facet counts.</param>
    /// <returns>0 to <see cref="TileId.Count"/> - 1, the order of <see cref="TileId.All"/>.</returns>
    public static int TileOf(FacetId facet, int pixelsPerDegree)
    {
        int linesOfTile = TileId.SizeDegrees * pixelsPerDegree;
        int rowFromNorth = Math.Max(facet.Line, 0) / linesOfTile; // the northern fan belongs to the tiles of line 0
        return ((TileId.Rows - 1 - rowFromNorth) * TileId.Columns) + (facet.Sample / linesOfTile);
    }

    /// <summary>The cell: 360 res (line + 1) + sample, so that the northern fan (line -1) has the first numbers.</summary>
    /// <param name="facet">A facet of the cell.</param>
    /// <param name="pixelsPerDegree">res, of the grid in which the facet counts.</param>
    /// <returns>0 to 360 res (180 res + 1) - 1; below 2^53 for any model, so a double holds it.</returns>
    public static long CellOf(FacetId facet, int pixelsPerDegree) =>
        (360L * pixelsPerDegree * (facet.Line + 1L)) + facet.Sample;
}
