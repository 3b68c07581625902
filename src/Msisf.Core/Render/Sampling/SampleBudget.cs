using System.Numerics;

namespace Msisf.Core.Render.Sampling;

/// <summary>Spreads samples over pixels of different contrast so that the least of them give the error that is asked for.</summary>
internal static class SampleBudget
{
    /// <summary>Part of the error that is spent on what is foreseen; the rest is for what no pixel's centre shows.</summary>
    private const double Used = 0.9;

    private static readonly byte[] Choices = [0, 1, 2, 4, 8];

    /// <summary>
    /// Rms error of a pixel with each of the choices over its contrast, for contrasts up to 1, 2, 4, ... 64 and above.
    /// </summary>
    private static readonly double[][] Errors =
    [
        [0.080, 0.135, 0.152, 0.168, 0.175, 0.178, 0.194, 0.233],
        [0.020, 0.035, 0.039, 0.046, 0.038, 0.038, 0.041, 0.047],
        [0.011, 0.020, 0.022, 0.026, 0.023, 0.023, 0.024, 0.028],
        [0.009, 0.014, 0.014, 0.015, 0.015, 0.015, 0.016, 0.017],
        [0.001, 0.001, 0.001, 0.002, 0.003, 0.003, 0.003, 0.004],
    ];

    /// <summary>Cost of each of the choices, in samples.</summary>
    private static readonly double[] Costs = [0.0, 12.0, 20.0, 36.0, 68.0];

    /// <summary>Number of vectors of samples for each contrast.</summary>
    /// <param name="histogram">Number of pixels of each contrast, levels of 255.</param>
    /// <param name="error">Rms error that is asked for, levels of 255.</param>
    public static byte[] VectorsOf(ReadOnlySpan<int> histogram, double error)
    {
        double pixels = 0.0;
        foreach (int count in histogram)
        {
            pixels += count;
        }

        double allowed = Used * Used * error * error * pixels;
        double low = 1e-12; // squared levels a sample: so little that all pixels get all samples
        double high = 1e12;
        byte[] best = Choose(histogram, low, out _);
        for (int step = 0; step < 60; step++)
        {
            double price = Math.Sqrt(low * high);
            byte[] choice = Choose(histogram, price, out double squares);
            if (squares <= allowed)
            {
                (low, best) = (price, choice);
            }
            else
            {
                high = price;
            }
        }

        return best;
    }

    private static byte[] Choose(ReadOnlySpan<int> histogram, double price, out double squares)
    {
        byte[] vectors = new byte[histogram.Length];
        squares = 0.0;
        for (int contrast = 1; contrast < vectors.Length; contrast++)
        {
            int bin = Math.Min(BitOperations.Log2((uint)(2 * contrast) - 1), Errors[0].Length - 1);
            double least = double.PositiveInfinity;
            double square = 0.0;
            for (int i = 0; i < Choices.Length; i++)
            {
                double error = Errors[i][bin] * contrast;
                double sum = (error * error) + (price * Costs[i]);
                if (sum < least)
                {
                    (least, square, vectors[contrast]) = (sum, error * error, Choices[i]);
                }
            }

            squares += histogram[contrast] * square;
        }

        return vectors;
    }
}
