using System.Runtime.Intrinsics;

namespace Msisf.Core.Detector.Noise;

/// <summary>Probabilities of numbers of events. Made of exact operations only, so every machine gets the same numbers.</summary>
internal static class PoissonProbability
{
    /// <summary>From this count on, Stirling's series of four terms is exact to 2e-14.</summary>
    private const int FirstOfSeries = 16;

    /// <summary>Terms below this part of a sum do not change it.</summary>
    private const double NegligibleTerm = 1e-17;

    /// <summary>The probability of a number of events; relative error about 1e-15 times the mean's root near the mean.</summary>
    /// <param name="count">Whole number, at least 0.</param>
    /// <param name="mean">Above 0; e^-mean is a normal number, or the count is near the mean.</param>
    public static double Of(double count, double mean)
    {
        if (count < FirstOfSeries)
        {
            double product = Exp(-mean);
            for (int factor = 1; factor <= (int)count; factor++)
            {
                product *= mean / factor;
            }

            return product;
        }

        // n! = n^n e^-n sqrt(2 pi n) e^series, and n log n goes into a quotient, so that large numbers do not cancel.
        double inverse = 1.0 / count;
        double square = inverse * inverse;
        double series = inverse * ((1.0 / 12.0) - (square * ((1.0 / 360.0) - (square * ((1.0 / 1260.0) - (square / 1680.0))))));
        double exponent = (count * Log(mean * inverse)) + (count - mean) - series;
        return Exp(exponent) / Math.Sqrt(2.0 * Math.PI * count);
    }

    /// <summary>P(N &lt;= count).</summary>
    public static double OfAtMost(double count, double probability, double mean)
    {
        double sum = 0.0;
        for (; probability > NegligibleTerm * sum; count--)
        {
            sum += probability;
            probability *= count / mean;
        }

        return sum;
    }

    /// <summary>P(N &gt; count).</summary>
    public static double OfMoreThan(double count, double probability, double mean)
    {
        double sum = 0.0;
        do
        {
            count++;
            probability *= mean / count;
            sum += probability;
        }
        while (probability > NegligibleTerm * sum);
        return sum;
    }

    private static double Exp(double x) => PortableLanes.Exp(Vector512.Create(x))[0];

    private static double Log(double x) => PortableLanes.Log(Vector512.Create(x))[0];
}
