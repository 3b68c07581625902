namespace Msisf.Synthesis;

/// <summary>
/// Smooth interpolation (C1) of pixel means: the mean of the n x n samples inside each pixel is again that pixel's value. It uses three
/// pixels on each side, so a tile needs a margin of three pixels only.
/// </summary>
/// <remarks>
/// Quadratic B-splines with knots at half pixels. Their weights are the only symmetric ones of this width that give 1 for the pixel's own
/// mean and 0 for every other pixel's mean, and that reproduce constants, straight lines and parabolas; the sums are over the n midpoints
/// of a pixel, not integrals, so the means are exact for any even n.
/// </remarks>
internal sealed class PixelMeanKernel
{
    /// <summary>Number of pixels that are needed beyond the outermost one.</summary>
    public const int Reach = 3;

    private readonly double[] _taps;
    private readonly int[] _firstCoefficient;
    private readonly double[] _weights;

    /// <summary>Makes the weights for n samples a pixel.</summary>
    /// <param name="samplesPerPixel">n along each axis.</param>
    public PixelMeanKernel(int samplesPerPixel)
    {
        _taps = Taps(samplesPerPixel);
        _firstCoefficient = new int[samplesPerPixel];
        _weights = new double[3 * samplesPerPixel];
        for (int sample = 0; sample < samplesPerPixel; sample++)
        {
            (_firstCoefficient[sample], _weights[3 * sample], _weights[(3 * sample) + 1], _weights[(3 * sample) + 2]) =
                Within((((2.0 * sample) + 1.0) / samplesPerPixel) - 1.0);
        }
    }

    /// <summary>How many spline coefficients belong to a run of pixels.</summary>
    public static int CoefficientCount(int pixels) => (2 * pixels) + 3;

    /// <summary>Spline coefficients of a run of pixels.</summary>
    /// <param name="means">
    /// The pixels' means, with <see cref="Reach"/> more at each end; consecutive ones are <paramref name="step"/> apart.
    /// </param>
    /// <param name="coefficients">Filled with <see cref="CoefficientCount"/> values, also <paramref name="step"/> apart.</param>
    /// <param name="pixels">Number of pixels, without the additional ones at the ends.</param>
    /// <param name="step">Distance of consecutive values in the array: 1 along a line, the length of a line along a column.</param>
    public void Coefficients(ReadOnlySpan<double> means, Span<double> coefficients, int pixels, int step)
    {
        for (int k = 0; k < CoefficientCount(pixels); k++)
        {
            int centre = (k / 2) + 2;
            double M(int offset, ReadOnlySpan<double> values) => values[(centre + offset) * step];
            coefficients[k * step] = k % 2 == 0
                ? (_taps[0] * M(0, means)) + (_taps[2] * (M(-1, means) + M(1, means))) + (_taps[4] * (M(-2, means) + M(2, means)))
                : (_taps[1] * (M(0, means) + M(1, means))) + (
                    _taps[3] * (M(-1, means) + M(2, means))) + (_taps[5] * (M(-2, means) + M(3, means)));
        }
    }

    /// <summary>Index of the first of the three coefficients, and their weights, for a sample of a pixel.</summary>
    /// <param name="pixel">Counted from the first one of the run.</param>
    /// <param name="sample">0 to n - 1 inside the pixel.</param>
    public (int First, double Weight0, double Weight1, double Weight2) At(int pixel, int sample) =>
        ((2 * pixel) + _firstCoefficient[sample], _weights[3 * sample], _weights[(3 * sample) + 1], _weights[(3 * sample) + 2]);

    /// <summary>Index of the first of the three coefficients, and their weights, for a place between the samples.</summary>
    /// <param name="pixels">Pixels from the left border of the run's first one.</param>
    public static (int First, double Weight0, double Weight1, double Weight2) At(double pixels)
    {
        double pixel = Math.Floor(pixels);
        (int first, double w0, double w1, double w2) = Within((2.0 * (pixels - pixel)) - 1.0);
        return ((2 * (int)pixel) + first, w0, w1, w2);
    }

    /// <param name="position">Half pixels from the pixel's centre, -1 to 1.</param>
    private static (int First, double Weight0, double Weight1, double Weight2) Within(double position)
    {
        double nearest = Math.Floor(position + 0.5);
        double f = position - nearest;
        return ((int)nearest + 1, 0.5 * (0.5 - f) * (0.5 - f), 0.75 - (f * f), 0.5 * (0.5 + f) * (0.5 + f));
    }

    // Unknown weights h0..h5 of the splines 0..5 half pixels away. tail: mean, over the neighbouring pixel, of the spline at a pixel's
    // centre; variance: mean of x^2 over a pixel's midpoints. The equations: sums over even and odd splines are 1; parabolas; means 0 two
    // and three pixels away. Solved on paper: a solver would round.
    private static double[] Taps(int n)
    {
        double tail = 0.0;
        for (int sample = 0; sample < n; sample++)
        {
            double d = 0.5 - (((2.0 * sample) + 1.0) / n);
            tail += d > 0.0 ? 0.5 * d * d / n : 0.0;
        }

        double variance = (1.0 - (1.0 / ((double)n * n))) / 12.0;
        double even = (0.0625 + variance) / 2.0;
        double odd = (0.3125 + variance) / 4.0;
        double h4 = ((tail * even) + (0.25 * odd)) / (0.5 - (4.0 * tail));
        double h5 = -4.0 * tail * h4;
        double h2 = -even - (4.0 * h4);
        double h3 = -odd - (3.0 * h5);
        return [1.0 - (2.0 * (h2 + h4)), 0.5 - h3 - h5, h2, h3, h4, h5];
    }
}
