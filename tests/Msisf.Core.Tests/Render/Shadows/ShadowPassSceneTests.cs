using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Shadows;

/// <summary>Every pixel of whole images against single rays to the Sun.</summary>
public sealed class ShadowPassSceneTests
{
    [RequiresFact(Part.Ldem4)]
    public void Run_RealModel_IsWhatRaysSay() =>
        Compare(MemoryElevationGrid.Ldem4(), TestLength.Of(28, 64), [.. RenderScenes.All.Select(scene => scene.Name)]);

    [Fact]
    public void Run_RuggedModel_IsWhatRaysSay() =>
        Compare(FunctionGrid.Rugged(16), TestLength.Of(18, 24), [.. RenderScenes.All.Select(scene => scene.Name)]);

    /// <summary>Without scenes that see so much that the model's function takes minutes.</summary>
    [Theory]
    [InlineData(64, "nadir-100km", "north-pole-axis", "seam", "grazing-sun", "inside-crater", "one-metre")]
    [InlineData(512, "grazing-sun")]
    public void Run_FineModel_IsWhatRaysSay(int pixelsPerDegree, params string[] scenes) =>
        Compare(FunctionGrid.Rugged(pixelsPerDegree), 32, scenes);

    private static void Compare(IGlobalGrid grid, int size, string[] scenes)
    {
        TerrainTracer tracer = new(grid);
        SurfaceModel surface = new(grid);
        VisibilityPass visibility = new(surface);
        ShadowPass shadows = new(surface);
        byte[] hidden = new byte[size * size];
        double[] cosIncidence = new double[size * size];
        List<string> wrong = [];
        int lit = 0;
        int dark = 0;
        foreach (RenderScenes.RenderSceneCase scene in RenderScenes.All.Where(scene => scenes.Contains(scene.Name)))
        {
            PinholeCamera camera = scene.Camera(grid, size, size);
            VisibleSurface seen = visibility.Run(camera, 2, CancellationToken.None);
            shadows.Run(new SunwardPoints(seen, scene.Sun, cosIncidence), scene.Sun, hidden, 2, CancellationToken.None);
            for (int pixel = 0; pixel < size * size; pixel++)
            {
                if (!seen.TryGet((pixel % size) + 1, (pixel / size) + 1, out SurfaceHit hit) || cosIncidence[pixel] <= 0.0)
                {
                    Assert.Equal(0, hidden[pixel]);
                    continue;
                }

                bool isHidden = tracer.IsHidden(hit.PointBodyFixed, hit.Facet, scene.Sun);
                lit += isHidden ? 0 : 1;
                dark += isHidden ? 1 : 0;
                if (isHidden != (hidden[pixel] != 0))
                {
                    wrong.Add($"{scene.Name} pixel {pixel}: {hit}, hidden by ray {isHidden}");
                }
            }
        }

        Assert.True(wrong.Count == 0, $"{wrong.Count} pixels: {string.Join(Environment.NewLine, wrong.Take(10))}");
        Assert.True(lit > 50 * scenes.Length, $"lit: {lit}");
        Assert.True(dark > 10 * scenes.Length, $"dark: {dark}");
    }
}
