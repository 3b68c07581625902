namespace Msisf.Core.Sky;

/// <summary>
/// How bright planets are: V by A. Mallama, J. L. Hilton, Astron. Comput. 25 (2018) 10. Where a formula ends, its nearest one goes on.
/// </summary>
public static class PlanetMagnitude
{
    /// <summary>V of the Sun at 1 au (C. N. A. Willmer, Astrophys. J. Suppl. 236 (2018) 47).</summary>
    public const double OfSun = -26.76;

    private const double VenusCrescent = 163.7; // degrees: light goes forward in the clouds beyond
    private const double MarsLimit = 50.0;
    private const double JupiterLimit = 12.0;
    private const double SaturnLimit = 6.5;
    private const double UranusLimit = 3.1;
    private const double NeptuneLimit = 1.9;

    /// <summary>V of a planet.</summary>
    /// <param name="naifNumber">199 or 1 for Mercury, and so on; 399 for the Earth.</param>
    /// <param name="sunDistance">From the Sun, au.</param>
    /// <param name="distance">From the observer, au.</param>
    /// <param name="phase">Sun, planet, observer: degrees, 0 to 180.</param>
    /// <param name="sunLatitude">Planetocentric latitude of the point below the Sun, degrees; matters for Saturn and Uranus.</param>
    /// <param name="observerLatitude">The same of the point below the observer.</param>
    /// <param name="yearsPastJ2000">Julian years; matters for Neptune.</param>
    /// <remarks>
    /// Mars is taken without its rotation (0.06 mag); Saturn with its rings, whose formula was measured to a phase of 6.5 degrees only:
    /// beyond it is that of the globe, with what the rings add at 6.5 degrees.
    /// </remarks>
    /// <exception cref="ArgumentOutOfRangeException">There is no such planet.</exception>
    public static double Of(
        int naifNumber, double sunDistance, double distance, double phase, double sunLatitude, double observerLatitude,
        double yearsPastJ2000)
    {
        double atUnit = naifNumber switch
        {
            1 or 199 => -0.613 + Sum(phase, 6.3280e-2, -1.6336e-3, 3.3644e-5, -3.4265e-7, 1.6893e-9, -3.0334e-12),
            2 or 299 => phase < VenusCrescent
                ? -4.384 + Sum(phase, -1.044e-3, 3.687e-4, -2.814e-6, 8.938e-9)
                : 236.05828 + Sum(phase, -2.81914, 8.39034e-3),
            399 => OfEarth(phase),
            4 or 499 => phase <= MarsLimit ? -1.601 + Sum(phase, 2.267e-2, -1.302e-4) : -0.367 + Sum(phase, -0.02573, 3.445e-4),
            5 or 599 => phase <= JupiterLimit
                ? -9.395 + Sum(phase, -3.7e-4, 6.16e-4)
                : -9.428 - (2.5 * Math.Log10(Math.Max(1e-9, 1.0 + Sum(phase / 180.0, -1.507, -0.363, -0.062, 2.809, -1.876)))),
            6 or 699 => Saturn(phase, sunLatitude, observerLatitude),
            7 or 799 => -7.110 - (0.00084 * 0.5 * (Math.Abs(sunLatitude) + Math.Abs(observerLatitude)))
                + (phase > UranusLimit ? Sum(phase, 6.587e-3, 1.045e-4) : 0.0),
            8 or 899 => Math.Clamp(-6.89 - (0.0054 * (yearsPastJ2000 + 20.0)), -7.00, -6.89)
                + (phase > NeptuneLimit ? Sum(phase, 7.944e-3, 9.617e-5) : 0.0),
            _ => throw new ArgumentOutOfRangeException(nameof(naifNumber)),
        };
        return atUnit + (5.0 * Math.Log10(sunDistance * distance));
    }

    /// <summary>V of the Earth at 1 au from Sun and observer.</summary>
    /// <param name="phase">Degrees.</param>
    public static double OfEarth(double phase) => -3.99 + Sum(phase, -1.060e-3, 2.054e-4);

    private static double Saturn(double phase, double sunLatitude, double observerLatitude)
    {
        double product = sunLatitude * observerLatitude;
        double sine = product > 0.0 ? Trigonometry.Sin(double.DegreesToRadians(Math.Sqrt(product))) : 0.0; // otherwise the rings are dark
        double near = Math.Min(phase, SaturnLimit);
        double withRings = -8.914 - (1.825 * sine) + (0.026 * near) - (0.378 * sine * Math.Exp(-2.25 * near));
        return phase <= SaturnLimit ? withRings : withRings + OfSaturnsGlobe(phase) - OfSaturnsGlobe(SaturnLimit);
    }

    private static double OfSaturnsGlobe(double phase) => Sum(phase, 2.446e-4, 2.672e-4, -1.505e-6, 4.767e-9);

    /// <summary>A polynomial without its first term.</summary>
    private static double Sum(double x, params ReadOnlySpan<double> coefficients)
    {
        double sum = 0.0;
        for (int i = coefficients.Length - 1; i >= 0; i--)
        {
            sum = (sum + coefficients[i]) * x;
        }

        return sum;
    }
}
