using System.Globalization;
using Msisf.Adapters.Tiles;
using Msisf.Core.Attitude;
using Msisf.Core.Blocks;
using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tiles;
using Msisf.Core.Tiles.Selection;
using Msisf.TestSupport;

namespace Msisf.Stress.Counts;

/// <summary>
/// What some images cost in counts that don't depend on the machine: a change that makes the program do more work shows here, however noisy
/// the times.
/// </summary>
public static class WorkCounts
{
    /// <summary>m, MOON_ME, at MJD 55289.</summary>
    private static readonly Vector3D Sun = new(1.074955473280880E+011, -1.042430734878980E+011, 4.036164305561260E+009);

    private static readonly (string Name, Vector3D Position, double Degrees)[] Views =
    [
        ("far", new Vector3D(2e6, 2e6, 0.0), 40.0),
        ("pole", new Vector3D(0.0, 0.0, 1.85e6), 60.0),
        ("nadir", new Vector3D(1.6e6, 8e5, 4e5), 40.0),
        ("disc", new Vector3D(8.66e6, 5e6, 0.0), 22.0),
    ];

    /// <summary>Counts of images of the real model.</summary>
    public static IEnumerable<string> OfLdem4() => Of("LDEM_4", MemoryElevationGrid.Ldem4(), Views, side: 512);

    /// <summary>
    /// Counts of images of a made-up model, with few enough pixels for levels of detail.
    /// </summary>
    public static IEnumerable<string> OfRuggedMoon() => Of("RUGGED_16", FunctionGrid.Rugged(16), Views[..2], side: 96);

    private static IEnumerable<string> Of(
        string model, IGlobalGrid grid, (string Name, Vector3D Position, double Degrees)[] views, int side)
    {
        LodLevels levels = LodLevels.Open(grid);
        string Line(string name, string count, long value) =>
            string.Create(CultureInfo.InvariantCulture, $"{model}\t{name}\t{count}\t{value}");
        foreach ((string name, Vector3D position, double degrees) in views)
        {
            PinholeCamera camera = new(position, NadirPointing.MoonFromCamera(position), double.DegreesToRadians(degrees), side, side);
            foreach ((string count, long value) in Of(camera, levels))
            {
                yield return Line(name, count, value);
            }
        }

        yield return Line("tile 10 N 20 E", "bytes of its pattern", BytesOfAPattern(grid));
    }

    private static IEnumerable<(string Count, long Value)> Of(PinholeCamera camera, LodLevels levels)
    {
        IGlobalGrid grid = levels.Level(0);
        yield return ("tiles", new Dspsa(grid).Select(camera, Sun).Kept.Count);
        foreach ((string name, IFrameTerrain detail) in new (string, IFrameTerrain)[]
            { ("blocks of the model", new FullDetail(grid)), ("blocks", new ModelDetail(levels, DetailRule.DefaultError)) })
        {
            SceneBlocks scene = new(detail.For(camera, 1));
            IReadOnlyList<SceneBlock> blocks = scene.Select(camera, Sun, rows: null, threads: 1, CancellationToken.None);
            yield return (name, blocks.Count);
            yield return ($"triangles of {name}", scene.CountFaces(blocks));
        }

        VisibilityCounts counts = new VisibilityPass(new SurfaceModel(grid)).Run(camera, 1, CancellationToken.None).Counts;
        yield return ("blocks read", counts.BlocksRead);
        yield return ("cells sieved", counts.CellsSieved);
        yield return ("facets drawn", counts.FacetsDrawn);
    }

    private static long BytesOfAPattern(IGlobalGrid grid)
    {
        TileMeshBuilder builder = new(grid);
        TileMeshLayout layout = TileMeshLayout.For(new TileId(10, 20), grid.PixelsPerDegree);
        using MemoryStream file = new();
        PatternWriter.Write(file, builder.Build(layout, builder.ReadRadii(layout)), grid.ProductId, PatternFormat.Mesh2);
        return file.Length;
    }
}
