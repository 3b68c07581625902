namespace Msisf.Core.Sky;

/// <summary>
/// The light of a star at each wavelength: a black body of the temperature that B - V tells, as bright at 545 nm as V tells. Good to 5 to
/// 10 % in a wide band.
/// </summary>
public readonly record struct StarSpectrum
{
    /// <summary>
    /// W m^-2 nm^-1 of V = 0 at <see cref="ReferenceNanometres"/> (M. S. Bessell, F. Castelli, B. Plez, Astron. Astrophys. 333 (1998)
    /// 231, table A2).
    /// </summary>
    public const double ZeroMagnitude = 3.631e-11;

    /// <summary>nm: effective wavelength of V for an A0 star, at which the spectrum is fixed by V.</summary>
    public const double ReferenceNanometres = 545.0;

    /// <summary>B - V of the Sun (I. Ramirez et al., Astrophys. J. 752 (2012) 5): taken for stars without a colour.</summary>
    public const double ColourOfSun = 0.653;

    /// <summary>nm K: second radiation constant, h c / k (CODATA 2018).</summary>
    private const double SecondRadiationConstant = 1.438776877e7;

    /// <summary>The bluest and the reddest stars to which the formula of the temperature is applied; others count as these.</summary>
    private const double Bluest = -0.4;

    private const double Reddest = 4.0;

    private readonly double _atReference;

    private readonly double _inverseTemperature;

    /// <summary>The light of a star.</summary>
    /// <param name="magnitude">V.</param>
    /// <param name="colour">B - V; null for that of the Sun.</param>
    public StarSpectrum(double magnitude, double? colour)
    {
        _inverseTemperature = 1.0 / TemperatureOf(colour ?? ColourOfSun);
        _atReference = ZeroMagnitude * Math.Pow(10.0, -0.4 * magnitude);
    }

    /// <summary>K (F. J. Ballesteros, Europhys. Lett. 97 (2012) 34008, eq. 14).</summary>
    /// <param name="colour">B - V.</param>
    public static double TemperatureOf(double colour)
    {
        double clamped = Math.Clamp(colour, Bluest, Reddest);
        return 4600.0 * ((1.0 / ((0.92 * clamped) + 1.7)) + (1.0 / ((0.92 * clamped) + 0.62)));
    }

    /// <summary>Irradiance, W m^-2 nm^-1.</summary>
    /// <param name="wavelength">nm, above 0.</param>
    public double IrradianceAt(double wavelength) =>
        _atReference * Math.Pow(ReferenceNanometres / wavelength, 5.0) * Exponent(ReferenceNanometres) / Exponent(wavelength);

    private double Exponent(double wavelength) => Math.Exp(SecondRadiationConstant * _inverseTemperature / wavelength) - 1.0;
}
