namespace Msisf.Core.Tiles;

/// <summary>The decision whether a scene needs a tile.</summary>
/// <param name="Tile">The tile.</param>
/// <param name="Reason">Reason for the decision.</param>
public readonly record struct TileChoice(TileId Tile, TileReason Reason)
{
    /// <summary>Whether the scene needs the tile.</summary>
    public bool IsKept => Reason is TileReason.Visible or TileReason.DarkButCovering or TileReason.CastsShadow;

    /// <summary>The reason in words for a list.</summary>
    public string ReasonText => Reason switch
    {
        TileReason.Visible => "visible",
        TileReason.DarkButCovering => "dark, covers what lies behind",
        TileReason.CastsShadow => "casts shadow",
        TileReason.OutsideFrame => "outside the frame",
        TileReason.Hidden => "behind the limb",
        TileReason.Night => "night",
        _ => throw new InvalidOperationException($"No text for {Reason}."),
    };
}
