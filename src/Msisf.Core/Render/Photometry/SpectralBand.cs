using Msisf.Core.Ephemeris;

namespace Msisf.Core.Render.Photometry;

/// <summary>
/// One of the seven bands of the LROC Wide Angle Camera, for which Hapke's parameters of the Moon were measured (docs/photometry.md).
/// </summary>
public sealed class SpectralBand
{
    /// <summary>Roughness of all bands and places in the maps of Sato et al., degrees.</summary>
    private const double MeanSlopeDegrees = 23.6566;

    private SpectralBand(int nanometres, double solarIrradiance, HapkeParameters moon)
    {
        Nanometres = nanometres;
        SolarIrradiance = solarIrradiance;
        Moon = moon;
    }

    /// <summary>The bands, shortest wavelength first.</summary>
    /// <remarks>
    /// Irradiance: mean of ASTM E490-00a over a band's width, tests/reference/solar_irradiance.py. The widths are 32, 15, 36, 20, 20, 23,
    /// 39 nm: BandBin of the reduced maps of Sato et al. in the test data of USGS ISIS. Parameters at 643 nm: medians of the maps within 30
    /// degrees of the equator; of the other bands: medians of the 22 means over 32 degrees between 32 S and 32 N in the reduced maps,
    /// tests/reference/hapke_bands.py.
    /// </remarks>
    public static IReadOnlyList<SpectralBand> All { get; } =
    [
        new(321, 0.7699, Parameters(0.16400, 0.23631, 0.33817, 2.44359, 0.07698)),
        new(360, 0.9912, Parameters(0.19772, 0.23860, 0.31590, 2.32759, 0.07177)),
        new(415, 1.6488, Parameters(0.23426, 0.24261, 0.27421, 2.07817, 0.07678)),
        new(566, 1.8373, Parameters(0.33328, 0.23722, 0.32937, 1.75108, 0.07535)),
        new(604, 1.7530, Parameters(0.36128, 0.23446, 0.35796, 1.72722, 0.07130)),
        new(643, 1.6200, Parameters(0.3854, 0.2375, 0.3253, 1.686, 0.0672)),
        new(689, 1.4565, Parameters(0.41639, 0.23707, 0.33158, 1.63756, 0.07218)),
    ];

    /// <summary>The band of 643 nm, at which the Moon's parameters were published as medians.</summary>
    public static SpectralBand Default { get; } = Of(643);

    /// <summary>Central wavelength, nm.</summary>
    public int Nanometres { get; }

    /// <summary>Mean solar irradiance in the band at 1 au, W m^-2 nm^-1.</summary>
    public double SolarIrradiance { get; }

    /// <summary>Hapke's parameters of the Moon in the band.</summary>
    public HapkeParameters Moon { get; }

    /// <summary>The band of a central wavelength.</summary>
    /// <param name="nanometres">nm.</param>
    /// <exception cref="BadInputException">There is no such band.</exception>
    public static SpectralBand Of(int nanometres) => All.FirstOrDefault(band => band.Nanometres == nanometres)
        ?? throw new BadInputException(Invariant(
            $"a band of {nanometres} nm is not known. Known bands: {string.Join(", ", All.Select(band => band.Nanometres))} nm."));

    /// <summary>Radiance of the radiance factor 1, W m^-2 sr^-1 nm^-1.</summary>
    /// <param name="sunDistance">Distance from the Sun, m.</param>
    public double RadianceOfUnitFactor(double sunDistance)
    {
        double distance = sunDistance / AstronomicalConstants.AstronomicalUnit;
        return SolarIrradiance / (Math.PI * distance * distance);
    }

    /// <summary>Radiance of the radiance factor 1 in sunlight whose irradiance at 1 au is 1; per steradian.</summary>
    /// <param name="sunDistance">Distance from the Sun, m.</param>
    public static double RadianceOfUnitIrradiance(double sunDistance)
    {
        double distance = sunDistance / AstronomicalConstants.AstronomicalUnit;
        return 1.0 / (Math.PI * distance * distance);
    }

    private static HapkeParameters Parameters(double w, double b, double c, double surgeAmplitude, double surgeWidth) =>
        new(w, b, c, surgeAmplitude, surgeWidth, MeanSlopeDegrees);
}
