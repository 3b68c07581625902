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
}
