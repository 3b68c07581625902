namespace Msisf.Core.Detector.Psf;

/// <summary>Integrals of a radial function over the pixels of a square.</summary>
internal static class PixelIntegrals
{
    /// <summary>Maximum number of steps along a pixel's edge: for functions narrower than 1/16 of a pixel.</summary>
    private const int MaxSteps = 32;

    // Gauss-Legendre rule of 8 points on [-1, 1]: Abramowitz and Stegun, table 25.4. MathNet's has other last digits: images would have
    // other bytes.
    private static readonly double[] Nodes = [0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363];
    private static readonly double[] NodeWeights = [0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763];

    /// <summary>Integrates a function that ends at a radius over square pixels.</summary>
    /// <param name="cutoff">px: the function is 0 beyond.</param>
    /// <param name="pixelSide">px: side of the pixels; 1, or less to look into a pixel.</param>
    /// <returns>By rows; the central pixel has the function's centre in its middle. Not normalised.</returns>
    public static double[] Of(IRadialSpread spread, double cutoff, double pixelSide)
    {
        int radius = Math.Max(0, (int)Math.Ceiling((cutoff / pixelSide) - 0.5));
        int size = (2 * radius) + 1;
        double[] integrals = new double[size * size];
        for (int row = 0; row <= radius; row++)
        {
            for (int column = row; column <= radius; column++)
            {
                double integral = OfPixel(spread, cutoff, column * pixelSide, row * pixelSide, pixelSide);
                foreach ((int y, int x) in (ReadOnlySpan<(int, int)>)[(row, column), (column, row)])
                {
                    integrals[((radius + y) * size) + radius + x] = integral;
                    integrals[((radius + y) * size) + radius - x] = integral;
                    integrals[((radius - y) * size) + radius + x] = integral;
                    integrals[((radius - y) * size) + radius - x] = integral;
                }
            }
        }

        return integrals;
    }

    private static double OfPixel(IRadialSpread spread, double cutoff, double centreX, double centreY, double side)
    {
        double left = centreX - (0.5 * side);
        double right = Math.Min(centreX + (0.5 * side), cutoff);
        return right <= left ? 0.0 : Integrate(left, right, spread.Scale, x =>
        {
            // The part of the column that lies in the circle.
            double reach = Math.Sqrt(Math.Max(0.0, (cutoff * cutoff) - (x * x)));
            double bottom = Math.Max(centreY - (0.5 * side), -reach);
            double top = Math.Min(centreY + (0.5 * side), reach);
            return top <= bottom ? 0.0 : Integrate(bottom, top, spread.Scale, y => spread.At(double.Hypot(x, y)));
        });
    }

    private static double Integrate(double from, double to, double scale, Func<double, double> function)
    {
        int steps = (int)Math.Clamp(Math.Ceiling((to - from) / (0.5 * scale)), 1.0, MaxSteps);
        double half = 0.5 * (to - from) / steps;
        double sum = 0.0;
        for (int step = 0; step < steps; step++)
        {
            double middle = from + (((2 * step) + 1) * half);
            for (int node = 0; node < Nodes.Length; node++)
            {
                double offset = half * Nodes[node];
                sum += NodeWeights[node] * (function(middle - offset) + function(middle + offset));
            }
        }

        return sum * half;
    }
}
