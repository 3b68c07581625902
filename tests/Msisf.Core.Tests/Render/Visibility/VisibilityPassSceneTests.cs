using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Visibility;

/// <summary>Every pixel of whole images against single rays.</summary>
public sealed class VisibilityPassSceneTests
{
    /// <summary>m: what rounding may part two computations of a hit by.</summary>
    private const double HitTolerance = 1e-7;

    /// <summary>m: the same, across the facet: a ray that all but grazes it carries 4 ulps of a position far along.</summary>
    private const double AcrossTolerance = 1e-9;

    [RequiresFact(Part.Ldem4)]
    public void Run_RealModel_ShowsWhatRaysMeet() => Compare(MemoryElevationGrid.Ldem4(), TestLength.Of(36, 100), [.. RenderScenes.Names]);

    [Fact]
    public void Run_RuggedModel_ShowsWhatRaysMeet() => Compare(FunctionGrid.Rugged(16), TestLength.Of(24, 40), [.. RenderScenes.Names]);

    /// <summary>Scenes that see little: the model is a function.</summary>
    [Fact]
    public void Run_FineModel_ShowsWhatRaysMeet() =>
        Compare(
            FunctionGrid.Rugged(64),
            32,
            ["nadir-100km", "north-pole-axis", "seam", "limb-backlit", "grazing-sun", "inside-crater", "one-metre"]);

    [Theory]
    [InlineData("seam")]
    [InlineData("grazing-sun")]
    public void Run_FinestModel_ShowsWhatBruteForceFinds(string name)
    {
        const int Size = 10;
        FunctionGrid grid = FunctionGrid.Rugged(512);
        PinholeCamera camera = RenderScenes.Named(name).Camera(grid, Size, Size);
        FacetsNearRay facets = new(grid, FunctionGrid.RuggedRelief);
        VisibleSurface seen = new VisibilityPass(new SurfaceModel(grid)).Run(camera, 2, CancellationToken.None);
        for (int pixel = 0; pixel < Size * Size; pixel++)
        {
            (int x, int y) = ((pixel % Size) + 1, (pixel / Size) + 1);
            Ray ray = camera.RayThrough(x, y);
            Assert.True(seen.TryGet(x, y, out SurfaceHit hit));
            (FacetId facet, Vector3D point, _) = facets.FirstHit(ray.Origin, ray.Direction)!.Value;
            Assert.Equal(facet, hit.Facet);
            Assert.True((point - hit.PointBodyFixed).Length <= HitTolerance);
        }
    }

    private static void Compare(IGlobalGrid grid, int size, string[] scenes)
    {
        TerrainTracer tracer = new(grid);
        VisibilityPass pass = new(new SurfaceModel(grid));
        List<string> wrong = [];
        int surface = 0;
        foreach (RenderScenes.RenderSceneCase scene in scenes.Select(RenderScenes.Named))
        {
            PinholeCamera camera = scene.Camera(grid, size, size);
            VisibleSurface seen = pass.Run(camera, 2, CancellationToken.None);
            for (int y = 1; y <= size; y++)
            {
                for (int x = 1; x <= size; x++)
                {
                    Ray ray = camera.RayThrough(x, y);
                    bool isSeen = seen.TryGet(x, y, out SurfaceHit hit);
                    bool isHit = tracer.TryTrace(ray, out SurfaceHit expected);
                    surface += isSeen ? 1 : 0;
                    if (isSeen != isHit || (isHit && !IsSame(hit, expected, ray.Direction)))
                    {
                        wrong.Add($"{scene.Name} ({x}, {y}): seen {hit}, traced {expected}");
                    }
                }
            }
        }

        Assert.True(wrong.Count == 0, $"{wrong.Count} pixels: {string.Join(Environment.NewLine, wrong.Take(10))}");
        Assert.InRange(surface, scenes.Length * size * size / 2, scenes.Length * size * size);
    }

    private static bool IsSame(SurfaceHit hit, SurfaceHit expected, Vector3D direction)
    {
        Vector3D apart = hit.PointBodyFixed - expected.PointBodyFixed;
        double sine = Math.Abs(Vector3D.Dot(expected.NormalBodyFixed, direction)) / direction.Length;
        return hit.Facet == expected.Facet
            && (hit.NormalBodyFixed - expected.NormalBodyFixed).Length < Rounding.OfTurns
            && (apart.Length <= HitTolerance || apart.Length * sine <= AcrossTolerance);
    }
}
