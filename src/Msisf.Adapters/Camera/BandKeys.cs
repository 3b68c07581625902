using Msisf.Core.Detector;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Camera;

/// <summary>Reads the keys of a detector that say how it responds to which wavelengths.</summary>
internal static class BandKeys
{
    private const int MaxPoints = 10_000;

    /// <summary>nm: mirrors and lenses of cameras end there, and a band in micrometres is below it.</summary>
    private const double ShortestWavelength = 100.0;

    /// <summary>Reads the keys.</summary>
    /// <exception cref="BadInputException">What is wrong, by file, line and column.</exception>
    public static Band Read(CameraSection section)
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

        if (limits[0] < ShortestWavelength)
        {
            throw section.Wrong(section.Has("band") ? "band" : "wavelengths", FormattableString.Invariant(
                $"the band begins at {limits[0]} nm; wavelengths are in nanometres (nm), from {ShortestWavelength} on. ")
                    + "Micrometres are to be multiplied by 1000");
        }

        return new Band(
            limits[0],
            limits[1],
            Curve(section, "transmission", wavelengths, 1.0),
            Curve(section, "quantum-efficiency", wavelengths, null));
    }

    private static double[]? Wavelengths(CameraSection section)
    {
        double[]? wavelengths = section.Numbers("wavelengths", 2, MaxPoints);
        for (int i = 0; i < wavelengths?.Length; i++)
        {
            if (!(wavelengths[i] > (i == 0 ? 0.0 : wavelengths[i - 1])))
            {
                throw section.Wrong("wavelengths", FormattableString.Invariant(
                    $"number {i + 1} of 'wavelengths' is {wavelengths[i]}; wavelengths are above 0 and increase"));
            }
        }

        return wavelengths;
    }

    private static SpectralCurve Curve(CameraSection section, string key, double[]? wavelengths, double? whenMissing)
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
                key, FormattableString.Invariant($"'{key}' has the number {values[wrong]}; numbers from 0 to 1 are needed"));
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
