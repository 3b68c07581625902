using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Tracing;

/// <summary>Pixels of all scenes against every facet near their rays.</summary>
public sealed class TerrainTracerSceneTests
{
    /// <summary>m: LOLA's LDEM_4 keeps within -8.9 and +10.6 km (its label).</summary>
    private const double Ldem4Relief = 11_000.0;

    [RequiresFact(Part.Ldem4)]
    public void Trace_RealModel_IsAsBruteForce() => Compare(MemoryElevationGrid.Ldem4(), Ldem4Relief, TestLength.Of(40, 150));

    [Theory]
    [InlineData(16, 24, 60)]
    [InlineData(64, 5, 20)]
    [InlineData(512, 1, 2)]
    public void Trace_RuggedModel_IsAsBruteForce(int pixelsPerDegree, int pixels, int pixelsInLongForm) =>
        Compare(FunctionGrid.Rugged(pixelsPerDegree), FunctionGrid.RuggedRelief, TestLength.Of(pixels, pixelsInLongForm));

    private static void Compare(IGlobalGrid grid, double relief, int pixels)
    {
        TerrainTracer tracer = new(grid);
        FacetsNearRay facets = new(grid, relief);
        List<string> wrong = [];
        int lit = 0;
        int hits = 0;
        foreach (RenderScenes.RenderSceneCase scene in RenderScenes.All)
        {
            PinholeCamera camera = scene.Camera(grid, 1024, 1024);
            Random random = new(20120222);
            for (int number = 0; number < pixels; number++)
            {
                (int x, int y) = (random.Next(1, 1025), random.Next(1, 1025));
                Ray ray = camera.RayThrough(x, y);
                bool isHit = tracer.TryTrace(ray, out SurfaceHit hit);
                bool isHidden = isHit && tracer.IsHidden(hit.PointBodyFixed, hit.Facet, scene.Sun);
                string? difference = DifferenceOf(facets, ray, isHit, hit, isHidden, scene.Sun);
                if (difference is not null)
                {
                    wrong.Add($"{scene.Name} ({x}, {y}): {difference}");
                }

                hits += isHit ? 1 : 0;
                lit += isHit && !isHidden ? 1 : 0;
            }
        }

        Assert.True(wrong.Count == 0, string.Join(Environment.NewLine, wrong.Take(10)));
        int all = pixels * RenderScenes.All.Count;
        Assert.InRange(hits, all / 2, all - 1);
        Assert.InRange(lit, hits / 5, 4 * hits / 5);
    }

    private static string? DifferenceOf(FacetsNearRay facets, Ray ray, bool isHit, SurfaceHit hit, bool isHidden, Vector3D sun)
    {
        if (facets.FirstHit(ray.Origin, ray.Direction) is not (FacetId facet, Vector3D point, _))
        {
            return isHit ? $"hits {hit.Facet}, nothing by brute force" : null;
        }

        if (!isHit)
        {
            return $"no hit, {facet} by brute force";
        }

        double distance = (hit.PointBodyFixed - point).Length;
        if (!(distance <= 1e-7))
        {
            return $"hits {hit.Facet}, {facet} by brute force, {distance} m apart";
        }

        bool isShadowed = facets.IsShadowed(hit.Facet, hit.PointBodyFixed, sun);
        return isShadowed == isHidden ? null : $"hidden: {isHidden}, by brute force {isShadowed}";
    }
}
