namespace Msisf.Core.Numerics;

/// <summary>
/// Polynomials through samples, as the weight that each sample has in the value at a time; so one set of weights serves the components of
/// positions, quaternions, ... . The times of the samples must differ; they need not be evenly spaced.
/// </summary>
public static class SampleWeights
{
    /// <summary>How many samples a polynomial may pass through: those of degree 63 (Hermite), the highest that any format allows.</summary>
    public const int MaxSamples = 32;

    /// <summary>The polynomial of the least degree through all values.</summary>
    /// <param name="time">The time asked for, in the same unit.</param>
    /// <param name="values">Gets the weight of each value in the value at the time.</param>
    /// <param name="rates">Gets the weight of each value in the derivative at the time.</param>
    public static void Lagrange(ReadOnlySpan<double> times, double time, Span<double> values, Span<double> rates)
    {
        for (int j = 0; j < times.Length; j++)
        {
            (values[j], rates[j]) = LagrangeBasis(times, j, time);
        }
    }

    /// <summary>The polynomial of the least degree through all values that has the given derivatives there.</summary>
    /// <param name="time">The time asked for, in the same unit.</param>
    /// <param name="ofValues">Gets the weights of the values: in the value at the time, in its derivative.</param>
    /// <param name="ofRates">Gets the weights of the derivatives.</param>
    public static void Hermite(
        ReadOnlySpan<double> times, double time, Span<(double Value, double Rate)> ofValues, Span<(double Value, double Rate)> ofRates)
    {
        for (int j = 0; j < times.Length; j++)
        {
            double slope = 0.0; // of the Lagrange basis at its own sample
            for (int m = 0; m < times.Length; m++)
            {
                slope += m == j ? 0.0 : 1.0 / (times[j] - times[m]);
            }

            (double basis, double basisRate) = LagrangeBasis(times, j, time);
            (double square, double squareRate) = (basis * basis, 2.0 * basis * basisRate);
            double after = time - times[j];
            double factor = 1.0 - (2.0 * slope * after);
            ofValues[j] = (factor * square, (factor * squareRate) - (2.0 * slope * square));
            ofRates[j] = (after * square, (after * squareRate) + square);
        }
    }

    /// <summary>The polynomial that is 1 at one sample and 0 at all others, and its derivative.</summary>
    private static (double Value, double Rate) LagrangeBasis(ReadOnlySpan<double> times, int j, double time)
    {
        (double value, double rate) = (1.0, 0.0);
        for (int m = 0; m < times.Length; m++)
        {
            if (m != j)
            {
                double distance = times[j] - times[m];
                double part = (time - times[m]) / distance;
                rate = (rate * part) + (value / distance);
                value *= part;
            }
        }

        return (value, rate);
    }
}
