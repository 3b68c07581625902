namespace Msisf.Core.Detector;

/// <summary>The wavelengths to which a camera responds, and how much: transmission and quantum efficiency. Immutable.</summary>
public sealed class SpectralResponse
{
    /// <summary>J s (SI, exact).</summary>
    private const double PlanckConstant = 6.62607015e-34;

    private const double LightSpeed = 1000.0 * Ephemeris.LightSpeed.KilometresPerSecond; // m/s

    /// <summary>nm: longest step of the integration; tables of the solar spectrum have steps of about 1 nm.</summary>
    private const double MaxStep = 0.5;

    private const double MetresPerNanometre = 1e-9;

    private readonly SpectralCurve _transmission;
    private readonly SpectralCurve _quantumEfficiency;

    /// <summary>Describes a band.</summary>
    /// <param name="shortest">nm, above 0.</param>
    /// <param name="longest">nm, above <paramref name="shortest"/>.</param>
    /// <param name="transmission">Part of the light that reaches the detector.</param>
    /// <param name="quantumEfficiency">Electrons per photon.</param>
    /// <exception cref="BadInputException">The band is empty.</exception>
    public SpectralResponse(double shortest, double longest, SpectralCurve transmission, SpectralCurve quantumEfficiency)
    {
        Shortest = Guard.Positive(shortest, "The band's shortest wavelength (nm)");
        Longest = Guard.Finite(longest, "The band's longest wavelength (nm)");
        if (longest <= shortest)
        {
            throw new BadInputException($"The band ends at {longest:R} nm and begins at {shortest:R} nm; its end must be the longer one.");
        }

        _transmission = transmission;
        _quantumEfficiency = quantumEfficiency;
    }

    /// <summary>nm.</summary>
    public double Shortest { get; }

    /// <summary>nm.</summary>
    public double Longest { get; }

    /// <summary>
    /// Electrons per second that a detector makes of light, for each m^2 that the light falls on: the integral of
    /// E(lambda) tau(lambda) QE(lambda) lambda / (h c) over the band.
    /// </summary>
    /// <param name="irradiance">E: W m^-2 nm^-1 at a wavelength in nm.</param>
    public double ElectronRate(Func<double, double> irradiance)
    {
        double[] borders =
        [
            .. _transmission.Wavelengths.Concat(_quantumEfficiency.Wavelengths).Append(Shortest).Append(Longest)
                .Where(wavelength => wavelength >= Shortest && wavelength <= Longest).Distinct().Order(),
        ];
        double sum = 0.0;
        for (int i = 1; i < borders.Length; i++)
        {
            int steps = (int)Math.Ceiling((borders[i] - borders[i - 1]) / MaxStep);
            double step = (borders[i] - borders[i - 1]) / steps;
            for (int part = 0; part < steps; part++)
            {
                sum += step * Mean(borders[i - 1] + (part * step), step, irradiance);
            }
        }

        return sum * MetresPerNanometre / (PlanckConstant * LightSpeed);
    }

    /// <summary>Mean over a step by Gauss's rule of two points, exact for cubics: two straight lines and a wavelength.</summary>
    private double Mean(double from, double step, Func<double, double> irradiance)
    {
        double offset = 0.5 * step / Math.Sqrt(3.0);
        double middle = from + (0.5 * step);
        return 0.5 * (Integrand(middle - offset, irradiance) + Integrand(middle + offset, irradiance));
    }

    private double Integrand(double wavelength, Func<double, double> irradiance) =>
        irradiance(wavelength) * _transmission.At(wavelength) * _quantumEfficiency.At(wavelength) * wavelength;
}
