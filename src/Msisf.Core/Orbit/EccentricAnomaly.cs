namespace Msisf.Core.Orbit;

/// <summary>
/// A place on an ellipse by its eccentric anomaly, with the position and velocity that follow from it in units of the semi-major axis a.
/// No digits are lost for e near 1 and small angles, where the plain formulas 1 - e cos E and E - e sin E lose all. <c>default</c> is the
/// periapsis of a circle.
/// </summary>
/// <param name="Angle">Eccentric anomaly E, rad, [-pi, pi].</param>
/// <param name="Eccentricity">e, 0 &lt;= e &lt; 1.</param>
public readonly record struct EccentricAnomaly(double Angle, double Eccentricity)
{
    /// <summary>rad: below this E - sin E is summed as a series, above it the difference keeps its digits.</summary>
    private const double SeriesLimit = Math.PI / 2.0;

    private static readonly DoubleDouble Sixth = DoubleDouble.Quotient(1.0, 6.0);

    /// <summary>Distance to the central body over a: r/a = 1 - e cos E (thesis eq. 6.5).</summary>
    public double Radius => (1.0 - Eccentricity) + (Eccentricity * OneMinusCosine);

    /// <summary>Coordinate towards the periapsis over a: cos E - e.</summary>
    public double X => (1.0 - Eccentricity) - OneMinusCosine;

    /// <summary>Coordinate across, in the sense of the motion, over a: sqrt(1 - e^2) sin E.</summary>
    public double Y => MinorAxis * Trigonometry.Sin(Angle);

    /// <summary>Velocity towards the periapsis over a n, n the mean motion (thesis eq. 6.7).</summary>
    public double VelocityX => -Trigonometry.Sin(Angle) / Radius;

    /// <summary>Velocity across over a n (thesis eq. 6.7).</summary>
    public double VelocityY => MinorAxis * Trigonometry.Cos(Angle) / Radius;

    /// <summary>True anomaly, rad, [-pi, pi].</summary>
    public double TrueAnomaly => Trigonometry.Atan2(Y, X);

    /// <summary>Mean anomaly M = E - e sin E, rad, [-pi, pi] (Kepler's equation).</summary>
    public double MeanAnomaly => MeanAnomalyMinus(0.0);

    /// <summary>1 - cos E.</summary>
    private double OneMinusCosine
    {
        get
        {
            double sinHalf = Trigonometry.Sin(Angle / 2.0);
            return 2.0 * sinHalf * sinHalf;
        }
    }

    /// <summary>Minor over major axis: sqrt(1 - e^2).</summary>
    private double MinorAxis => Math.Sqrt((1.0 - Eccentricity) * (1.0 + Eccentricity));

    /// <summary>
    /// E - e sin E - <paramref name="meanAnomaly"/>, wrong by less than a unit in the last place of a mean anomaly near E - e sin E.
    /// </summary>
    internal double MeanAnomalyMinus(double meanAnomaly)
    {
        // e < 1/2: 1 - e would be rounded and E - e sin E does not cancel; e >= 1/2: 1 - e is exact.
        if (Eccentricity < 0.5 || Math.Abs(Angle) > SeriesLimit)
        {
            return Math.FusedMultiplyAdd(-Eccentricity, Trigonometry.Sin(Angle), Angle - meanAnomaly);
        }

        // For e near 1 a unit in the last place of E is by itself up to 3 units of M, so the sum is computed without further rounding.
        DoubleDouble linear = new DoubleDouble(1.0 - Eccentricity, 0.0) * new DoubleDouble(Angle, 0.0);
        DoubleDouble curved = new DoubleDouble(Eccentricity, 0.0) * AngleMinusSine(Angle);
        return (linear + curved + new DoubleDouble(-meanAnomaly, 0.0)).High;
    }

    /// <summary>
    /// x - sin x for |x| up to <see cref="SeriesLimit"/>, by the Taylor series: its first term to twice the digits of a double, the rest,
    /// an eighth of it at most, in doubles.
    /// </summary>
    private static DoubleDouble AngleMinusSine(double x)
    {
        // The last factor, 23 * 22, leaves out terms below 1e-17 of the sum at the limit.
        double square = x * x;
        double rest = 1.0;
        for (int n = 23; n >= 7; n -= 2)
        {
            rest = 1.0 - (square / (n * (n - 1)) * rest);
        }

        DoubleDouble wide = new(x, 0.0);
        DoubleDouble cubic = wide * wide * wide * Sixth;
        return cubic + new DoubleDouble(-cubic.High * square / 20.0 * rest, 0.0);
    }
}
