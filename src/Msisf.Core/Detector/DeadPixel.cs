namespace Msisf.Core.Detector;

/// <summary>A pixel that does not respond to light.</summary>
/// <param name="X">From 1, to the right.</param>
/// <param name="Y">From 1, down.</param>
public readonly record struct DeadPixel(int X, int Y);
