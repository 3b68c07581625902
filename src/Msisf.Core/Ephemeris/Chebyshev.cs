namespace Msisf.Core.Ephemeris;

/// <summary>Chebyshev series, in which SPK and PCK kernels keep their data.</summary>
public static class Chebyshev
{
    /// <summary>The sum of c[k] T_k(x).</summary>
    /// <param name="coefficients">c[0], c[1], ...; at least one.</param>
    /// <param name="x">In [-1, 1].</param>
    /// <remarks>
    /// Clenshaw's recurrence with CSPICE's order of operations (CHBINT). The order matters: the Moon's rotation angle is some
    /// thousand radians, where one unit in the last place turns the Sun by 1e-12.
    /// </remarks>
    public static double Evaluate(ReadOnlySpan<double> coefficients, double x)
    {
        double twice = 2.0 * x;
        double current = 0.0;
        double previous = 0.0;
        for (int k = coefficients.Length - 1; k > 0; k--)
        {
            double beforePrevious = previous;
            previous = current;
            current = coefficients[k] + ((twice * previous) - beforePrevious);
        }

        return ((x * current) - previous) + coefficients[0];
    }

    /// <summary>The derivative by x of the sum of c[k] T_k(x).</summary>
    /// <param name="coefficients">c[0], c[1], ...; at least one.</param>
    /// <param name="x">In [-1, 1].</param>
    /// <remarks>The derivative of each step of the recurrence above, as in CHBINT.</remarks>
    public static double Derivative(ReadOnlySpan<double> coefficients, double x)
    {
        double twice = 2.0 * x;
        double current = 0.0;
        double previous = 0.0;
        double currentRate = 0.0;
        double previousRate = 0.0;
        for (int k = coefficients.Length - 1; k > 0; k--)
        {
            double beforePrevious = previous;
            previous = current;
            current = coefficients[k] + ((twice * previous) - beforePrevious);
            double beforePreviousRate = previousRate;
            previousRate = currentRate;
            currentRate = (2.0 * previous) + (twice * previousRate) - beforePreviousRate;
        }

        return current + ((x * currentRate) - previousRate);
    }
}
