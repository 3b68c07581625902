using System.Numerics;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// The kinds of pixels that get the same number of samples: by the contrast of the 3 x 3 pixels around, by whether light and shade meet
/// there, and by how the facets of the neighbours lie to that of the pixel.
/// </summary>
internal static class PixelClass
{
    public const int Count = 2 * FacetKinds * Contrasts;

    private const int Contrasts = 9;

    private const int FacetKinds = (int)FacetsAround.Other + 1;

    private static readonly byte[] Bins = [.. Enumerable.Range(0, byte.MaxValue + 1).Select(BinOf)];

    /// <summary>The class of a pixel.</summary>
    /// <param name="contrast">Contrast, levels of 255.</param>
    /// <param name="isShaded">Whether lit pixels and others meet.</param>
    /// <param name="facets">How the facets of the neighbours lie to its own.</param>
    public static byte Of(byte contrast, bool isShaded, FacetsAround facets) =>
        (byte)(Bins[contrast] + (isShaded ? Contrasts : 0) + (2 * Contrasts * (int)facets));

    /// <summary>Greatest contrast of a class, levels of 255.</summary>
    public static double ContrastOf(int pixelClass) => (pixelClass % Contrasts) switch
    {
        0 => 0.0,
        Contrasts - 1 => 255.0,
        int bin => Math.ScaleB(1.0, bin - 1),
    };

    /// <summary>Smallest contrast of a class, levels of 255.</summary>
    public static int MinContrastOf(int pixelClass) => (pixelClass % Contrasts) switch
    {
        0 => 0,
        1 => 1,
        int bin => (1 << (bin - 2)) + 1,
    };

    /// <summary>How the facets of the neighbours lie to those of a class's pixels.</summary>
    public static FacetsAround FacetsOf(int pixelClass) => (FacetsAround)(pixelClass / (2 * Contrasts));

    /// <summary>0 without contrast, 1 for a contrast of 1, 2 up to 2, 3 up to 4 and so on.</summary>
    private static byte BinOf(int contrast) =>
        contrast == 0 ? (byte)0 : (byte)Math.Min(1 + BitOperations.Log2((uint)(2 * contrast) - 1), Contrasts - 1);
}
