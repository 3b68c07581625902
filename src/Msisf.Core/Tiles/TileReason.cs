namespace Msisf.Core.Tiles;

/// <summary>Why a tile is kept or dropped.</summary>
public enum TileReason
{
    /// <summary>Kept: some of it can be seen, perhaps in sunlight.</summary>
    Visible,

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
