namespace Msisf.Stress.Camera;

/// <summary>A pixel and the image that it is of.</summary>
/// <param name="Width">px.</param>
/// <param name="Height">px.</param>
/// <param name="X">From 1, right.</param>
/// <param name="Y">From 1, down.</param>
public readonly record struct PixelFrame(int Width, int Height, int X, int Y);
