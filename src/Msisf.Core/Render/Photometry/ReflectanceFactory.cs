using Msisf.Core.Errors;

namespace Msisf.Core.Render.Photometry;

/// <summary>Makes a reflectance law from its name and named parameters (docs/photometry.md).</summary>
public static class ReflectanceFactory
{
    /// <summary>The default albedo: that of POV-Ray's scene, pigment 0.8 times diffuse 0.8.</summary>
    public const double DefaultAlbedo = 0.64;

    /// <summary>The default law of the native renderer.</summary>
    public const string DefaultLaw = "moon";

    /// <summary>The laws and their parameters, for messages and help.</summary>
    public const string ValidValues =
        "lambert, lommel-seeliger, lunar-lambert (parameter l), hapke (parameters w, b, c, b0, h, theta), moon, nac";

    private static readonly Dictionary<string, string[]> ParametersOfLaw = new(StringComparer.Ordinal)
    {
        ["lambert"] = [],
        ["lommel-seeliger"] = [],
        ["lunar-lambert"] = ["l"],
        ["hapke"] = ["w", "b", "c", "b0", "h", "theta"],
        ["moon"] = [],
        ["nac"] = [],
    };

    /// <summary>The names of the laws.</summary>
    public static IReadOnlyList<string> Laws { get; } = [.. ParametersOfLaw.Keys];

    /// <summary>
    /// Whether a law gives the Moon's brightness by itself, so that it takes no albedo: moon, nac, and hapke with a given w.
    /// </summary>
    /// <param name="law">Name of the law.</param>
    /// <param name="parameters">Parameter values by name.</param>
    public static bool IsAbsolute(string law, IReadOnlyDictionary<string, double> parameters) =>
        law is "moon" or "nac" || (law == "hapke" && parameters.ContainsKey("w"));

    /// <summary>Makes the law.</summary>
    /// <param name="law">Name of the law, one of <see cref="Laws"/>.</param>
    /// <param name="parameters">Parameter values by name; a missing parameter has the Moon's value.</param>
    /// <param name="albedo">
    /// I/F with the Sun and the viewer at the zenith, 0 to 1; null for <see cref="DefaultAlbedo"/>. It must be null for an absolute law
    /// (<see cref="IsAbsolute"/>).
    /// </param>
    /// <param name="band">Band of the law moon; null for <see cref="SpectralBand.Default"/>.</param>
    /// <exception cref="BadInputException">
    /// An unknown law or parameter, a value out of range, or an albedo for an absolute law.
    /// </exception>
    public static IReflectance Create(
        string law, IReadOnlyDictionary<string, double> parameters, double? albedo = null, SpectralBand? band = null)
    {
        if (!ParametersOfLaw.TryGetValue(law, out string[]? known))
        {
            throw new BadInputException($"Reflectance law '{law}' is not known. Known laws: {ValidValues}.");
        }

        if (parameters.Keys.Where(
            name => !known.Contains(name, StringComparer.Ordinal)).Order(StringComparer.Ordinal).FirstOrDefault() is string unknown)
        {
            string possible = known.Length == 0 ? "It has none" : $"It has {string.Join(", ", known)}";
            throw new BadInputException($"Reflectance law {law} has no parameter '{unknown}'. {possible}.");
        }

        if (albedo is not null && IsAbsolute(law, parameters))
        {
            throw new BadInputException(law == "hapke"
                ? "Reflectance law hapke has both w and an albedo, and each sets its brightness. Leave one out."
                : $"Reflectance law {law} has the Moon's own brightness and takes no albedo. Leave it out, or choose another law.");
        }

        double normalAlbedo = albedo ?? DefaultAlbedo;
        return law switch
        {
            "lambert" => new LambertReflectance(normalAlbedo),
            "lommel-seeliger" => new LommelSeeligerReflectance(normalAlbedo),
            "lunar-lambert" => new LunarLambertReflectance(normalAlbedo, parameters.TryGetValue("l", out double weight) ? weight : null),
            "moon" => new HapkeReflectance((band ?? SpectralBand.Default).Moon),
            "nac" => new NacReflectance(),
            _ => CreateHapke(parameters, normalAlbedo),
        };
    }

    private static HapkeReflectance CreateHapke(IReadOnlyDictionary<string, double> parameters, double normalAlbedo)
    {
        HapkeParameters moon = new();
        HapkeParameters wanted = new(
            parameters.GetValueOrDefault("w", moon.SingleScatteringAlbedo),
            parameters.GetValueOrDefault("b", moon.LobeWidth),
            parameters.GetValueOrDefault("c", moon.BackwardWeight),
            parameters.GetValueOrDefault("b0", moon.SurgeAmplitude),
            parameters.GetValueOrDefault("h", moon.SurgeWidth),
            parameters.GetValueOrDefault("theta", moon.MeanSlopeDegrees));
        return parameters.ContainsKey("w")
            ? new HapkeReflectance(wanted)
            : HapkeReflectance.WithNormalAlbedo(wanted, normalAlbedo);
    }
}
