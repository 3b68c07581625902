namespace Msisf.Stress.Reference;

/// <summary>Kepler's equation to some 30 digits.</summary>
internal static class PreciseKepler
{
    /// <summary>E - e sin E - M; nothing cancels that the residual needs, whatever e and E.</summary>
    public static DoubleWord Residual(DoubleWord angle, double eccentricity, DoubleWord meanAnomaly) =>
        (OneMinus(eccentricity) * angle) + (eccentricity * PreciseMath.MinusSine(angle)) - meanAnomaly;

    /// <summary>The slope of the residual, 1 - e cos E: the distance over a.</summary>
    public static DoubleWord Slope(DoubleWord angle, double eccentricity) =>
        OneMinus(eccentricity) + (eccentricity * PreciseMath.MinusCosine(angle));

    /// <summary>The eccentric anomaly, from one that is right to about 15 digits: each of two Newton steps doubles them.</summary>
    public static DoubleWord Solve(double nearby, double eccentricity, DoubleWord meanAnomaly)
    {
        DoubleWord angle = nearby;
        for (int step = 0; step < 2; step++)
        {
            angle -= Residual(angle, eccentricity, meanAnomaly) / Slope(angle, eccentricity);
        }

        return angle;
    }

    /// <summary>Exact.</summary>
    private static DoubleWord OneMinus(double eccentricity) => (DoubleWord)1.0 - eccentricity;
}
