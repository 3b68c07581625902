namespace Msisf.Core.Orbit;

/// <summary>Solves Kepler's equation M = E - e sin E for elliptic orbits.</summary>
public static class KeplerSolver
{
    /// <summary>
    /// Maximum number of steps: enough for bisection alone to reach neighbouring doubles; Newton's method needs about 6.
    /// </summary>
    private const int MaxIterations = 100;

    /// <summary>Factor that raises an upper bound of the root, because rounding may put the bound below the root.</summary>
    private const double BoundRounding = 1.0 + 2e-15;

    /// <summary>The eccentric anomaly, right to the last digit (within one unit of it) for the M and e given.</summary>
    /// <param name="meanAnomaly">M, rad, any finite number; full turns are removed without loss.</param>
    /// <param name="eccentricity">e, 0 &lt;= e &lt; 1.</param>
    /// <returns>E in [-pi, pi], with position and velocity in units of the semi-major axis.</returns>
    /// <exception cref="ArgumentOutOfRangeException">
    /// Not finite, or not an ellipse: <see cref="KeplerElements"/> lets neither through.
    /// </exception>
    /// <remarks>
    /// Newton's method (thesis eq. 6.2), but not from E = M, which diverges for e near 1: f is convex on [0, pi], so
    /// from an upper bound of the root every step stays above it. The bounds are M + e, pi, M / (1 - e), and the
    /// root of M = e E^3 / pi^2, since E - sin E >= E^3 / pi^2 on [0, pi]. MathNet's RobustNewtonRaphson stops at an accuracy of E, not at
    /// the last digit.
    /// </remarks>
    public static EccentricAnomaly Solve(double meanAnomaly, double eccentricity) => Solve(meanAnomaly, eccentricity, out _);

    /// <summary>The same, with the number of Newton steps, which the stress test checks.</summary>
    internal static EccentricAnomaly Solve(double meanAnomaly, double eccentricity, out int steps)
    {
        if (!double.IsFinite(meanAnomaly))
        {
            throw new ArgumentOutOfRangeException(nameof(meanAnomaly), meanAnomaly, "Not finite.");
        }

        if (!(eccentricity >= 0.0 && eccentricity < 1.0))
        {
            throw new ArgumentOutOfRangeException(nameof(eccentricity), eccentricity, "Not in [0, 1).");
        }

        double reduced = AngleReduction.ToHalfTurn(meanAnomaly);
        double half = SolveUpperHalf(Math.Abs(reduced), eccentricity, out steps);
        return new EccentricAnomaly(Math.CopySign(half, reduced), eccentricity);
    }

    private static double SolveUpperHalf(double meanAnomaly, double eccentricity, out int steps)
    {
        steps = 0;
        if (meanAnomaly == 0.0)
        {
            return 0.0;
        }

        double lineBound = Math.Min(meanAnomaly + eccentricity, meanAnomaly / (1.0 - eccentricity));
        double cubicBound = Math.Cbrt(Math.PI * Math.PI * meanAnomaly / eccentricity);
        double low = 0.0;
        double high = Math.Min(Math.PI, BoundRounding * Math.Min(lineBound, cubicBound));
        double angle = high;
        while (steps < MaxIterations)
        {
            steps++;
            EccentricAnomaly candidate = new(angle, eccentricity);
            double excess = candidate.MeanAnomalyMinus(meanAnomaly);
            double next = angle - (excess / candidate.Radius);
            if (Math.Abs(next - angle) <= Math.BitIncrement(angle) - angle)
            {
                return Math.Min(next, Math.PI);
            }

            // Newton leaves the bracket only where rounding decides the sign of the excess, next to the root.
            (low, high) = excess > 0.0 ? (low, angle) : (angle, high);
            angle = next > low && next < high ? next : low + ((high - low) / 2.0);
        }

        throw new InvalidOperationException(Invariant(
            $"Kepler's equation was not solved in {MaxIterations} steps for M = {meanAnomaly:R}, e = {eccentricity:R}."));
    }
}
