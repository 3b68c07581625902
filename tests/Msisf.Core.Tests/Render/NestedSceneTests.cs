using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;
using Xunit.Abstractions;

namespace Msisf.Core.Tests.Render;

/// <summary>Scenes of several models: the tracer against every facet, the renderer against the tracer.</summary>
public sealed class NestedSceneTests(ITestOutputHelper output)
{
    private const int Size = 96;

    /// <summary>1: how much lower than their vertices facets lie, of the radius, at 1 px/deg; sides of seams are longer.</summary>
    private const double ChordSag = 1e-3;

    private static readonly NativeRenderOptions Options = new() { Reflectance = new LambertReflectance(0.64), KeepGroundTruth = true };

    public static TheoryData<string> Scenes => [.. NestedScenes.Names];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Trace_AnyRay_IsAsBruteForce(string name)
    {
        NestedTerrain terrain = NestedScenes.Named(name);
        AllFacets all = NestedScenes.FacetsOf(name);
        TerrainTracer tracer = new(terrain);
        Random random = new(20120222);
        List<string> wrong = [];
        int rays = 0;
        int hits = 0;
        int shadowed = 0;
        foreach (View view in ViewsOf(terrain))
        {
            for (int number = 0; number < TestLength.Of(8, 400); number++)
            {
                rays++;

                // Rays at edges and corners meet several facets, of which one may be lit and another not.
                bool isAtEdge = number % 4 == 1;
                Ray ray = number % 2 == 0
                    ? view.Camera.RayThrough(random.Next(1, Size + 1), random.Next(1, Size + 1))
                    : Aimed(terrain.Surface.Seams, view, isAtEdge, random);
                bool isHit = tracer.TryTrace(ray, out SurfaceHit hit);
                (FacetId Facet, Vector3D Point, double T)? expected = all.FirstHit(ray.Origin, ray.Direction);
                bool isSame = expected is null == !isHit && (!isHit || (expected!.Value.Point - hit.PointBodyFixed).Length <= 1e-6);
                if (isHit && isSame && !isAtEdge)
                {
                    bool isHidden = tracer.IsHidden(hit.PointBodyFixed, hit.Facet, view.Sun);
                    bool isLit = Vector3D.Dot(hit.NormalBodyFixed, view.Sun - hit.PointBodyFixed) > 0.0
                        && !all.IsShadowed(hit.Facet, hit.PointBodyFixed, view.Sun);
                    isSame = isHidden == !isLit;
                    shadowed += isHidden ? 1 : 0;
                    hits++;
                }

                if (!isSame)
                {
                    wrong.Add($"{view.Name} {number}: {hit}; by brute force {expected}");
                }
            }
        }

        output.WriteLine($"{name}: {rays} rays, {hits} compared for light, {shadowed} of them dark, {wrong.Count} wrong");
        Assert.True(wrong.Count == 0, $"{wrong.Count}: {string.Join(Environment.NewLine, wrong.Take(10))}");
        Assert.True(hits > 20 && shadowed > 0 && shadowed < hits, $"{hits} hits, {shadowed} of them dark");
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Render_AnyPixel_IsAsTraced(string name)
    {
        NestedTerrain terrain = NestedScenes.Named(name);
        NativeRenderer renderer = new(terrain);
        TerrainTracer tracer = new(terrain);
        List<string> wrong = [];
        HashSet<int> parts = [];
        foreach (View view in ViewsOf(terrain))
        {
            SceneLight sun = new(view.Sun, IsSun: true);
            TracedFrameTruth traced = new(view.Camera, sun, tracer);
            using NativeFrame drawn = renderer.Render(view.Camera, sun, Options, threads: 2);
            for (int pixel = 0; pixel < Size * Size; pixel += TestLength.Of(11, 1))
            {
                (int x, int y) = ((pixel % Size) + 1, (pixel / Size) + 1);
                bool isSurface = traced.TryGet(x, y, out SurfaceHit expected, out PixelIllumination expectedLight);
                bool isDrawn = drawn.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light);
                parts.Add(hit.Facet.Part);
                if (isDrawn != isSurface || hit.Facet != expected.Facet || light != expectedLight
                    || !((hit.PointBodyFixed - expected.PointBodyFixed).Length <= 1e-6))
                {
                    wrong.Add($"{view.Name} ({x}, {y}): {hit} {light}; traced {expected} {expectedLight}");
                }
            }
        }

        Assert.True(wrong.Count == 0, $"{wrong.Count}:{Environment.NewLine}{string.Join(Environment.NewLine, wrong.Take(10))}");
        Assert.Contains(0, parts);
        Assert.Contains(terrain.PartCount - 1, parts);
        Assert.Contains(terrain.PartCount, parts); // seams
    }

    /// <summary>No ray that must meet the ground passes through it: at seams, their corners, around holes, and at the poles.</summary>
    [Theory]
    [MemberData(nameof(Scenes))]
    public void Render_SmallViewsOverSeams_HaveNoHole(string name)
    {
        NestedTerrain terrain = NestedScenes.Named(name);
        NativeRenderer renderer = new(terrain);
        double lowest = (1.0 - ChordSag) * terrain.RadiusLimits.Min;
        Random random = new(20120223);
        List<string> wrong = [];
        int views = TestLength.Of(40, 2_000); // of each scene: 26,000 of all
        long inside = 0;
        for (int number = 0; number < views; number++)
        {
            double height = Math.Pow(10.0, 1.0 + (4.0 * random.NextDouble()));
            double tilt = number % 2 == 0 ? 0.0 : 75.0 * random.NextDouble();
            RenderScenes.RenderSceneCase scene = SceneAt(
                "small", TargetOf(terrain.Surface.Seams, number, random), height, tilt, random.Next(360), 25.0, 20.0, 100.0);
            PinholeCamera camera = scene.Camera(terrain, 24, 24);
            using NativeFrame drawn = renderer.Render(camera, new SceneLight(scene.Sun, IsSun: true), Options, threads: 1);
            for (int pixel = 0; pixel < 24 * 24; pixel++)
            {
                (int x, int y) = ((pixel % 24) + 1, (pixel / 24) + 1);
                if (RayGeometry.NearestApproach(camera.RayThrough(x, y)) < lowest)
                {
                    inside++;
                    if (!drawn.TryGetSurface(x, y, out _))
                    {
                        wrong.Add($"view {number}, {height} m, {tilt} degrees, pixel ({x}, {y})");
                    }
                }
            }
        }

        output.WriteLine($"{name}: {views} views, {inside} pixels inside the disc, {wrong.Count} of them background");
        Assert.True(wrong.Count == 0, $"{wrong.Count}:{Environment.NewLine}{string.Join(Environment.NewLine, wrong.Take(10))}");
        Assert.True(inside > 0.9 * 24 * 24 * views, $"only {inside} pixels look at the ground");
    }

    [Fact]
    public void Render_MoreThreadsOrAnotherOrder_GivesTheSameImage()
    {
        IReadOnlyList<ITerrainGrid> models = NestedScenes.ModelsOf("five");
        View view = ViewsOf(NestedScenes.Named("five"))[1];
        SceneLight sun = new(view.Sun, IsSun: true);
        using NativeFrame one = new NativeRenderer(new NestedTerrain(models)).Render(view.Camera, sun, Options, threads: 1);
        using NativeFrame other = new NativeRenderer(new NestedTerrain(models.Reverse())).Render(view.Camera, sun, Options, threads: 4);
        Assert.True(one.RadianceFactors.SequenceEqual(other.RadianceFactors));
    }

    /// <summary>A disc as the Sun, adaptive samples, smooth normals and a lens draw the seams too.</summary>
    [Theory]
    [InlineData(SunModel.Disc, NormalModel.Facet)]
    [InlineData(SunModel.Point, NormalModel.Smooth)]
    [InlineData(SunModel.Disc, NormalModel.Smooth)]
    public void Render_OtherOptions_LightTheSeams(SunModel model, NormalModel normals)
    {
        NestedTerrain terrain = NestedScenes.Named("polar");
        View view = ViewsOf(terrain)[0];
        NativeRenderOptions options = Options with { Sun = model, Normals = normals };
        using NativeFrame drawn = new NativeRenderer(terrain).Render(
            view.Camera, new SceneLight(view.Sun, IsSun: true), options, threads: 2);
        int seams = 0;
        int lit = 0;
        for (int pixel = 0; pixel < Size * Size; pixel++)
        {
            bool isSurface = drawn.TryGet((pixel % Size) + 1, (pixel / Size) + 1, out SurfaceHit hit, out PixelIllumination light);
            if (isSurface && hit.Facet.Part == terrain.PartCount && light.VisibleFraction == 1.0)
            {
                seams++;
                Assert.InRange(Vector3D.Dot(hit.NormalBodyFixed, hit.PointBodyFixed.Normalized()), 0.3, 1.0);
                lit += drawn.RadianceFactors[pixel] is > 0.0 and <= 0.64 ? 1 : 0; // a smooth normal may turn away from the Sun
            }
        }

        Assert.True(seams > 100 && lit > 0.9 * seams, $"{seams} pixels of seams, {lit} lit");
    }

    /// <summary>
    /// A ray at a corner, at the middle of a side, or within a facet of the seams; from above, or those within from the camera.
    /// </summary>
    private static Ray Aimed(SeamPatch seams, View view, bool isAtEdge, Random random)
    {
        (Vector3D a, Vector3D b, Vector3D c) = seams.CornersOf(random.Next(seams.Count));
        double weight = 0.2 + (0.3 * random.NextDouble());
        Vector3D inside = (weight * a) + (0.3 * b) + ((0.7 - weight) * c);
        Vector3D target = isAtEdge ? CornerOrSide(a, b, c, random) : inside;
        Vector3D origin = 1.05 * target;
        return isAtEdge || random.Next(2) == 0 // past an edge of a crest, a ray from the side may go on to the ground behind
            ? new Ray(origin, target - origin)
            : new Ray(view.Camera.PositionBodyFixed, target - view.Camera.PositionBodyFixed);
    }

    /// <summary>A corner of a facet of the seams, or the middle of a side; now and then a pole.</summary>
    private static Vector3D TargetOf(SeamPatch seams, int number, Random random)
    {
        (Vector3D a, Vector3D b, Vector3D c) = seams.CornersOf(random.Next(seams.Count));
        Vector3D target = CornerOrSide(a, b, c, random);
        return number % 16 == 15 ? new Vector3D(0.0, 0.0, target.Z) : target;
    }

    private static Vector3D CornerOrSide(Vector3D a, Vector3D b, Vector3D c, Random random) =>
        (random.Next(4) switch { 0 => 2.0 * a, 1 => a + b, 2 => b + c, _ => c + a }) / 2.0;

    /// <summary>Over the border of the finest model and its middle, from near and far, with low Suns.</summary>
    private static List<View> ViewsOf(NestedTerrain terrain)
    {
        ITerrainGrid finest = terrain.Models[^1];
        GridWindow window = finest.Window;
        double scale = finest.Projection.Resolution.MetresPerPixel;
        Vector3D middle = finest.Projection.DirectionOf(
            0.5 * (window.FirstLine + window.EndLine), 0.5 * (window.FirstSample + window.EndSample));
        Vector3D border = finest.Projection.DirectionOf(window.FirstLine, 0.5 * (window.FirstSample + window.EndSample));
        Vector3D corner = finest.Projection.DirectionOf(window.EndLine - 1, window.EndSample - 1);
        RenderScenes.RenderSceneCase[] scenes =
        [
            SceneAt("border", border, 40.0 * scale, 0.0, 0.0, 60.0, 15.0, 100.0),
            SceneAt("middle", middle, 150.0 * scale, 10.0, 60.0, 90.0, 8.0, 200.0),
            SceneAt("corner", corner, 20.0 * scale, 50.0, 130.0, 60.0, 4.0, 20.0),
            SceneAt("far", middle, 3e5, 0.0, 0.0, 80.0, 5.0, 300.0),
            SceneAt("low", border, 3.0 * scale, 80.0, 300.0, 70.0, 6.0, 250.0),
            SceneAt("whole", border, 4e6, 0.0, 0.0, 40.0, 10.0, 300.0),
        ];
        return [.. scenes.Select(scene => new View(scene.Name, scene.Camera(terrain, Size, Size), scene.Sun))];
    }

    private static RenderScenes.RenderSceneCase SceneAt(
        string name, Vector3D place, double height, double tilt, double azimuth, double fov, double sunElevation, double sunAzimuth)
    {
        SelenographicPoint point = SelenographicPoint.Below(place);
        return new RenderScenes.RenderSceneCase(
            name, double.RadiansToDegrees(point.Latitude), double.RadiansToDegrees(point.Longitude), height, tilt, azimuth, fov,
            sunElevation, sunAzimuth);
    }

    private sealed record View(string Name, PinholeCamera Camera, Vector3D Sun);
}
