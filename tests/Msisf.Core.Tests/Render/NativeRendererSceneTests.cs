using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;
using Xunit.Abstractions;

namespace Msisf.Core.Tests.Render;

/// <summary>
/// Pixels of all scenes against the tracer, which looks at one ray at a time and is itself tested against every facet
/// (TerrainTracerSceneTests): the same facet, the same point, the same light.
/// </summary>
public sealed class NativeRendererSceneTests(ITestOutputHelper output)
{
    /// <summary>m: both compute the point from the same plane; far rays have some 1e9 m.</summary>
    private const double SamePoint = 1e-7;

    private static readonly NativeRenderOptions Options = new() { Reflectance = new LambertReflectance(0.64), KeepGroundTruth = true };

    /// <summary>
    /// Scenes that see all ground up to a horizon, or a whole pole: of a fine model that computes each sample too much for every day.
    /// </summary>
    private static readonly string[] WideScenes =
        ["north-pole", "north-pole-axis", "south-pole", "across-pole", "seam-oblique", "inside-crater", "one-metre", "along-parallel"];

    [RequiresFact(Part.Ldem4)]
    public void Render_RealModel_IsAsTraced() =>
        Compare(MemoryElevationGrid.Ldem4(), int.MaxValue, TestLength.Of(300, 10_000), RenderScenes.All);

    [Fact]
    public void Render_RuggedModel_IsAsTraced() =>
        Compare(FunctionGrid.Rugged(16), TestLength.Of(300, int.MaxValue), TestLength.Of(120, 10_000), RenderScenes.All);

    /// <param name="pixelsPerDegree">Of the model.</param>
    /// <param name="cellsAcross">Images that would hold more are narrowed.</param>
    /// <param name="cellsAcrossInLongForm">The same.</param>
    [Theory]
    [InlineData(64, 200, 2000)]
    [InlineData(512, 50, 1000)]
    public void Render_FineRuggedModel_IsAsTraced(int pixelsPerDegree, int cellsAcross, int cellsAcrossInLongForm) => Compare(
        FunctionGrid.Rugged(pixelsPerDegree),
        TestLength.Of(cellsAcross, cellsAcrossInLongForm),
        TestLength.Of(60, 10_000),
        [.. RenderScenes.All.Where(scene => TestLength.IsLong || !WideScenes.Contains(scene.Name))]);

    private void Compare(IGlobalGrid grid, int cellsAcross, int pixels, IReadOnlyList<RenderScenes.RenderSceneCase> scenes)
    {
        NativeRenderer renderer = new(grid);
        TerrainTracer tracer = new(grid);
        List<string> wrong = [];
        int hits = 0;
        int lit = 0;
        int side = TestLength.Of(128, 1024);
        foreach (RenderScenes.RenderSceneCase scene in scenes)
        {
            PinholeCamera camera = Narrowed(scene.Camera(grid, side, side), tracer, cellsAcross, grid.PixelsPerDegree);
            SceneLight sun = new(scene.Sun, IsSun: true);
            TracedFrameTruth traced = new(camera, sun, tracer);
            using NativeFrame drawn = renderer.Render(camera, sun, Options, threads: 2);
            Random random = new(20120222);
            for (int number = 0; number < pixels; number++)
            {
                (int x, int y) = (random.Next(1, side + 1), random.Next(1, side + 1));
                bool isSurface = traced.TryGet(x, y, out SurfaceHit expected, out PixelIllumination expectedLight);
                bool isDrawn = drawn.TryGet(x, y, out SurfaceHit hit, out PixelIllumination light);
                hits += isSurface ? 1 : 0;
                lit += expectedLight.State == IlluminationState.Lit ? 1 : 0;
                bool isSame = isDrawn == isSurface && hit.Facet == expected.Facet && light == expectedLight
                    && (hit.PointBodyFixed - expected.PointBodyFixed).Length <= SamePoint;
                if (!isSame)
                {
                    wrong.Add($"{scene.Name} ({x}, {y}): {hit} {light}; traced {expected} {expectedLight}");
                }
            }
        }

        int all = pixels * scenes.Count;
        output.WriteLine(
            $"{grid.ProductId}, {grid.PixelsPerDegree} px/deg: {all} pixels, {hits} of the surface, {lit} lit, {wrong.Count} differ");
        Assert.True(wrong.Count == 0, $"{wrong.Count} of {all}:{Environment.NewLine}{string.Join(Environment.NewLine, wrong.Take(10))}");
        Assert.InRange(hits, all / 2, all - 1);
        Assert.InRange(lit, hits / 5, 4 * hits / 5);
    }

    /// <summary>
    /// The camera with a field of view in which there are not too many cells beside each other where it looks, or at the limb.
    /// </summary>
    private static PinholeCamera Narrowed(PinholeCamera camera, TerrainTracer tracer, int cellsAcross, int pixelsPerDegree)
    {
        double cell = MoonConstants.ReferenceRadius * Math.PI / 180.0 / pixelsPerDegree;
        Ray axis = new(camera.PositionBodyFixed, camera.ForwardBodyFixed);
        double distance = tracer.TryTrace(axis, out SurfaceHit seen)
            ? seen.RayParameter
            : Math.Sqrt(
                Math.Max(0.0, camera.PositionBodyFixed.LengthSquared - (MoonConstants.ReferenceRadius * MoonConstants.ReferenceRadius)));
        double fieldOfView = Math.Min(camera.FieldOfView, 2.0 * Math.Atan(cellsAcross / 2.0 * cell / distance));
        return new PinholeCamera(camera.PositionBodyFixed, camera.MoonFromCamera, fieldOfView, camera.Width, camera.Height);
    }
}
