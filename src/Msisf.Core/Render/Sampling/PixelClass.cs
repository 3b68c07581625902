using System.Numerics;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// The kinds of pixels that get the same number of samples: by the contrast of the 3 x 3 pixels around, by whether light and shade meet
/// there, and by whether facets are about as small as pixels.
/// </summary>
internal static class PixelClass
{
    /// <summary>Number of classes.</summary>
    public const int Count = 4 * Contrasts;

    private const int Contrasts = 9;

    /// <summary>The class of a pixel.</summary>
    /// <param name="contrast">Contrast, levels of 255.</param>
    /// <param name="isShaded">Whether lit pixels and others meet.</param>
    /// <param name="isAlone">Whether it shows another facet than its four neighbours.</param>
    public static byte Of(int contrast, bool isShaded, bool isAlone) =>
        (byte)((contrast > 0 ? BinOf(contrast) : 0) + (isShaded ? Contrasts : 0) + (isAlone ? 2 * Contrasts : 0));

    /// <summary>Greatest contrast of a class, levels of 255.</summary>
    public static double ContrastOf(int pixelClass) => (pixelClass % Contrasts) switch
    {
        0 => 0.0,
        Contrasts - 1 => 255.0,
        int bin => Math.ScaleB(1.0, bin - 1),
    };

    /// <summary>1 for a contrast of 1, 2 up to 2, 3 up to 4 and so on.</summary>
    private static int BinOf(int contrast) => Math.Min(1 + BitOperations.Log2((uint)(2 * contrast) - 1), Contrasts - 1);
}
