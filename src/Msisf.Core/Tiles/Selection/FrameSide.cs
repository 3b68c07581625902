namespace Msisf.Core.Tiles.Selection;

/// <summary>Where something lies against the image.</summary>
internal enum FrameSide
{
    /// <summary>Certainly not in it.</summary>
    Outside,

    /// <summary>Perhaps partly.</summary>
    Straddling,

    /// <summary>Wholly in it.</summary>
    Inside,
}
