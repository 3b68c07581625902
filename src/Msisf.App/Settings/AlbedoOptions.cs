using System.Text.RegularExpressions;
using Msisf.Adapters.Raster.Albedo;
using Msisf.App.Settings.Specs;
using Msisf.Core.Render.Photometry;

namespace Msisf.App.Settings;

/// <summary>The options of the map of the Moon's reflectance, and of the band.</summary>
internal static partial class AlbedoOptions
{
    /// <summary>The word in place of a map for none.</summary>
    public const string NoMap = "none";

    /// <summary>The map.</summary>
    public static PathSpec Map { get; } = new(
        "--albedo-map", DecidesBytes.As(frame => frame.Map?.Name ?? (frame.MayHaveMap ? NoMap : null)), PathKind.Any,
        "Map of the Moon's reflectance: a PDS3 image (WAC_EMP, WAC_HAPKE, ...; of several tiles one, or their folder), or an image that "
            + "GDAL reads; none for no map")
    {
        DefaultNote = "the one in ./input/albedo, then in the installation, with --reflectance moon; else none",
    };

    /// <summary>What the map's values mean.</summary>
    public static TextSpec Properties { get; } = new(
        "--albedo-map-properties", DecidesBytes.As(frame => frame.Map is null ? null : frame.Settings.Albedo.Properties.ToString()), "LIST",
        "What the map's values mean, as in scale=3.16e-4,west=-180; also offset, incidence, emission, phase (degrees) and band (nm)")
    {
        DefaultNote = "those of the known map, or of its label",
    };

    /// <summary>Checksum of the map.</summary>
    public static TextSpec Checksum { get; } = new(
        "--albedo-map-checksum", DecidesBytes.As(frame => frame.Map?.Sha256),
        "HEX", "SHA-256 that the map's file must have (of several tiles that of all: docs/photometry.md)")
    {
        Form = (HexDigits(), "64 hexadecimal digits are needed"),
    };

    /// <summary>Spectral band.</summary>
    public static ChoiceSpec<int> Band { get; } = new(
        "--band", DecidesBytes.As(frame => frame.HasBand ? frame.Settings.Albedo.Band.Nanometres : null),
        [.. SpectralBand.All.Select(band => (NumberSpec.TextOf(band.Nanometres), band.Nanometres))],
        "Band of the law moon, of the map and of the radiance, nm")
    {
        Default = SpectralBand.Default.Nanometres,
    };

    /// <summary>The options of this class as a group of the help text.</summary>
    public static OptionGroup Group { get; } = new("Albedo", [Map, Properties, Checksum, Band]);

    /// <summary>Reads the options.</summary>
    /// <exception cref="Core.Errors.MsisfException">A value is wrong.</exception>
    public static AlbedoSettings Read(OptionValues values)
    {
        string? path = Map.ReadIfGiven(values);
        return new AlbedoSettings(
            path is not null && Path.GetFileName(path) == NoMap ? null : path,
            path is not null,
            Properties.ReadIfGiven(values) is { } text ? Properties.Named(() => MapProperties.Parse(text)) : new MapProperties(),
            Checksum.ReadIfGiven(values)?.ToLowerInvariant(),
            SpectralBand.Of(Band.Read(values)));
    }

    [GeneratedRegex("^[0-9A-Fa-f]{64}$")]
    private static partial Regex HexDigits();
}

/// <summary>The checked options of the map of the Moon's reflectance.</summary>
/// <param name="MapPath">The map; null for none, or for the installed one.</param>
/// <param name="IsGiven">Whether the user names a map, or none; if not, an installed map may be used.</param>
/// <param name="Properties">Properties of the map that the user gives.</param>
/// <param name="Sha256">SHA-256 that the map must have; null for any.</param>
/// <param name="Band">Band of the law moon, of the map and of the radiance.</param>
internal sealed record AlbedoSettings(
    string? MapPath, bool IsGiven, MapProperties Properties, string? Sha256, SpectralBand Band);
