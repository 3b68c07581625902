using Msisf.Adapters.Catalogues;
using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;
using Msisf.Core.Sky;

namespace Msisf.App.Settings;

/// <summary>The checked options of the sky.</summary>
internal sealed record SkySettings
{
    /// <summary>The catalogue of stars: a path, or the word for the one that comes with the program; null for no stars.</summary>
    public string? Catalogue { get; init; }

    /// <summary>V of the faintest stars that are drawn; null for all.</summary>
    public double? Faintest { get; init; }

    public bool HasPlanets { get; init; }

    public bool HasEarth { get; init; }

    public bool HasSun { get; init; }

    /// <summary>Whether the Earth lights the ground.</summary>
    public bool HasEarthshine { get; init; }

    /// <summary>Whether something is drawn behind the ground.</summary>
    public bool IsDrawn => Catalogue is not null || Bodies.Count > 0;

    /// <summary>The bodies that are drawn.</summary>
    public IReadOnlyList<SkyBody> Bodies =>
    [
        .. HasSun ? [SkyBody.Sun] : (SkyBody[])[], .. HasEarth ? [SkyBody.Earth] : (SkyBody[])[],
        .. HasPlanets ? SkyBody.Planets : [],
    ];

    /// <returns>Null if no sky is wanted.</returns>
    /// <exception cref="UsageException">A value is wrong, or an option has no meaning here.</exception>
    public static SkySettings? Read(OptionValues values)
    {
        bool isAll = SkyOptions.All.Read(values);
        string? catalogue = SkyOptions.Stars.ReadIfGiven(values) ?? (isAll ? StarCatalogueReader.BuiltIn : null);
        values.Refuse(
            catalogue is null ? [SkyOptions.StarLimit] : [],
            $"is given, but no {SkyOptions.Stars.Name}. Add that, or leave it out.");
        SkySettings settings = new()
        {
            Catalogue = catalogue is null ? null : Checked(catalogue),
            Faintest = SkyOptions.StarLimit.ReadIfGiven(values),
            HasPlanets = isAll || SkyOptions.Planets.Read(values),
            HasEarth = isAll || SkyOptions.Earth.Read(values),
            HasSun = isAll || SkyOptions.SunInView.Read(values),
            HasEarthshine = SkyOptions.Earthshine.Read(values),
        };
        if (!settings.IsDrawn && !settings.HasEarthshine)
        {
            return null;
        }

        OptionSpec given = SkyOptions.Group.Options.First(option => values.Words(option) is not null);
        if (LightOptions.IgnoreSun.Read(values))
        {
            throw given.Wrong(
                $"has no meaning with {LightOptions.IgnoreSun.Name}: the sky is as bright as it is beside sunlit ground. Leave one out.",
                LightOptions.IgnoreSun);
        }

        CelestialBody body = CelestialBody.Of(SurfaceOptions.Body.Read(values));
        return body.IsMoon || (!settings.HasEarthshine && settings.Bodies.All(other => (100 * other.NaifNumber) + 99 != body.NaifNumber))
            ? settings
            : throw given.Wrong(
                settings.HasEarthshine
                    ? $"draws {SkyOptions.Earthshine.Name} on the Moon only, and {body.NameInText} is drawn. Leave it out."
                    : $"would draw {body.NameInText} in its own sky. Leave {SkyOptions.Planets.Name} out.",
                SurfaceOptions.Body);
    }

    private static string Checked(string catalogue)
    {
        return !SkyOptions.IsFile(catalogue) ? StarCatalogueReader.BuiltIn
            : File.Exists(catalogue) ? catalogue
            : throw SkyOptions.Stars.Wrong(
                $"is '{catalogue}', which is neither a file nor '{StarCatalogueReader.BuiltIn}'. Give a catalogue: hip_main.dat of "
                    + "Hipparcos ('msis fetch stars' gets it), tyc2.dat of Tycho-2, or CSV with the columns ra_deg, dec_deg and v_mag.");
    }
}
