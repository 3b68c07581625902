namespace Msisf.App.Settings;

/// <summary>What is made of the images of a run when all are there.</summary>
/// <param name="ContactSheet">One image of many small ones.</param>
/// <param name="FrameRate">Frames a second of a video; null for none.</param>
internal sealed record MergeSettings(bool ContactSheet, double? FrameRate);
