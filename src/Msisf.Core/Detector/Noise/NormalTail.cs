namespace Msisf.Core.Detector.Noise;

/// <summary>The upper tail of the normal distribution.</summary>
internal static class NormalTail
{
    /// <summary>Probability that a normal number of mean 0 is above a limit.</summary>
    /// <param name="deviation">Standard deviation; 0 for a number that is always 0.</param>
    /// <returns>0 to 1, right to 7.5e-8.</returns>
    /// <remarks>M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions, 26.2.17.</remarks>
    public static double Beyond(double limit, double deviation)
    {
        if (deviation == 0.0)
        {
            return limit > 0.0 ? 0.0 : 1.0;
        }

        double x = Math.Abs(limit / deviation);
        double t = 1.0 / (1.0 + (0.2316419 * x));
        double polynomial = t * (0.319381530 + (t * (-0.356563782 + (t * (1.781477937 + (t * (-1.821255978 + (t * 1.330274429))))))));
        double tail = Math.Exp(-0.5 * x * x) / Math.Sqrt(2.0 * Math.PI) * polynomial;
        return limit > 0.0 ? tail : 1.0 - tail;
    }
}
