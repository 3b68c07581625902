namespace Msisf.Core.Ephemeris;

/// <summary>A body whose surface can be drawn: the Moon, or another one with its frame from a text kernel. Immutable.</summary>
public sealed record CelestialBody
{
    private CelestialBody(string name, int naifNumber, double meanRadius) =>
        (Name, NaifNumber, MeanRadius) = (name, naifNumber, meanRadius);

    /// <summary>The Moon in its mean-Earth/polar-axis frame.</summary>
    public static CelestialBody Moon { get; } = new("Moon", 301, Terrain.MoonConstants.ReferenceRadius);

    /// <summary>The Moon, and the bodies with a solid and nearly spherical surface. Mean radii: Archinal et al. (2018), tables 4 and 5.</summary>
    public static IReadOnlyList<CelestialBody> All { get; } =
    [
        Moon,
        new("Mercury", 199, 2_439_400.0),
        new("Venus", 299, 6_051_800.0),
        new("Mars", 499, 3_389_500.0),
        new("Io", 501, 1_821_490.0),
        new("Europa", 502, 1_560_800.0),
        new("Ganymede", 503, 2_631_200.0),
        new("Callisto", 504, 2_410_300.0),
    ];

    /// <summary>English name with a capital letter.</summary>
    public string Name { get; }

    /// <summary>NAIF's number.</summary>
    public int NaifNumber { get; }

    /// <summary>m: reference radius of synthetic models. A model's own radius is in its label.</summary>
    public double MeanRadius { get; }

    /// <summary>Whether it is the Moon.</summary>
    public bool IsMoon => NaifNumber == 301;

    /// <summary>The body-fixed frame in which positions are given, by its name in SPICE.</summary>
    public string Frame => IsMoon ? "MOON_ME" : $"IAU_{CapitalName}";

    /// <summary>The name in capitals, as PDS labels have it in TARGET_NAME.</summary>
    public string CapitalName => Name.ToUpperInvariant();

    /// <summary>The name within a sentence, e.g. "the Moon" or "Mercury".</summary>
    public string NameInText => IsMoon ? "the Moon" : Name;

    /// <summary>The body of a number of NAIF's, which must be one of <see cref="All"/>.</summary>
    public static CelestialBody Of(int naifNumber) => All.First(body => body.NaifNumber == naifNumber);

    /// <summary>The body of a TARGET_NAME; null if it is none that can be drawn.</summary>
    public static CelestialBody? Find(string targetName) =>
        All.FirstOrDefault(body => body.CapitalName.Equals(targetName, StringComparison.OrdinalIgnoreCase));

    /// <inheritdoc/>
    public override string ToString() => Name;
}
