using Msisf.Core.Numerics;

namespace Msisf.Stress.Numerics;

/// <summary>Kepler's equation in double-double.</summary>
internal static class WideKepler
{
    /// <summary>E - e sin E - M; nothing cancels that the residual needs, whatever e and E.</summary>
    public static DoubleDouble Residual(DoubleDouble angle, double eccentricity, DoubleDouble meanAnomaly)
    {
        DoubleDouble mean = (OneMinus(eccentricity) * angle) + WideMath.Multiply(eccentricity, WideMath.MinusSine(angle));
        return WideMath.Subtract(mean, meanAnomaly);
    }

    /// <summary>The slope of the residual, 1 - e cos E: the distance over a.</summary>
    public static DoubleDouble Slope(DoubleDouble angle, double eccentricity) =>
        OneMinus(eccentricity) + WideMath.Multiply(eccentricity, WideMath.MinusCosine(angle));

    /// <summary>The eccentric anomaly, from one that is right to about 15 digits: each of two Newton steps doubles them.</summary>
    public static DoubleDouble Solve(double nearby, double eccentricity, DoubleDouble meanAnomaly)
    {
        DoubleDouble angle = WideMath.Of(nearby);
        for (int step = 0; step < 2; step++)
        {
            angle = WideMath.Subtract(angle, WideMath.Divide(Residual(angle, eccentricity, meanAnomaly), Slope(angle, eccentricity)));
        }

        return angle;
    }

    /// <summary>Exact.</summary>
    private static DoubleDouble OneMinus(double eccentricity) => WideMath.Subtract(WideMath.Of(1.0), WideMath.Of(eccentricity));
}
