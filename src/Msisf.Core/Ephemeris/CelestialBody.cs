namespace Msisf.Core.Ephemeris;

/// <summary>A body whose surface can be drawn: the Moon, or another one with its frame from a text kernel. Immutable.</summary>
public sealed record CelestialBody
{
    private CelestialBody(string name, int naifNumber, double meanRadius, (double Min, double Max) plausibleHeights) =>
        (Name, NaifNumber, MeanRadius, PlausibleHeights) = (name, naifNumber, meanRadius, plausibleHeights);

    /// <summary>The Moon in its mean-Earth/polar-axis frame.</summary>
    public static CelestialBody Moon { get; } = new(
        "Moon", 301, Terrain.MoonConstants.ReferenceRadius, Terrain.MoonConstants.PlausibleHeights);

    /// <summary>The Moon, and other bodies that are nearly spheres.</summary>
    /// <remarks>
    /// Mean radii, and the axes of Mars and Io: B. A. Archinal et al., Celest. Mech. Dyn. Astr. 130 (2018) 22, tables 4 and 5. Heights:
    /// Mercury -5.38 to +4.48 km (K. J. Becker et al., Lunar Planet. Sci. 47 (2016) 2959); Venus, to +11 km (P. G. Ford, G. H. Pettengill,
    /// J. Geophys. Res. 97 (1992) 13103); Mars -8.2 to +21.2 km over its areoid, whose radius is from 3376 to 3396 km (D. E. Smith et al.,
    /// J. Geophys. Res. 106 (2001) 23689); Io, axes 8 km longer than the mean and mountains of 17.5 km (P. Schenk et al., J. Geophys. Res.
    /// 106 (2001) 33201); Europa, axes within 2 km and relief of up to 2 km (P. Schenk, Bull. Am. Astron. Soc. 37 (2005) 63.04); Ganymede,
    /// 97 % within 5 km (A. Zubarev et al., Planet. Space Sci. 117 (2015) 246). Nothing is published of Callisto as a whole: as Ganymede.
    /// </remarks>
    public static IReadOnlyList<CelestialBody> All { get; } =
    [
        Moon,
        new("Mercury", 199, 2_439_400.0, (-7_000.0, 6_000.0)),
        new("Venus", 299, 6_051_800.0, (-5_000.0, 13_000.0)),
        new("Mars", 499, 3_389_500.0, (-23_000.0, 29_000.0)),
        new("Io", 501, 1_821_490.0, (-10_000.0, 22_000.0)),
        new("Europa", 502, 1_560_800.0, (-6_000.0, 6_000.0)),
        new("Ganymede", 503, 2_631_200.0, (-10_000.0, 10_000.0)),
        new("Callisto", 504, 2_410_300.0, (-10_000.0, 10_000.0)),
    ];

    /// <summary>English name with a capital letter.</summary>
    public string Name { get; }

    /// <summary>NAIF's number.</summary>
    public int NaifNumber { get; }

    /// <summary>m: reference radius of synthetic models. A model's own radius is in its label.</summary>
    public double MeanRadius { get; }

    /// <summary>
    /// m over the sphere of a model: heights beyond these are none. The spheres in use for Mars have radii from 3389.5 to 3396.2 km.
    /// </summary>
    public (double Min, double Max) PlausibleHeights { get; }

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
