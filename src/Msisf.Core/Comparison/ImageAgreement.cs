namespace Msisf.Core.Comparison;

/// <summary>How well a drawn image agrees with a real one after one factor.</summary>
/// <param name="Count">Pixels that both have.</param>
/// <param name="Correlation">Pearson's, -1 to 1; null where one of the images is the same everywhere.</param>
/// <param name="Factor">By which the drawn one is multiplied: the one of least squares.</param>
/// <param name="Rms">
/// Root mean square of the differences after the factor, as a part of the real image's mean; null where that is 0.
/// </param>
public sealed record ImageAgreement(int Count, double? Correlation, double Factor, double? Rms)
{
    /// <summary>Compares two images.</summary>
    /// <param name="real">By rows; NaN where there is no value.</param>
    /// <param name="drawn">The same size.</param>
    /// <param name="isChosen">Whether a pixel counts; null for all.</param>
    /// <returns>Null if fewer than two pixels count, or nothing is drawn in them.</returns>
    public static ImageAgreement? Of(ReadOnlySpan<float> real, ReadOnlySpan<float> drawn, Func<int, bool>? isChosen = null)
    {
        ArgumentOutOfRangeException.ThrowIfNotEqual(drawn.Length, real.Length);
        (int count, double ofReal, double ofDrawn, double product, double square) = (0, 0.0, 0.0, 0.0, 0.0);
        for (int i = 0; i < real.Length; i++)
        {
            if (Counts(real[i], drawn[i], i, isChosen))
            {
                count++;
                ofReal += real[i];
                ofDrawn += drawn[i];
                product += (double)real[i] * drawn[i];
                square += (double)drawn[i] * drawn[i];
            }
        }

        if (count < 2 || square == 0.0)
        {
            return null;
        }

        (double factor, double meanReal, double meanDrawn) = (product / square, ofReal / count, ofDrawn / count);
        (double covariance, double ofRealSquares, double ofDrawnSquares, double ofErrors) = (0.0, 0.0, 0.0, 0.0);
        for (int i = 0; i < real.Length; i++)
        {
            if (Counts(real[i], drawn[i], i, isChosen))
            {
                (double r, double d, double error) = (real[i] - meanReal, drawn[i] - meanDrawn, real[i] - (factor * drawn[i]));
                covariance += r * d;
                ofRealSquares += r * r;
                ofDrawnSquares += d * d;
                ofErrors += error * error;
            }
        }

        double spread = Math.Sqrt(ofRealSquares) * Math.Sqrt(ofDrawnSquares);
        return new ImageAgreement(
            count, spread > 0.0 ? covariance / spread : null, factor,
            meanReal != 0.0 ? Math.Sqrt(ofErrors / count) / meanReal : null);
    }

    /// <summary>Whether both images have a pixel.</summary>
    public static bool IsIn(float real, float drawn) => float.IsFinite(real) && float.IsFinite(drawn);

    private static bool Counts(float real, float drawn, int index, Func<int, bool>? isChosen) =>
        IsIn(real, drawn) && (isChosen is null || isChosen(index));
}
