namespace Msisf.Core.Detector;

/// <summary>Light that falls on the rows while a frame-transfer detector shifts them. Immutable.</summary>
public sealed record Smear
{
    /// <summary>Seconds in which a row is shifted by one row.</summary>
    public required double RowTime { get; init; }

    /// <summary>Whether the image is shifted towards its lower border; otherwise to the upper one.</summary>
    public bool TowardsBottom { get; init; } = true;

    /// <summary>
    /// Whether the rows were shifted in light before the exposure too, at the same speed, so that each row has passed all others.
    /// </summary>
    public bool BeforeExposure { get; init; } = true;
}
