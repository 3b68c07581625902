namespace Msisf.Adapters.Render;

/// <summary>What a PNG image's IHDR chunk says.</summary>
/// <param name="Width">px.</param>
/// <param name="Height">px.</param>
/// <param name="BitDepth">Bits a sample: 1, 2, 4, 8 or 16.</param>
/// <param name="ColorType">PNG's code: 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGB and alpha.</param>
public readonly record struct PngHeader(int Width, int Height, int BitDepth, int ColorType);
