namespace Msisf.App.Settings;

/// <summary>The files to make when all images of a run are complete.</summary>
/// <param name="ContactSheet">Whether to make one image of many small images.</param>
/// <param name="FrameRate">Frame rate of a video, frames per second; null for no video.</param>
internal sealed record MergeSettings(bool ContactSheet, double? FrameRate);
