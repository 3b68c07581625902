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
        "--sky", DecidesBytes.ByOthers.OfRuns(), "Draws all of the sky: --stars, --planets, --earth, --sun-in-view");

    public static TextSpec Stars { get; } = new(
        "--stars", DecidesBytes.As(frame => frame.Native?.Sky?.Catalogue is { } name ? Path.GetFileName(name) : null).OfRuns(), "FILE",
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

    public static FlagSpec Planets { get; } = new(
        "--planets", DecidesBytes.As(frame => frame.Native?.Sky?.HasPlanets).OfRuns(), "Draws the planets but the Earth");

    public static FlagSpec Earth { get; } = new(
        "--earth", DecidesBytes.As(frame => frame.Native?.Sky?.HasEarth).OfRuns(), "Draws the Earth");

    public static FlagSpec SunInView { get; } = new(
        "--sun-in-view", DecidesBytes.As(frame => frame.Native?.Sky?.HasSun).OfRuns(), "Draws the Sun");

    public static FlagSpec Earthshine { get; } = new(
        "--earthshine", DecidesBytes.As(frame => frame.Native?.Sky?.HasEarthshine).OfRuns(), "Lights the ground by the Earth too");

    /// <summary>The options that draw something behind the ground.</summary>
    public static IReadOnlyList<OptionSpec> Drawn => [All, Stars, Planets, Earth, SunInView];

    /// <summary>The option that draws a body.</summary>
    public static OptionSpec Of(SkyBody body) => body == SkyBody.Sun ? SunInView : body == SkyBody.Earth ? Earth : Planets;

    public static OptionGroup Group { get; } = new("Sky", [All, Stars, StarLimit, Planets, Earth, SunInView, Earthshine])
    {
        Note = "Only with --renderer native.",
    };
}
