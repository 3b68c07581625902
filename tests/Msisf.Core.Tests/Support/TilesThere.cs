using Msisf.Core.Tiles;
using Msisf.Core.Tiles.Selection;

namespace Msisf.Core.Tests.Support;

/// <summary>The kept tiles as <see cref="BruteForceMoon"/> numbers them: row (0 northernmost) times 72 plus column.</summary>
internal static class TilesThere
{
    public static bool[] In(TileSelection selection)
    {
        bool[] isThere = new bool[TileId.Count];
        foreach (TileChoice choice in selection.Kept)
        {
            isThere[((85 - choice.Tile.SouthDegrees) / 5 * TileId.Columns) + (choice.Tile.WestDegrees / 5)] = true;
        }

        return isThere;
    }

    /// <summary>The squares of selected parts; a part that is larger than a square is all of its squares.</summary>
    /// <param name="selection">Parts.</param>
    /// <param name="subdivisions">Squares to a tile's edge.</param>
    public static bool[] In(PartSelection selection, int subdivisions)
    {
        int columns = TileId.Columns * subdivisions;
        bool[] isThere = new bool[TileId.Rows * subdivisions * columns];
        foreach (SurfacePart part in selection.Parts)
        {
            int squares = subdivisions / part.Subdivisions;
            int firstRow = ((85 - part.Tile.SouthDegrees) / 5 * subdivisions) + (part.Row * squares);
            int firstColumn = (part.Tile.WestDegrees / 5 * subdivisions) + (part.Column * squares);
            for (int square = 0; square < squares * squares; square++)
            {
                isThere[((firstRow + (square / squares)) * columns) + firstColumn + (square % squares)] = true;
            }
        }

        return isThere;
    }
}
