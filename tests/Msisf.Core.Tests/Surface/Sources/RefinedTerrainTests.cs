using System.Collections.Concurrent;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
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

namespace Msisf.Core.Tests.Surface.Sources;

public sealed class RefinedTerrainTests
{
    private const int Size = 48;
    private const int FinestLevel = 4;

    private static readonly NativeRenderOptions Options = new() { Reflectance = new LambertReflectance(0.64), KeepGroundTruth = true };

    private static readonly ConcurrentDictionary<string, Lazy<Scene>> Made = new(StringComparer.Ordinal);

    /// <summary>On four of the six maps, where three maps meet, at a pole, and inside several models.</summary>
    private static readonly RenderScenes.RenderSceneCase[] Cases =
    [
        new("oblique", 3.0, 4.0, 20e3, 70.0, 30.0, 50.0, 8.0, 290.0),
        new("nadir", -20.0, 95.0, 60e3, 0.0, 0.0, 40.0, 5.0, 90.0),
        new("corner-of-maps", 35.26, 225.0, 9e3, 60.0, 200.0, 60.0, 12.0, 100.0),
        new("south-pole", -89.9, 30.0, 12e3, 50.0, 100.0, 60.0, 15.0, 20.0),
        new("several", -89.5, 30.0, 600.0, 65.0, 300.0, 60.0, 20.0, 60.0),
    ];

    public static TheoryData<string> Names => [.. Cases.Select(scene => scene.Name)];

    /// <summary>Scenes of which every facet is looked at, which takes some seconds each: the hardest ones, or all.</summary>
    public static TheoryData<string> NamesOfSome => [.. Cases.Select(scene => scene.Name).TakeLast(TestLength.Of(1, 5))];

    [Theory]
    [MemberData(nameof(NamesOfSome))]
    public void Surface_AllFacets_AreOneClosedSurfaceThatFacesOutwards(string name)
    {
        AllFacets all = SceneOf(name).Facets.Value;
        Assert.DoesNotContain(all.Facets, facet => !(Vector3D.Dot(facet.A, Vector3D.Cross(facet.B, facet.C)) > 0.0));
        Assert.Null(all.FindFlaw());
    }

    [Theory]
    [MemberData(nameof(NamesOfSome))]
    public void Trace_AnyPixel_IsAsBruteForce(string name)
    {
        Scene scene = SceneOf(name);
        TerrainTracer tracer = new(scene.View);
        Random random = new(20120222);
        int hits = 0;
        int lit = 0;
        for (int number = 0; number < TestLength.Of(8, 400); number++)
        {
            Ray ray = scene.Camera.RayThrough(random.Next(1, Size + 1), random.Next(1, Size + 1));
            bool isHit = tracer.TryTrace(ray, out SurfaceHit hit);
            (FacetId Facet, Vector3D Point, double T)? expected = scene.Facets.Value.FirstHit(ray.Origin, ray.Direction);
            Assert.Equal(expected is not null, isHit);
            if (isHit)
            {
                // m: two ways to meet a facet, which may be grazed
                Assert.InRange((expected!.Value.Point - hit.PointBodyFixed).Length, 0.0, 1e-6);
                bool isLit = Vector3D.Dot(hit.NormalBodyFixed, scene.Sun - hit.PointBodyFixed) > 0.0
                    && !scene.Facets.Value.IsShadowed(hit.Facet, hit.PointBodyFixed, scene.Sun);
                Assert.Equal(isLit, !tracer.IsHidden(hit.PointBodyFixed, hit.Facet, scene.Sun));
                hits++;
                lit += isLit ? 1 : 0;
            }
        }

        Assert.True(hits > 4 && lit > 0, $"{hits} hits, {lit} lit");
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Render_AnyPixel_IsAsTraced(string name)
    {
        Scene scene = SceneOf(name);
        SceneLight sun = new(scene.Sun, IsSun: true);
        TracedFrameTruth traced = new(scene.Camera, sun, new TerrainTracer(scene.View));
        using NativeFrame drawn = new NativeRenderer(scene.View).Render(scene.Camera, sun, Options, threads: 2);
        HashSet<int> parts = [];
        List<string> wrong = [];
        for (int pixel = 0; pixel < Size * Size; pixel += TestLength.Of(3, 1))
        {
            (int x, int y) = ((pixel % Size) + 1, (pixel / Size) + 1);
            bool isSurface = traced.TryGet(x, y, out SurfaceHit expected, out PixelIllumination expectedLight);
            bool isDrawn = drawn.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light);
            parts.Add(hit.Facet.Part);
            if (isDrawn != isSurface || hit.Facet != expected.Facet || light != expectedLight)
            {
                wrong.Add($"({x}, {y}): {hit} {light}; traced {expected} {expectedLight}");
            }
        }

        Assert.True(wrong.Count == 0, $"{wrong.Count}:{Environment.NewLine}{string.Join(Environment.NewLine, wrong.Take(10))}");
        Assert.True(parts.Any(part => part >= scene.View.PartCount - scene.View.Places.Count), "Windows or seams are seen.");
    }

    [Fact]
    public void Render_OtherThreadsAndFramesBefore_GivesTheSameImage()
    {
        Scene scene = SceneOf("oblique");
        SceneLight sun = new(scene.Sun, IsSun: true);
        using NativeFrame one = new NativeRenderer(scene.View).Render(scene.Camera, sun, Options, threads: 1);
        RefinedTerrain other = TerrainOf("oblique");
        RendererMemory memory = new();
        foreach (double height in new[] { 60e3, 25e3, 19e3 })
        {
            PinholeCamera before = (Cases[0] with { Height = height }).Camera(other, Size, Size);
            using NativeFrame frame = new NativeRenderer(other.For(before, 1), memory).Render(before, sun, Options, threads: 3);
        }

        using NativeFrame again = new NativeRenderer(other.For(scene.Camera, 1), memory).Render(
            scene.Camera, sun, Options, threads: 4);
        Assert.True(one.RadianceFactors.SequenceEqual(again.RadianceFactors));
    }

    /// <summary>A camera that moves a little sees the same vertices wherever its windows of a level overlap those from before.</summary>
    [Fact]
    public void Surface_WindowsOfTwoCameras_HaveTheSameVertices()
    {
        RefinedTerrain terrain = TerrainOf("oblique");
        RefinedView one = terrain.For(Cases[0].Camera(terrain, Size, Size), 1);
        RefinedView other = terrain.For((Cases[0] with { Latitude = 3.1, Height = 15e3 }).Camera(terrain, Size, Size), 1);
        int compared = 0;
        for (int i = 1; i < one.Places.Count; i++) // the coarsest one's border is blended
        {
            int j = other.Places.ToList().FindIndex(1, place => place.Level == one.Places[i].Level);
            CellRange a = one.Places[i].Cells;
            if (j < 0 || a == other.Places[j].Cells)
            {
                continue;
            }

            CellRange b = other.Places[j].Cells;
            for (int line = Math.Max(a.FirstLine, b.FirstLine); line <= Math.Min(a.EndLine, b.EndLine); line += 7)
            {
                for (int sample = Math.Max(a.FirstSample, b.FirstSample); sample <= Math.Min(a.EndSample, b.EndSample); sample += 7)
                {
                    Assert.Equal(VertexAt(one, i, line, sample), VertexAt(other, j, line, sample));
                    compared++;
                }
            }
        }

        Assert.True(compared > 500, $"{compared} vertices");

        static Vector3D VertexAt(RefinedView view, int window, int line, int sample)
        {
            GridPatch surface = view.Surface.Parts[view.PartCount - view.Places.Count + window];
            double[] radius = new double[1];
            CellRange cells = view.Places[window].Cells;
            surface.Mesh.ReadRadii(line - cells.FirstLine, sample - cells.FirstSample, radius);
            return surface.Vertex(line - cells.FirstLine, sample - cells.FirstSample, radius[0]);
        }
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void For_AnyCamera_HasWindowsInsideEachOther(string name)
    {
        IReadOnlyList<WindowPlace> places = SceneOf(name).View.Places;
        Assert.True(places.Count > 3);
        double pixel = SceneOf(name).Camera.PixelTangent * Cases.Single(scene => scene.Name == name).Height; // no ground is nearer
        Assert.InRange(places[^1].Level, FinestLevel, Math.Max(FinestLevel, Math.Log2(2.0 * pixel)));
        for (int i = 1; i < places.Count; i++)
        {
            (CellRange outer, CellRange inner) = (places[i - 1].Cells, places[i].Cells);
            Assert.Equal(places[i - 1].Level - 1, places[i].Level);
            Assert.True(inner.FirstLine / 2 > outer.FirstLine + 1 && inner.EndLine / 2 < outer.EndLine - 1);
            Assert.True(inner.FirstSample / 2 > outer.FirstSample + 1 && inner.EndSample / 2 < outer.EndSample - 1);
            Assert.InRange(inner.Lines, 64, 1408); // up to 1,280 to hold a finer map, and some to whole blocks
            Assert.InRange(inner.Samples, 64, 1408);
        }
    }

    /// <summary>
    /// A map finer than a window wins: the widest window that may lie over it, with cells of 2^8 m for the map's of 600 m, holds all of
    /// it, and wider ones lie around that one.
    /// </summary>
    [Fact]
    public void For_CameraOverAFinerMap_HasNoWindowOfWiderCellsThere()
    {
        RefinedView view = SceneOf("several").View;
        Assert.Contains(view.Places, place => place.Level > 8);
        WindowPlace holding = view.Places.Single(place => place.Level == 8);
        ITerrainGrid map = TerrainOf("several").Models[1];
        foreach ((int line, int sample) in new[] { (0, 0), (0, map.Samples - 1), (map.Lines - 1, 0), (map.Lines - 1, map.Samples - 1) })
        {
            (double down, double right) = holding.Face.Map(8).PixelOf(map.Projection.DirectionOf(line, sample));
            Assert.InRange(down, holding.Cells.FirstLine + 2, holding.Cells.EndLine - 2);
            Assert.InRange(right, holding.Cells.FirstSample + 2, holding.Cells.EndSample - 2);
        }

        Assert.True(view.Surface.Parts[0].Kept!.IsAny);
    }

    [Fact]
    public void For_CameraFarAway_ShowsTheModelItself()
    {
        RefinedTerrain terrain = TerrainOf("oblique");
        PinholeCamera camera = (Cases[0] with { Height = 4e8, Tilt = 0.0 }).Camera(terrain, Size, Size);
        RefinedView view = terrain.For(camera, 1);
        Assert.Empty(view.Places);
        Assert.Equal(1, view.PartCount);
        Assert.Equal(0, view.Surface.Seams.Count);
    }

    [Fact]
    public void For_SameCameraAgain_IsTheSameView()
    {
        RefinedTerrain terrain = TerrainOf("oblique");
        PinholeCamera camera = Cases[0].Camera(terrain, Size, Size);
        Assert.Same(terrain.For(camera, 1), terrain.For(camera, 1));
    }

    [Fact]
    public void Constructor_MapOfAPart_SaysWhatToAdd()
    {
        PolarFunctionGrid map = PolarFunctionGrid.Rugged(true, 5000.0, 70, 34.5, 34.5);
        BadInputException refused = Assert.Throws<BadInputException>(() => new RefinedTerrain(map, new WavyDetail(), 0));
        Assert.Contains("a map of a part of the Moon", refused.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Constructor_CellsBelowTheLattice_AreRefused() => Assert.Throws<ArgumentOutOfRangeException>(
        () => new RefinedTerrain(FunctionGrid.Rugged(1), new WavyDetail(), RefinedTerrain.LeastLevel - 1));

    [Fact]
    public void RadiusBelow_AnyDirection_IsThatOfTheGroundWithItsDetail()
    {
        RefinedTerrain terrain = TerrainOf("oblique");
        Vector3D direction = new Vector3D(0.3, -0.5, 0.4).Normalized();
        Assert.Equal(
            new WavyDetail().RadiusAt(direction, Math.ScaleB(1.0, FinestLevel)), TerrainHeight.RadiusBelow(terrain, 2e6 * direction), 1e-6);
    }

    private static RefinedTerrain TerrainOf(string name) => new(
        name == "several"
            ? new NestedTerrain([FunctionGrid.Rugged(1), PolarFunctionGrid.Rugged(true, 600.0, 500, 249.5, 249.5)])
            : FunctionGrid.Rugged(1),
        new WavyDetail(), FinestLevel);

    private static Scene SceneOf(string name) => Made.GetOrAdd(name, static made => new Lazy<Scene>(() =>
    {
        RefinedTerrain terrain = TerrainOf(made);
        RenderScenes.RenderSceneCase scene = Cases.Single(known => known.Name == made);
        PinholeCamera camera = scene.Camera(terrain, Size, Size);
        RefinedView view = terrain.For(camera, 1);
        return new Scene(view, camera, scene.Sun, new Lazy<AllFacets>(() => new AllFacets(view)));
    })).Value;

    private sealed record Scene(RefinedView View, PinholeCamera Camera, Vector3D Sun, Lazy<AllFacets> Facets);
}
