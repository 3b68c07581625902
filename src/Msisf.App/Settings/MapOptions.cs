using Msisf.Adapters.Input;
using Msisf.App.Settings.Specs;
using Msisf.Core.Maps;
using Msisf.Core.Render;

namespace Msisf.App.Settings;

/// <summary>The option of maps onto which images are put.</summary>
internal static class MapOptions
{
    /// <summary>m: a cell of the size of a grain, and one of the size of a continent.</summary>
    private static readonly NumberRange Cells = new(0.001, 1_000_000.0);

    private static readonly (string Word, MapKind Kind)[] Kinds =
    [
        ("equirectangular", MapKind.Equirectangular), ("polar-stereographic", MapKind.PolarStereographic),
        ("orthographic", MapKind.Orthographic),
    ];

    public static TextSpec Map { get; } = new(
        "--map", DecidesBytes.UnlessDefault(frame => frame.Settings.Map is { } map ? TextOf(map) : null), "PROJECTION,CELL",
        "Puts each image, and the layers that are asked for, on a map for QGIS and GDAL, as Cloud Optimized GeoTIFFs: equirectangular, "
            + "polar-stereographic, or orthographic about the image's middle; CELL is the width of a cell in m. Ground that the image does "
            + "not show has no data")
    {
        Words = [.. Kinds.Select(kind => kind.Word)],
    };

    /// <returns>Null if no map is wanted.</returns>
    /// <exception cref="UsageException">The value is wrong, or the renderer does not know what its pixels show.</exception>
    public static MapSettings? Read(OptionValues values, RendererKind renderer)
    {
        if (Map.ReadIfGiven(values) is not { } text)
        {
            return null;
        }

        if (renderer == RendererKind.PovRay)
        {
            throw Map.Wrong("needs I/F of each pixel, which POV-Ray does not tell. Add --renderer native.", RendererOptions.Renderer);
        }

        string[] parts = text.Split(',', StringSplitOptions.TrimEntries);
        int kind = Array.FindIndex(Kinds, known => known.Word.Equals(parts[0], StringComparison.OrdinalIgnoreCase));
        return kind >= 0 && parts.Length == 2 && NumberText.TryParse(parts[1], out double cell) && Cells.Contains(cell)
            ? new MapSettings(Kinds[kind].Kind, cell)
            : throw Map.Wrong(
                $"{text}: {string.Join("|", Map.Words)} and the width of a cell are needed, {Cells} m: {Map.Name} {Kinds[0].Word},100 for "
                    + "instance.");
    }

    private static string TextOf(MapSettings map) =>
        Invariant($"{Kinds.First(kind => kind.Kind == map.Kind).Word},{map.Cell:R}");
}

/// <summary>The checked option of maps.</summary>
/// <param name="Cell">m: width of a cell.</param>
internal sealed record MapSettings(MapKind Kind, double Cell);
