namespace Msisf.Core.Render.Photometry;

/// <summary>Makes a reflectance law from its name and named parameters (docs/photometry.md).</summary>
public static class ReflectanceFactory
{
    /// <summary>The default albedo: that of POV-Ray's scene, pigment 0.8 times diffuse 0.8.</summary>
    public const double DefaultAlbedo = 0.64;

    /// <summary>The default law of the native renderer.</summary>
    public static string DefaultLaw => MoonReflectance.Law.Name;

    /// <summary>The names of the laws.</summary>
    public static IReadOnlyList<string> Laws { get; } = [.. ReflectanceLaws.All.Select(law => law.Name)];

    /// <summary>Whether a law gives the brightness by itself with these parameters, so that it takes no albedo.</summary>
    /// <param name="law">Name of the law; an unknown one has none.</param>
    /// <param name="parameters">Names of the parameters that are given.</param>
    public static bool IsAbsolute(string law, IEnumerable<string> parameters) =>
        Find(law)?.IsAbsolute(parameters) ?? false;

    /// <summary>Makes the law.</summary>
    /// <param name="name">Name of the law, one of <see cref="Laws"/>.</param>
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
        string name, IReadOnlyDictionary<string, double> parameters, double? albedo = null, SpectralBand? band = null)
    {
        ReflectanceLaw law = Find(name) ?? throw new BadInputException(
            $"Reflectance law '{name}' is not known. Known laws: {string.Join(", ", (object[])ReflectanceLaws.All)}.");
        if (parameters.Keys.Where(
            key => !law.Parameters.Contains(key, StringComparer.Ordinal)).Order(StringComparer.Ordinal).FirstOrDefault() is string unknown)
        {
            string possible = law.Parameters.Count == 0 ? "It has none" : $"It has {string.Join(", ", law.Parameters)}";
            throw new BadInputException($"Reflectance law {name} has no parameter '{unknown}'. {possible}.");
        }

        if (albedo is not null && law.IsAbsolute(parameters.Keys))
        {
            throw new BadInputException(law.HasOwnBrightness
                ? $"Reflectance law {name} has the Moon's own brightness and takes no albedo. Leave it out, or choose another law."
                : $"Reflectance law {name} has both {law.BrightnessParameter} and an albedo, and each sets its brightness. Leave one out.");
        }

        return law.Make(new ReflectanceValues(parameters, albedo ?? DefaultAlbedo, band ?? SpectralBand.Default));
    }

    private static ReflectanceLaw? Find(string name) => Array.Find(ReflectanceLaws.All, law => law.Name == name);
}
