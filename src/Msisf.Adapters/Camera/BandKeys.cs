using Msisf.Adapters.Input;
using Msisf.Core.Detector;

namespace Msisf.Adapters.Camera;

/// <summary>Reads the keys of a detector that say how it responds to which wavelengths.</summary>
internal static class BandKeys
{
    private const int MaxPoints = 10_000;

    /// <summary>nm: mirrors and lenses of cameras end there, and a wavelength in micrometres is below it.</summary>
    private const double ShortestWavelength = 100.0;

    /// <summary>nm: beyond it no camera sees the Sun's light on the Moon.</summary>
    private const double LongestWavelength = 100_000.0;

    private static readonly (string Name, double Nanometres)[] OtherUnits =
        [("micrometres", 1e3), ("millimetres", 1e6), ("metres", 1e9), ("picometres", 1e-3)];

    /// <summary>Reads the keys.</summary>
    /// <exception cref="BadInputException">What is wrong, by file, line and column.</exception>
    public static SpectralResponse Read(SettingsSection section)
    {
        double[]? wavelengths = Wavelengths(section);
        double[]? limits = section.Numbers("band", 2, 2);
        if (limits is null && wavelengths is null)
        {
            throw section.Missing("band", "the shortest and the longest wavelength in nm; a table in 'wavelengths' does as well");
        }

        limits ??= [wavelengths![0], wavelengths[^1]];
        if (!(limits[0] > 0.0 && limits[1] > limits[0]))
        {
            throw section.Wrong(
                section.Has("band") ? "band" : "wavelengths", "the band needs two wavelengths above 0, the shorter one first");
        }

        RequireNanometres(section, section.Has("band") ? "band" : "wavelengths", "the band begins at", limits[0]);
        return new SpectralResponse(
            limits[0],
            limits[1],
            Curve(section, "transmission", wavelengths, 1.0),
            Curve(section, "quantum-efficiency", wavelengths, null));
    }

    /// <summary>Refuses a wavelength that is so short or long that it is in another unit.</summary>
    /// <param name="section">Has the key.</param>
    /// <param name="what">What the wavelength is, for the message, e.g. "the band begins at".</param>
    /// <param name="wavelength">The wavelength, above 0.</param>
    /// <exception cref="BadInputException">It is refused; the message guesses the unit.</exception>
    public static void RequireNanometres(SettingsSection section, string key, string what, double wavelength)
    {
        if (!IsInRange(wavelength))
        {
            (string unit, double nanometres) = OtherUnits.FirstOrDefault(other => IsInRange(wavelength * other.Nanometres));
            string guess = unit is null ? string.Empty : Invariant(
                $": did you mean {Math.Round(wavelength * nanometres, 3)} nm, from {unit}?");
            throw section.Wrong(key, Invariant(
                $"{what} {wavelength} nm; wavelengths are in nanometres (nm), from {ShortestWavelength} to {LongestWavelength}") + guess);
        }
    }

    private static bool IsInRange(double nanometres) => nanometres is >= ShortestWavelength and <= LongestWavelength;

    private static double[]? Wavelengths(SettingsSection section)
    {
        double[]? wavelengths = section.Numbers("wavelengths", 2, MaxPoints);
        for (int i = 0; i < wavelengths?.Length; i++)
        {
            if (!(wavelengths[i] > (i == 0 ? 0.0 : wavelengths[i - 1])))
            {
                throw section.Wrong("wavelengths", Invariant(
                    $"number {i + 1} of 'wavelengths' is {wavelengths[i]}; wavelengths are above 0 and increase"));
            }
        }

        return wavelengths;
    }

    private static SpectralCurve Curve(SettingsSection section, string key, double[]? wavelengths, double? whenMissing)
    {
        double[]? values = section.Numbers(key, 1, MaxPoints);
        if (values is null)
        {
            return new SpectralCurve(whenMissing
                ?? throw section.Missing(key, "electrons per photon, 0 to 1: a number, or a list, one for each of 'wavelengths'"));
        }

        int wrong = Array.FindIndex(values, value => !(value >= 0.0 && value <= 1.0));
        if (wrong >= 0)
        {
            throw section.Wrong(
                key, Invariant($"'{key}' has the number {values[wrong]}; numbers from 0 to 1 are needed"));
        }

        return values.Length == 1
            ? new SpectralCurve(values[0])
            : wavelengths is null
                ? throw section.Wrong(key, $"'{key}' has {values.Length} numbers and needs as many 'wavelengths'")
                : values.Length != wavelengths.Length
                    ? throw section.Wrong(key, $"'{key}' has {values.Length} numbers and 'wavelengths' {wavelengths.Length}; give as many")
                    : new SpectralCurve([.. wavelengths.Zip(values)]);
    }
}
