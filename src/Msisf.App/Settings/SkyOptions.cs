using Msisf.Adapters.Catalogues;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>The options of the sky behind the Moon.</summary>
internal static class SkyOptions
{
    /// <summary>V: brighter than all stars, and fainter than all that are known.</summary>
    private static readonly NumberRange Magnitudes = new(-2.0, 30.0);

    public static TextSpec Stars { get; } = new(
        "--stars", DecidesBytes.As(frame => frame.Native?.Sky is { } sky ? Path.GetFileName(sky.Catalogue) : null).OfRuns(), "FILE",
        "Draws stars: those to V 6.0 that come with msis (bright, also without a value), of Hipparcos (hip_main.dat), of Tycho-2 "
            + "(tyc2.dat) or of a CSV file")
    {
        ValueIfBare = StarCatalogueReader.BuiltIn,
        Words = [StarCatalogueReader.BuiltIn],
    };

    public static NumberSpec StarLimit { get; } = new(
        "--star-limit", DecidesBytes.As(frame => frame.Native?.Sky?.Faintest).OfRuns(), "V", "Leaves out stars that are fainter")
    {
        Limits = Magnitudes,
        DefaultNote = "all of the catalogue",
    };

    public static OptionGroup Group { get; } = new("Sky", [Stars, StarLimit])
    {
        Note = "Only with --renderer native.",
    };
}

/// <summary>The checked options of the sky.</summary>
internal sealed record SkySettings
{
    /// <summary>The catalogue of stars: a path, or the word for the one that comes with the program.</summary>
    public required string Catalogue { get; init; }

    /// <summary>V of the faintest stars that are drawn; null for all.</summary>
    public double? Faintest { get; init; }

    /// <returns>Null if no sky is wanted.</returns>
    /// <exception cref="UsageException">A value is wrong, or an option has no meaning here.</exception>
    public static SkySettings? Read(OptionValues values)
    {
        string? catalogue = SkyOptions.Stars.ReadIfGiven(values);
        values.Refuse(
            catalogue is null ? [SkyOptions.StarLimit] : [],
            $"is given, but no {SkyOptions.Stars.Name}. Add that, or leave it out.");
        if (catalogue is null)
        {
            return null;
        }

        if (LightOptions.IgnoreSun.Read(values))
        {
            throw SkyOptions.Stars.Wrong(
                $"has no meaning with {LightOptions.IgnoreSun.Name}: stars are as bright as they are beside sunlit ground. Leave one out.",
                LightOptions.IgnoreSun);
        }

        string name = ChoiceSpec.IsSame(StarCatalogueReader.BuiltIn, catalogue) ? StarCatalogueReader.BuiltIn : catalogue;
        return name == StarCatalogueReader.BuiltIn || File.Exists(name)
            ? new SkySettings { Catalogue = name, Faintest = SkyOptions.StarLimit.ReadIfGiven(values) }
            : throw SkyOptions.Stars.Wrong(
                $"is '{name}', which is neither a file nor '{StarCatalogueReader.BuiltIn}'. Give a catalogue: hip_main.dat of Hipparcos, "
                    + "tyc2.dat of Tycho-2, or CSV with the columns ra_deg, dec_deg and v_mag.");
    }
}
