namespace Msisf.Core.Detector.Psf;

/// <summary>The diffraction pattern of a circular aperture at one wavelength: (2 J1(x) / x)^2, x = pi r / s.</summary>
/// <param name="scale">
/// s, px: wavelength times f-number, over the pixel's side. The first dark ring has a radius of 1.22 s.
/// </param>
/// <remarks>M. Born, E. Wolf, "Principles of optics", section 8.5.2.</remarks>
public sealed class AirySpread(double scale) : IRadialSpread
{
    /// <summary>Below this argument, 1 - x^2 / 4 is exact to 1e-16.</summary>
    private const double SmallArgument = 1e-4;

    /// <summary>Points of the trapezoid rule beyond half the argument; its error falls faster than exponentially from there on.</summary>
    private const int PointsBeyondArgument = 10;

    /// <inheritdoc/>
    public double Scale => scale;

    /// <inheritdoc/>
    public double At(double radius)
    {
        double x = Math.PI * radius / scale;
        if (x < SmallArgument)
        {
            return 1.0 - (0.25 * x * x);
        }

        double amplitude = 2.0 * BesselJ1(x) / x;
        return amplitude * amplitude;
    }

    /// <summary>
    /// J1(x) = 2 / pi times the integral of sin(x sin t) sin t from 0 to pi / 2: a quarter of a period, over which the trapezoid rule
    /// converges at once.
    /// </summary>
    private static double BesselJ1(double x)
    {
        int points = (int)Math.Ceiling(0.5 * x) + PointsBeyondArgument;
        double sum = 0.5 * Math.Sin(x);
        for (int point = 1; point < points; point++)
        {
            double sine = Math.Sin(0.5 * Math.PI * point / points);
            sum += Math.Sin(x * sine) * sine;
        }

        return sum / points;
    }
}
