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

    /// <summary>The same selection, in which visible tiles that the thesis's rays do not hit are <see cref="TileReason.Relief"/>.</summary>
    /// <param name="hit">The tiles that the rays hit (<see cref="SphereRays"/>).</param>
    public TileSelection WithRays(IReadOnlySet<TileId> hit) => new(All.Select(choice =>
        choice.Reason == TileReason.Visible && !hit.Contains(choice.Tile) ? choice with { Reason = TileReason.Relief } : choice));
}

/// <summary>The decision whether a scene needs a tile.</summary>
public readonly record struct TileChoice(TileId Tile, TileReason Reason)
{
    /// <summary>Whether the scene needs the tile.</summary>
    public bool IsKept =>
        Reason is TileReason.Visible or TileReason.Relief or TileReason.DarkButCovering or TileReason.CastsShadow;

    /// <summary>The reason in words for a list.</summary>
    public string ReasonText => Reason switch
    {
        TileReason.Visible => "visible",
        TileReason.Relief => "visible relief, no ray hits the sphere there",
        TileReason.DarkButCovering => "dark, covers what lies behind",
        TileReason.CastsShadow => "casts shadow",
        TileReason.OutsideFrame => "outside the frame",
        TileReason.Hidden => "behind the limb",
        TileReason.Night => "night",
        _ => throw new InvalidOperationException($"No text for {Reason}."),
    };
}

/// <summary>Why a tile is kept or dropped.</summary>
public enum TileReason
{
    /// <summary>Kept: some of it can be seen, perhaps in sunlight.</summary>
    Visible,

    /// <summary>Kept: some of its relief can be seen, though no pixel's ray hits the reference sphere there.</summary>
    Relief,

    /// <summary>Kept: it can be seen and is dark, but without it ground behind it would show.</summary>
    DarkButCovering,

    /// <summary>Kept: its shadow can fall on visible ground.</summary>
    CastsShadow,

    /// <summary>Dropped: no ray of the image passes through it.</summary>
    OutsideFrame,

    /// <summary>Dropped: nearer terrain or the limb hides all of it that is in the image.</summary>
    Hidden,

    /// <summary>Dropped: all of it that can be seen is certainly dark, as black as the sky.</summary>
    Night,
}
