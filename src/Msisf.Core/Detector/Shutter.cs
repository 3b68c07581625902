namespace Msisf.Core.Detector;

/// <summary>
/// When the rows of a detector are exposed, for images with the camera's motion. The frame's time is the middle of the exposure, of a
/// rolling shutter that of its middle row. Immutable.
/// </summary>
public sealed record Shutter
{
    /// <summary>px: the default of <see cref="MaxStep"/>.</summary>
    public const double DefaultMaxStep = 0.25;

    /// <summary>Seconds from the exposure of a row to that of the row below; 0 for a global shutter.</summary>
    public double LineTime { get; init; }

    /// <summary>Whether the rows are exposed one after another.</summary>
    public bool IsRolling => LineTime > 0.0;

    /// <summary>px: how far the image may move from one sub-exposure to the next.</summary>
    public double MaxStep { get; init; } = DefaultMaxStep;

    /// <summary>Seconds from the start of the first row's exposure to the end of the last row's.</summary>
    /// <param name="exposureTime">s, of one row.</param>
    /// <param name="height">px.</param>
    public double Span(double exposureTime, int height) => exposureTime + (LineTime * (height - 1));
}
