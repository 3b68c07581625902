using Msisf.Adapters.Input;
using Msisf.Core.Detector.Psf;

namespace Msisf.Adapters.Camera;

/// <summary>Reads the keys of a detector's stray light over the whole image.</summary>
internal static class FarWingKeys
{
    private const double MaxExponent = 10.0;
    private const double MinCoreRadius = 0.03; // px: narrower functions can't be integrated in the steps that a pixel is cut into
    private const double MaxCoreRadius = 1000.0;

    public static string[] Keys { get; } = ["psf-wings", "psf-wings-radius", "psf-wings-exponent", "psf-wings-reach"];

    /// <returns>Null for none.</returns>
    /// <param name="section">The section of the detector.</param>
    /// <exception cref="BadInputException">What is wrong, by file, line and column.</exception>
    public static FarWings? Read(SettingsSection section)
    {
        if (DetectorSection.Range(section, "psf-wings", 0.0, 1.0) is not { } fraction)
        {
            return Keys.FirstOrDefault(section.Has) is { } other
                ? throw section.Wrong(other, $"'{other}' has no meaning without 'psf-wings', the part of the light. Give both, or none")
                : null;
        }

        double exponent = section.Number("psf-wings-exponent")
            ?? throw section.Missing("psf-wings-exponent", "b of (1 + (r/r0)^2)^(-b/2)");
        return exponent is > 2.0 and <= MaxExponent
            ? new FarWings(
                fraction,
                DetectorSection.Range(section, "psf-wings-radius", MinCoreRadius, MaxCoreRadius)
                    ?? throw section.Missing("psf-wings-radius", "r0 of (1 + (r/r0)^2)^(-b/2) in px"),
                exponent,
                DetectorSection.Range(section, "psf-wings-reach", 1.0, FarWings.MaxReach)
                    ?? throw section.Missing("psf-wings-reach", "how far the wings go, px"))
            : throw section.Wrong(
                "psf-wings-exponent",
                $"'psf-wings-exponent' is {section.Text("psf-wings-exponent")}; a number above 2, up to 10, is needed");
    }
}
