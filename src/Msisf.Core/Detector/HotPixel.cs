namespace Msisf.Core.Detector;

/// <summary>A pixel of much dark current.</summary>
/// <param name="X">From 1, to the right.</param>
/// <param name="Y">From 1, down.</param>
/// <param name="Rate">Electrons per second at the reference temperature of the dark current, in place of the other pixels' rate.</param>
public readonly record struct HotPixel(int X, int Y, double Rate);
