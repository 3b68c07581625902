using Msisf.Adapters.Catalogues;
using Msisf.App.Settings.Specs;
using Msisf.Core.Sky;

namespace Msisf.App.Settings;

/// <summary>The options of the sky behind the Moon.</summary>
internal static class SkyOptions
{
    /// <summary>V: brighter than all stars, and fainter than all that are known.</summary>
    private static readonly NumberRange Magnitudes = new(-2.0, 30.0);

    public static FlagSpec All { get; } = new(
        "--sky", DecidesBytes.ByOthers, "Draws all of the sky: --stars, --planets, --earth, --sun-in-view");

    public static TextSpec Stars { get; } = new(
        "--stars", DecidesBytes.As(frame => frame.Native?.Sky?.Catalogue is { } name ? Path.GetFileName(name) : null), "FILE",
        "Draws stars: those to V 6.0 that come with msis (bright, also without a value), of Hipparcos (hip_main.dat), of Tycho-2 "
            + "(tyc2.dat) or of a CSV file")
    {
        ValueIfBare = StarCatalogueReader.BuiltIn,
        Words = [StarCatalogueReader.BuiltIn],
    };

    public static NumberSpec StarLimit { get; } = new(
        "--star-limit", DecidesBytes.As(frame => frame.Native?.Sky?.Faintest), "V", "Leaves out stars that are fainter")
    {
        Limits = Magnitudes,
        DefaultNote = "all of the catalogue",
    };

    public static FlagSpec Planets { get; } = new(
        "--planets", DecidesBytes.As(frame => frame.Native?.Sky?.HasPlanets), "Draws the planets but the Earth");

    public static FlagSpec Earth { get; } = new(
        "--earth", DecidesBytes.As(frame => frame.Native?.Sky?.HasEarth), "Draws the Earth");

    public static FlagSpec SunInView { get; } = new(
        "--sun-in-view", DecidesBytes.As(frame => frame.Native?.Sky?.HasSun), "Draws the Sun");

    public static FlagSpec Earthshine { get; } = new(
        "--earthshine", DecidesBytes.As(frame => frame.Native?.Sky?.HasEarthshine), "Lights the ground by the Earth too");

    /// <summary>The options that draw something behind the ground.</summary>
    public static IReadOnlyList<OptionSpec> Drawn => [All, Stars, Planets, Earth, SunInView];

    /// <summary>Whether a text names a catalogue by a file, and not the one that comes with the program.</summary>
    public static bool IsFile(string catalogue) => !ChoiceSpec.IsSame(StarCatalogueReader.BuiltIn, catalogue);

    /// <summary>The option that draws a body.</summary>
    public static OptionSpec Of(SkyBody body) => body == SkyBody.Sun ? SunInView : body == SkyBody.Earth ? Earth : Planets;

    public static OptionGroup Group { get; } = new("Sky", [All, Stars, StarLimit, Planets, Earth, SunInView, Earthshine])
    {
        Note = "Only with --renderer native.",
    };
}
