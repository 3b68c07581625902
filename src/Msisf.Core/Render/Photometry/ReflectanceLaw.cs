namespace Msisf.Core.Render.Photometry;

/// <summary>A reflectance law as a user names it. Each class of a law has one, as its property Law.</summary>
/// <param name="Name">Its name, e.g. "lunar-lambert".</param>
/// <param name="Make">Makes the law from the values that a user gave.</param>
public sealed record ReflectanceLaw(string Name, Func<ReflectanceValues, IReflectance> Make)
{
    /// <summary>Names of the parameters.</summary>
    public IReadOnlyList<string> Parameters { get; init; } = [];

    /// <summary>Whether the law has the Moon's own brightness, so that it takes no albedo.</summary>
    public bool HasOwnBrightness { get; init; }

    /// <summary>The parameter that sets the brightness in place of an albedo, if it is given; null if there is none.</summary>
    public string? BrightnessParameter { get; init; }

    /// <summary>Name and parameters, for messages.</summary>
    public override string ToString() => Parameters.Count switch
    {
        0 => Name,
        1 => $"{Name} (parameter {Parameters[0]})",
        _ => $"{Name} (parameters {string.Join(", ", Parameters)})",
    };

    /// <summary>Whether the law has a brightness of its own with these parameters, so that it takes no albedo.</summary>
    /// <param name="parameters">Names of the parameters that are given.</param>
    public bool IsAbsolute(IEnumerable<string> parameters) =>
        HasOwnBrightness || (BrightnessParameter is { } name && parameters.Contains(name, StringComparer.Ordinal));
}

/// <summary>The values from which a law is made.</summary>
/// <param name="Parameters">Parameters by name, only those that the user gave.</param>
/// <param name="Albedo">Normal albedo: I/F with the Sun and the viewer at the zenith, 0 to 1.</param>
/// <param name="Band">Band of a law with the Moon's own brightness.</param>
public sealed record ReflectanceValues(IReadOnlyDictionary<string, double> Parameters, double Albedo, SpectralBand Band)
{
    /// <summary>A parameter; null if it is not given.</summary>
    public double? Parameter(string name) => Parameters.TryGetValue(name, out double value) ? value : null;
}
