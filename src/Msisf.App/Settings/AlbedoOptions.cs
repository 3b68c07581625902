using System.Text.RegularExpressions;
using Msisf.Adapters.Raster.Albedo;
using Msisf.App.Settings.Specs;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;

namespace Msisf.App.Settings;

/// <summary>The options of the map of the Moon's reflectance, and of the band.</summary>
internal static partial class AlbedoOptions
{
    /// <summary>The word in place of a map for none.</summary>
    public const string NoMap = "none";

    public static PathSpec Map { get; } = new(
        "--albedo-map", DecidesBytes.As(
            frame => frame.Settings.Albedo.NamesOfSeveral ?? (object?)frame.Map?.Name ?? (frame.MayHaveMap ? NoMap : null)),
        PathKind.Any,
        "Map of the Moon's reflectance: a PDS3 image (WAC_EMP, WAC_HAPKE, ...; of several tiles one, or their folder), or an image that "
            + "GDAL reads; none for no map; given several times, the finest map wins where it has data. Behind its path "
            + ",factor=auto makes it as bright as the map around it (unless its values are known), ,factor=F multiplies it, and "
            + "the properties of --albedo-map-properties are possible")
    {
        TakesSeveral = true,
        DefaultNote = "the one in ./input/albedo, then in the installation, with --reflectance moon; otherwise none",
    };

    public static TextSpec Properties { get; } = new(
        "--albedo-map-properties", DecidesBytes.As(frame => frame.Map is null ? null : frame.Settings.Albedo.Properties.ToString()), "LIST",
        "What the values of the one map mean, as in scale=3.16e-4,west=-180; also offset, incidence, emission, phase (degrees) and band "
            + "(nm)")
    {
        DefaultNote = "those of the known map, or of its label",
    };

    public static TextSpec Checksum { get; } = new(
        "--albedo-map-checksum", DecidesBytes.As(frame => frame.Map?.Sha256),
        "HEX", "SHA-256 that the map's file must have (of several tiles or maps that of all: docs/photometry.md)")
    {
        Form = (HexDigits(), "64 hexadecimal digits are needed"),
    };

    public static ChoiceSpec<int> Band { get; } = new(
        "--band", DecidesBytes.As(frame => frame.HasBand ? frame.Settings.Albedo.Band.Nanometres : null),
        [.. SpectralBand.All.Select(band => (NumberSpec.TextOf(band.Nanometres), band.Nanometres))],
        "Band of the law moon, of the map and of the radiance, nm")
    {
        Default = SpectralBand.Default.Nanometres,
    };

    public static OptionGroup Group { get; } = new("Albedo", [Map, Properties, Checksum, Band]);

    public static AlbedoSettings Read(OptionValues values)
    {
        IReadOnlyList<string> texts = Map.ReadAll(values);
        MapProperties properties =
            Properties.ReadIfGiven(values) is { } text ? Properties.Named(() => MapProperties.Parse(text)) : new MapProperties();
        bool isNone = texts.Any(path => Path.GetFileName(path) == NoMap);
        AlbedoMapPath[] maps = isNone ? [] : [.. texts.Select(path => Map.Named(() => AlbedoMapPath.Parse(path)))];
        CheckSeveral(values, texts, maps, isNone);
        properties = maps is [var only] ? only.Properties.Or(properties) : properties;
        return new AlbedoSettings(
            maps,
            texts.Count > 0,
            properties,
            Checksum.ReadIfGiven(values)?.ToLowerInvariant(),
            SpectralBand.Of(Band.Read(values)));
    }

    private static void CheckSeveral(OptionValues values, IReadOnlyList<string> texts, AlbedoMapPath[] maps, bool isNone)
    {
        if (isNone && texts.Count > 1)
        {
            throw Map.Wrong($"{NoMap} is given beside a map. Leave one of them out.");
        }

        if (maps is [{ Factor: not null } or { IsMatched: true }])
        {
            throw Map.Wrong(
                $"{maps[0]}: factor= scales a map to the coarser one around it, and there is none. Give that one too, or scale=.");
        }

        if (maps.Length > 1 && Properties.ReadIfGiven(values) is not null)
        {
            throw Properties.Wrong(
                $"is for one map; of several write the properties behind each path, as in {maps[0].Path},scale=3.16e-4.", Map);
        }

        if (maps.GroupBy(map => Path.GetFullPath(map.Path)).FirstOrDefault(same => same.Count() > 1) is { } twice)
        {
            throw Map.Wrong($"{twice.First().Path} is given twice. Leave one of them out.");
        }

        if (maps.Length > 1 && RendererOptions.Renderer.Read(values) == RendererKind.PovRay)
        {
            throw new UsageException(
                $"several {Map.Name} are drawn by the native renderer only. Add {RendererOptions.Renderer.Name} "
                    + $"{RendererOptions.Renderer.WordOf(RendererKind.Native)}, or give one map.").About(Map, RendererOptions.Renderer);
        }
    }

    [GeneratedRegex("^[0-9A-Fa-f]{64}$")]
    private static partial Regex HexDigits();
}

/// <summary>The checked options of the map of the Moon's reflectance.</summary>
/// <param name="Maps">The maps; empty for none, or for the installed one.</param>
/// <param name="IsGiven">Whether the user names a map, or none; if not, an installed map may be used.</param>
/// <param name="Properties">Properties of the one map that the user gives.</param>
/// <param name="Sha256">SHA-256 that the map must have; null for any.</param>
/// <param name="Band">Band of the law moon, of the map and of the radiance.</param>
internal sealed record AlbedoSettings(
    IReadOnlyList<AlbedoMapPath> Maps, bool IsGiven, MapProperties Properties, string? Sha256, SpectralBand Band)
{
    /// <summary>Several maps as the arguments of a frame name them, in any order; null for one.</summary>
    public IEnumerable<string>? NamesOfSeveral =>
        Maps.Count > 1 ? Maps.Select(map => map.TextWith(Path.GetFileName(map.Path))).Order(StringComparer.Ordinal) : null;

    /// <summary>Tells other maps, or other uses of them, apart.</summary>
    public string Key => $"{string.Join('\n', Maps)} {IsGiven} {Properties} {Sha256} {Band}";
}
