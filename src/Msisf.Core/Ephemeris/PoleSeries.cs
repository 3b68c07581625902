namespace Msisf.Core.Ephemeris;

/// <summary>One angle of a body's orientation: a polynomial of time and a sum of periodic terms, in degrees.</summary>
/// <param name="Coefficients">Coefficients, that of the constant term first.</param>
/// <param name="Amplitudes">Amplitudes of the periodic terms; not more than there are angles.</param>
public sealed record PoleSeries(IReadOnlyList<double> Coefficients, IReadOnlyList<double> Amplitudes)
{
    /// <summary>The angle at a time, degrees.</summary>
    /// <param name="time">In the unit of the polynomial.</param>
    /// <param name="angles">Angles of the periodic terms, rad.</param>
    /// <param name="wave">Sine or cosine.</param>
    internal double At(double time, ReadOnlySpan<double> angles, Func<double, double> wave)
    {
        double value = Polynomial(Coefficients, time);
        for (int term = 0; term < Amplitudes.Count; term++)
        {
            if (Amplitudes[term] != 0.0)
            {
                value += Amplitudes[term] * wave(angles[term]);
            }
        }

        return value;
    }

    /// <summary>How fast the angle changes, degrees in the polynomial's unit of time.</summary>
    /// <param name="time">In that unit.</param>
    /// <param name="angles">Angles of the periodic terms, rad.</param>
    /// <param name="rates">Their rates, rad in that unit.</param>
    /// <param name="slope">Derivative of the sine or cosine.</param>
    internal double RateAt(double time, ReadOnlySpan<double> angles, ReadOnlySpan<double> rates, Func<double, double> slope)
    {
        double rate = Slope(Coefficients, time);
        for (int term = 0; term < Amplitudes.Count; term++)
        {
            if (Amplitudes[term] != 0.0)
            {
                rate += Amplitudes[term] * rates[term] * slope(angles[term]);
            }
        }

        return rate;
    }

    /// <summary>The derivative of a polynomial, its constant term first.</summary>
    internal static double Slope(IReadOnlyList<double> coefficients, double x)
    {
        double slope = 0.0;
        for (int i = coefficients.Count - 1; i > 0; i--)
        {
            slope = (slope * x) + (i * coefficients[i]);
        }

        return slope;
    }

    /// <summary>The value of a polynomial, its constant term first.</summary>
    internal static double Polynomial(IReadOnlyList<double> coefficients, double x)
    {
        double value = 0.0;
        for (int i = coefficients.Count - 1; i >= 0; i--)
        {
            value = (value * x) + coefficients[i];
        }

        return value;
    }
}
