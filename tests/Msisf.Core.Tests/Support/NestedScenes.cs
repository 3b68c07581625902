using System.Collections.Concurrent;
using Msisf.Core.Lod;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.TestSupport;

namespace Msisf.Core.Tests.Support;

/// <summary>Scenes of several small models.</summary>
internal static class NestedScenes
{
    private static readonly ConcurrentDictionary<string, Lazy<NestedTerrain>> Made = new(StringComparer.Ordinal);
    private static readonly ConcurrentDictionary<string, Lazy<NestedLevels>> Levels = new(StringComparer.Ordinal);
    private static readonly ConcurrentDictionary<string, Lazy<AllFacets>> Collected = new(StringComparer.Ordinal);

    /// <summary>The names; a level of each model may follow, the coarsest first, or a hyphen for none.</summary>
    public static IReadOnlyList<string> Names { get; } =
    [
        "polar", "north", "five", "beside-the-pole", "band", "crossing", "gaps", "piece", "meridian", "one-corner-at-the-pole",
        "five at 0-102", "gaps at 02", "meridian at 011",
    ];

    /// <summary>The models of a scene, in no order.</summary>
    public static IReadOnlyList<ITerrainGrid> ModelsOf(string name)
    {
        FunctionGrid moon = FunctionGrid.Rugged(1);
        return name switch
        {
            "polar" => [moon, Map(true, 6000.0, 90, 44.5, 44.5)],
            "north" => [moon, Map(false, 6000.0, 75, 30.25, 44.5), Map(false, 700.0, 70, 34.5, 34.5)],
            "five" =>
            [
                Map(true, 4000.0, 100, 49.5, 49.5), moon, Map(true, 20.0, 64, 1031.5, 31.5), Map(true, 600.0, 90, 44.5, 44.5),
                Map(true, 100.0, 80, 239.5, 39.5),
            ],
            "beside-the-pole" => [moon, Map(true, 5000.0, 64, -6.5, 40.0), Map(true, 300.0, 64, -900.5, -1031.5)],
            "band" => [moon, Part(4, new GridWindow(4 * 70, 4 * 80, 0, 1440))],
            "crossing" => [moon, Map(true, 5000.0, 70, 34.5, 34.5), Map(true, 900.0, 80, 39.5, -150.5)],
            "gaps" =>
            [
                moon,
                new GridWithGaps(
                    Map(true, 4000.0, 120, 59.5, 59.5),
                    (line, sample) => ((line - 40) * (line - 40)) + ((sample - 70) * (sample - 70)) < 90
                        || (line is > 56 and < 63 && sample is > 56 and < 63)
                        || (line + sample) % 97 == 3 || (line == 90 && sample % 2 == 0) || sample > 100 + (line / 9)),
            ],
            "piece" =>
            [
                moon, Part(6, new GridWindow(6 * 85, 6 * 95, 6 * 40, (6 * 55) + 3)), Part(24, new GridWindow(2100, 2164, 1100, 1180)),
            ],
            "meridian" =>
            [
                moon, Part(6, new GridWindow(6 * 60, 6 * 75, 6 * 350, (6 * 368) + 1)), Part(24, new GridWindow(1560, 1640, 8600, 8690)),
            ],
            "one-corner-at-the-pole" => [moon, Map(true, 2000.0, 64, 0.0, 0.0), Map(false, 3000.0, 64, 3.5, 60.25)],
            _ => throw new ArgumentOutOfRangeException(nameof(name), name, "No scene has that name."),
        };
    }

    /// <summary>A scene, made once for all tests.</summary>
    public static NestedTerrain Named(string name) =>
        Made.GetOrAdd(name, static made => new(() => made.Split(" at ") is [string scene, string levels]
            ? LevelsOf(scene).Terrain([.. levels.Select(level => level == '-' ? (int?)null : level - '0')])
            : new NestedTerrain(ModelsOf(made), new SeamMemory()))).Value;

    /// <summary>The levels of a scene.</summary>
    public static NestedLevels LevelsOf(string name) => Levels.GetOrAdd(name, static made => new(() => NewLevelsOf(Named(made)))).Value;

    /// <summary>The levels of a surface; nothing is kept of other tests.</summary>
    public static NestedLevels NewLevelsOf(NestedTerrain scene) => new(scene, [.. scene.Models.Select(
        TerrainLevels (model) => model is IGlobalGrid moon ? LodLevels.Open(moon) : MapLevels.Open(model, keepsGaps: true))]);

    /// <summary>All facets of a scene, collected once for all tests.</summary>
    public static AllFacets FacetsOf(string name) => Collected.GetOrAdd(name, static made => new(() => new AllFacets(Named(made)))).Value;

    private static PolarFunctionGrid Map(bool isSouth, double scale, int side, double poleLine, double poleSample) =>
        PolarFunctionGrid.Rugged(isSouth, scale, side, poleLine, poleSample);

    private static WindowGrid Part(int pixelsPerDegree, GridWindow window) => new(FunctionGrid.Rugged(pixelsPerDegree), window);
}
