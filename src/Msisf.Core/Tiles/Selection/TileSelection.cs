namespace Msisf.Core.Tiles.Selection;

/// <summary>The tiles that an image needs, and why the others are not needed.</summary>
public sealed class TileSelection
{
    internal TileSelection(IEnumerable<TileChoice> choices)
    {
        All = [.. choices.OrderBy(choice => choice.Tile)];
        Kept = [.. All.Where(choice => choice.IsKept)];
    }

    /// <summary>All 2,592 tiles, by latitude, then longitude.</summary>
    public IReadOnlyList<TileChoice> All { get; }

    /// <summary>The tiles to load, by latitude, then longitude.</summary>
    public IReadOnlyList<TileChoice> Kept { get; }
}
