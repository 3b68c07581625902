using Msisf.Core.Camera;

namespace Msisf.Adapters.CameraExport;

/// <summary>How an image was scanned, for camera models of other programs.</summary>
/// <param name="Kind">What an exposure adds to the image.</param>
/// <param name="Period">s from one exposure to the next.</param>
/// <param name="GrowsUpwards">Whether the first exposure is the lowest of the image.</param>
/// <param name="FlipsFramelets">Whether the rows of each framelet are read from the lowest to the topmost.</param>
/// <param name="States">States of all exposures, the first one's first.</param>
/// <param name="HeightOverTerrain">Height of the camera over the terrain, m.</param>
public sealed record ExportedScan(
    ScanKind Kind, double Period, bool GrowsUpwards, bool FlipsFramelets, IReadOnlyList<CameraState> States, double HeightOverTerrain)
{
    /// <summary>Number of exposures.</summary>
    public int Count => States.Count;

    /// <summary>s: the middle of the first exposure after the image's time.</summary>
    public double FirstSeconds => States[0].Seconds;

    /// <summary>The image of a detector whose shutter rolls, which shows its rows at the times of their own.</summary>
    /// <param name="middle">The camera at the frame's time, which is that of its middle row.</param>
    /// <param name="motion">How it moves.</param>
    /// <param name="lineTime">s from a row to the row below.</param>
    /// <param name="heightOverTerrain">Height of the camera over the terrain, m.</param>
    public static ExportedScan OfShutter(FrameCamera middle, CameraMotion motion, double lineTime, double heightOverTerrain) => new(
        ScanKind.RollingShutter, lineTime, GrowsUpwards: false, FlipsFramelets: false,
        [.. Enumerable.Range(0, middle.Height).Select(row => motion.Moved(middle.State, lineTime * (row - (0.5 * (middle.Height - 1)))))],
        heightOverTerrain);
}
