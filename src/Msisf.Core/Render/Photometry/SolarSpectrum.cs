namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Sunlight at any wavelength: the irradiances of <see cref="SpectralBand"/> (ASTM E490-00a), and between them the shape of a black body of
/// the Sun's effective temperature. At the bands it is exact; between 320 and 1000 nm it follows the spectrum without its lines.
/// </summary>
public static class SolarSpectrum
{
    /// <summary>K: nominal effective temperature of the Sun (resolution B3 of the IAU, 2015).</summary>
    private const double EffectiveTemperature = 5772.0;

    /// <summary>nm K: second radiation constant, h c / k (CODATA 2018).</summary>
    private const double SecondRadiationConstant = 1.438776877e7;

    private static readonly (double Wavelength, double Ratio)[] Points =
        [.. SpectralBand.All.Select(band => ((double)band.Nanometres, band.SolarIrradiance / Shape(band.Nanometres)))];

    /// <summary>Irradiance at 1 au, W m^-2 nm^-1.</summary>
    /// <param name="wavelength">nm, above 0.</param>
    public static double IrradianceAt(double wavelength)
    {
        int next = Array.FindIndex(Points, point => point.Wavelength > wavelength);
        if (next is 0 or -1)
        {
            return Shape(wavelength) * (next == 0 ? Points[0] : Points[^1]).Ratio;
        }

        (double from, double before) = Points[next - 1];
        (double to, double after) = Points[next];
        return Shape(wavelength) * (before + ((wavelength - from) / (to - from) * (after - before)));
    }

    /// <summary>Planck's law without its factors.</summary>
    private static double Shape(double wavelength) =>
        1.0 / (Math.Pow(wavelength, 5.0) * (Math.Exp(SecondRadiationConstant / (wavelength * EffectiveTemperature)) - 1.0));
}
