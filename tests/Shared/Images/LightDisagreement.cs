namespace Msisf.TestSupport.Images;

/// <summary>
/// How often an image is dark where the truth is lit, or lit where it is dark. Only pixels count about which the truth has no doubt: all
/// its samples show the surface, and all of them are lit or none is. A pixel on the edge of a shadow is neither.
/// </summary>
/// <param name="Pixels">Pixels that count.</param>
/// <param name="DarkInstead">Of these, lit in truth and dark in the image.</param>
/// <param name="LitInstead">Of these, dark in truth and lit in the image.</param>
internal readonly record struct LightDisagreement(int Pixels, int DarkInstead, int LitInstead)
{
    /// <summary>
    /// Level of 255 from which on a pixel is lit: I/F 0.004, an antialiased edge beside the pixel gives no more. Facets that the Sun grazes
    /// stay below it by rights, so pixels count as lit in truth from <see cref="SurelyLit"/> on.
    /// </summary>
    private const double MinLit = 13.0;

    private const double SurelyLit = 26.0;

    /// <summary>Of the pixels that count, 0 to 1; 0 if none does.</summary>
    public double Fraction => Pixels == 0 ? 0.0 : (double)(DarkInstead + LitInstead) / Pixels;

    /// <summary>Compares.</summary>
    /// <param name="coverage">Part of each pixel's samples that show the surface, [y, x], 0 to 1.</param>
    /// <param name="litFraction">Part of them that are lit, [y, x].</param>
    /// <param name="truth">Grey levels of 255, [y, x].</param>
    /// <param name="image">Grey levels of 255, [y, x].</param>
    public static LightDisagreement Of(double[,] coverage, double[,] litFraction, double[,] truth, double[,] image)
    {
        ImageSize.Check(truth, image);
        int pixels = 0;
        int dark = 0;
        int lit = 0;
        for (int y = 0; y < truth.GetLength(0); y++)
        {
            for (int x = 0; x < truth.GetLength(1); x++)
            {
                bool isWhole = coverage[y, x] >= 1.0;
                bool isLit = isWhole && litFraction[y, x] >= 1.0 && truth[y, x] >= SurelyLit;
                bool isDark = isWhole && litFraction[y, x] <= 0.0;
                pixels += isLit || isDark ? 1 : 0;
                dark += isLit && image[y, x] < MinLit ? 1 : 0;
                lit += isDark && image[y, x] >= MinLit ? 1 : 0;
            }
        }

        return new LightDisagreement(pixels, dark, lit);
    }
}
