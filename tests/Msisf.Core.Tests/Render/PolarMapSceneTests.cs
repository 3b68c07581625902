using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render;

/// <summary>Polar maps: the tracer against every facet, the renderer against the tracer.</summary>
public sealed class PolarMapSceneTests
{
    private static readonly NativeRenderOptions Options = new() { Reflectance = new LambertReflectance(0.64), KeepGroundTruth = true };

    /// <summary>
    /// Pole in the middle, near a side, far outside; cells of 3 km to 1 m; also coarser levels of maps that end in the middle of their
    /// cells. The last number is the level.
    /// </summary>
    public static TheoryData<bool, double, int, double, double, int> Maps => new()
    {
        { true, 3000.0, 70, 34.5, 34.5, 0 },
        { false, 3000.0, 70, 34.5, 34.5, 0 },
        { false, 500.0, 65, 7.0, 60.0, 0 },
        { true, 20.0, 70, 12000.0, -9000.5, 0 },
        { true, 1.0, 70, -800.25, 40.0, 0 },
        { true, 1500.0, 139, 69.0, 69.0, 1 },
        { false, 5.0, 273, 90.0, 21000.5, 2 },
    };

    [Theory]
    [MemberData(nameof(Maps))]
    public void Trace_PolarMap_IsAsBruteForce(
        bool isSouth, double scale, int side, double poleLine, double poleSample, int level)
    {
        ITerrainGrid grid = LevelOf(PolarFunctionGrid.Rugged(isSouth, scale, side, poleLine, poleSample), level);
        TerrainTracer tracer = new(grid);
        BruteForceMap facets = new(grid);
        List<string> wrong = [];
        int hits = 0;
        int lit = 0;
        int rays = TestLength.Of(25, 300);
        foreach (Scene scene in ScenesOf(grid))
        {
            Random random = new(20120222);
            for (int number = 0; number < rays; number++)
            {
                Ray ray = scene.Camera.RayThrough(random.Next(1, 201), random.Next(1, 201));
                bool isHit = tracer.TryTrace(ray, out SurfaceHit hit);
                (FacetId Facet, Vector3D Point, double T)? expected = facets.FirstHit(ray.Origin, ray.Direction);
                bool isSame = expected is null == !isHit && (!isHit || (expected!.Value.Point - hit.PointBodyFixed).Length <= 1e-7);
                bool isHidden = isHit && tracer.IsHidden(hit.PointBodyFixed, hit.Facet, scene.Sun);
                isSame &= !isHit || facets.IsShadowed(hit.Facet, hit.PointBodyFixed, scene.Sun) == isHidden;
                hits += isHit ? 1 : 0;
                lit += isHit && !isHidden ? 1 : 0;
                if (!isSame)
                {
                    wrong.Add($"{scene.Name} {number}: {(isHit ? hit : null)}, {isHidden}; by brute force {expected}");
                }
            }
        }

        Assert.True(wrong.Count == 0, string.Join(Environment.NewLine, wrong.Take(10)));
        Assert.InRange(hits, rays, (rays * ScenesOf(grid).Count) - 1);
        Assert.InRange(lit, hits / 5, hits - 1);
    }

    [Theory]
    [MemberData(nameof(Maps))]
    public void Trace_RaysAtVerticesAndEdges_HitTheMap(
        bool isSouth, double scale, int side, double poleLine, double poleSample, int level)
    {
        ITerrainGrid grid = LevelOf(PolarFunctionGrid.Rugged(isSouth, scale, side, poleLine, poleSample), level);
        TerrainTracer tracer = new(grid);
        BruteForceMap vertices = new(grid);
        Random random = new(20120223);
        int aimed = 0;
        foreach (Scene scene in ScenesOf(grid))
        {
            for (int number = 0; number < 300; number++)
            {
                (int line, int sample) = (random.Next(2, grid.Lines - 3), random.Next(2, grid.Lines - 3));
                if (!vertices.FacesAround(line, sample, scene.Camera.PositionBodyFixed))
                {
                    continue; // a ray at a crest may pass above it, with nothing behind
                }

                aimed++;
                Vector3D target = vertices[line, sample];
                Vector3D next = vertices[line + (number % 2), sample + ((number >> 1) % 2)];
                Vector3D aim = target + ((number % 3) * 0.5 * (next - target));
                Assert.True(
                    tracer.TryTrace(new Ray(scene.Camera.PositionBodyFixed, aim - scene.Camera.PositionBodyFixed), out _),
                    $"{scene.Name}: a ray at line {line}, sample {sample} falls through.");
            }
        }

        Assert.InRange(aimed, 500, 1800);
    }

    [Theory]
    [MemberData(nameof(Maps))]
    public void Render_PolarMap_IsAsTraced(
        bool isSouth, double scale, int side, double poleLine, double poleSample, int level)
    {
        ITerrainGrid grid = LevelOf(PolarFunctionGrid.Rugged(isSouth, scale, side, poleLine, poleSample), level);
        NativeRenderer renderer = new(grid);
        TerrainTracer tracer = new(grid);
        List<string> wrong = [];
        int step = TestLength.Of(13, 1);
        foreach (Scene scene in ScenesOf(grid))
        {
            SceneLight sun = new(scene.Sun, IsSun: true);
            TracedFrameTruth traced = new(scene.Camera, sun, tracer);
            using NativeFrame drawn = renderer.Render(scene.Camera, sun, Options, threads: 2);
            for (int pixel = 0; pixel < 200 * 200; pixel += step)
            {
                (int x, int y) = ((pixel % 200) + 1, (pixel / 200) + 1);
                bool isSurface = traced.TryGet(x, y, out SurfaceHit expected, out PixelIllumination expectedLight);
                bool isDrawn = drawn.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light);
                if (isDrawn != isSurface || hit.Facet != expected.Facet || light != expectedLight
                    || !((hit.PointBodyFixed - expected.PointBodyFixed).Length <= 1e-7))
                {
                    wrong.Add($"{scene.Name} ({x}, {y}): {hit} {light}; traced {expected} {expectedLight}");
                }
            }
        }

        Assert.True(wrong.Count == 0, $"{wrong.Count}:{Environment.NewLine}{string.Join(Environment.NewLine, wrong.Take(10))}");
    }

    [Theory]
    [MemberData(nameof(Maps))]
    public void Render_ViewInsideTheMap_HasNoHole(
        bool isSouth, double scale, int side, double poleLine, double poleSample, int level)
    {
        ITerrainGrid grid = LevelOf(PolarFunctionGrid.Rugged(isSouth, scale, side, poleLine, poleSample), level);
        Scene down = ScenesOf(grid)[0];
        using NativeFrame drawn = new NativeRenderer(grid).Render(down.Camera, new SceneLight(down.Sun, IsSun: true), Options, threads: 2);
        for (int pixel = 0; pixel < 200 * 200; pixel++)
        {
            Assert.True(drawn.TryGet((pixel % 200) + 1, (pixel / 200) + 1, out _, out _), $"pixel {pixel % 200}, {pixel / 200}");
        }
    }

    private static ITerrainGrid LevelOf(PolarFunctionGrid map, int level) => level == 0 ? map : MapLevels.Open(map).Grid(level);

    /// <summary>Cameras over the middle of a map; the first looks straight down and sees nothing but the map.</summary>
    private static List<Scene> ScenesOf(ITerrainGrid grid)
    {
        double cell = grid.Projection.Resolution.MetresPerPixel;
        double extent = cell * grid.Samples;
        Vector3D up = grid.Projection.DirectionOf(0.5 * grid.Lines, 0.52 * grid.Samples);
        SelenographicPoint middle = SelenographicPoint.Below(up);
        (double latitude, double longitude) = (double.RadiansToDegrees(middle.Latitude), double.RadiansToDegrees(middle.Longitude));
        return
        [
            SceneOf("down", 0.8 * extent, 0.0, 0.0, 40.0, 30.0, 100.0),
            SceneOf("wide", 0.8 * extent, 10.0, 60.0, 100.0, 20.0, 200.0),
            SceneOf("oblique", 0.1 * extent, 60.0, 130.0, 60.0, 12.0, 20.0),
            SceneOf("low", 2.0 * cell, 85.0, 300.0, 70.0, 8.0, 250.0),
            SceneOf("from afar", 50.0 * extent, 0.0, 0.0, 2.0, 35.0, 300.0),
            SceneOf("grazing sun", 0.5 * extent, 30.0, 200.0, 60.0, 2.0, 10.0),
        ];

        Scene SceneOf(string name, double height, double tilt, double azimuth, double fov, double sunElevation, double sunAzimuth)
        {
            RenderScenes.RenderSceneCase scene = new(
                name, latitude, longitude, height + (4.0 * cell), tilt, azimuth, fov, sunElevation, sunAzimuth);
            return new Scene(name, scene.Camera(grid, 200, 200), scene.Sun);
        }
    }

    private sealed record Scene(string Name, PinholeCamera Camera, Vector3D Sun);
}
