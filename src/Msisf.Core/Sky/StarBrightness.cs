using System.Collections.Concurrent;

namespace Msisf.Core.Sky;

/// <summary>
/// How bright stars are in one band: computed once for each colour, of which catalogues have some thousand. Safe for several threads.
/// </summary>
/// <param name="ofSpectrum">A number that is in proportion to the light, of irradiances (W m^-2 nm^-1) at wavelengths (nm).</param>
public sealed class StarBrightness(Func<Func<double, double>, double> ofSpectrum)
{
    private readonly ConcurrentDictionary<double, double> _ofZero = [];

    /// <summary>The number for a star.</summary>
    public double Of(in Star star) => Math.Pow(10.0, -0.4 * star.Magnitude) * _ofZero.GetOrAdd(
        star.Colour ?? StarSpectrum.ColourOfSun,
        colour =>
        {
            StarSpectrum spectrum = new(0.0, colour);
            return ofSpectrum(spectrum.IrradianceAt);
        });
}
