using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Shadows;

/// <summary>Pieces of any size and shape whose light is sure, point by point against rays to the Sun.</summary>
public sealed class SureLightTests(RuggedTerrain rugged) : IClassFixture<RuggedTerrain>
{
    private static readonly double[] Elevations = [-12.0, -6.0, -1.0, 0.2, 1.0, 3.0, 8.0, 20.0, 50.0];

    [Theory]
    [InlineData(90.0, 0.0, false)]
    [InlineData(-43.0, 349.0, false)]
    [InlineData(5.0, 0.0, false)]
    [InlineData(90.0, 0.0, true)]
    [InlineData(-43.0, 349.0, true)]
    public void Of_PieceOfAFacet_IsWhatRaysToTheSunSay(double latitude, double longitude, bool hasDisc)
    {
        Random random = new(20120222);
        TerrainTracer tracer = new(rugged.Grid);
        SurfaceModel surface = new(rugged.Grid);
        Vector3D middle = SurfacePoints.Direction(latitude, longitude);
        VisibilityPass visibility = new(surface);
        FrameCamera camera = new PinholeCamera(
            2.2e6 * middle, CameraCases.Attitude(-middle, SurfacePoints.Sun(middle, 0.0, 0.0).Normalized()), 1.5, 100, 100);
        visibility.Prepare(camera, 2, CancellationToken.None);
        ShadowPass shadows = new(surface);
        Dictionary<PieceLight, int> counts = [];
        foreach (double elevation in Elevations)
        {
            Vector3D sun = SurfacePoints.Sun(middle, elevation, 360.0 * random.NextDouble());
            SunDisc disc = new(sun);
            Vector3D[] sources = hasDisc ? disc.PointsBodyFixed.ToArray() : [sun];
            SureLight light = shadows.FindCasters(
                visibility.Blocks.Select(block => block.Block), sun, hasDisc ? disc.Slope : 0.0, threads: 2, CancellationToken.None);
            foreach (Vector3D direction in SurfacePoints.Around(middle, 10.0, TestLength.Of(300, 30_000), random))
            {
                Assert.True(tracer.TryTrace(new Ray(4e6 * direction, -direction), out SurfaceHit hit));
                if (Vector3D.Dot(hit.NormalBodyFixed, (sun - hit.PointBodyFixed).Normalized())
                    <= Math.Max(SurfacePoints.MinCosine, light.LeastCosine))
                {
                    continue;
                }

                double size = Math.Pow(10.0, 1.0 + (3.0 * random.NextDouble()));
                Vector3D[] corners = [.. Enumerable.Range(0, 4).Select(_ => hit.PointBodyFixed + InPlane(hit.NormalBodyFixed, size))];
                PieceLight found = light.Of(
                    Vector256.Create([.. corners.Select(corner => corner.X)]), Vector256.Create([.. corners.Select(corner => corner.Y)]),
                    Vector256.Create([.. corners.Select(corner => corner.Z)]));
                counts[found] = counts.GetValueOrDefault(found) + 1;
                for (int point = 0; point < 5 && found != PieceLight.Unsure; point++)
                {
                    double[] weights = [.. corners.Select(_ => random.NextDouble())];
                    Vector3D inside = corners.Zip(weights, (corner, weight) => (weight / weights.Sum()) * corner)
                        .Aggregate((a, b) => a + b);
                    Vector3D up = inside.Normalized();
                    if (tracer.TryTrace(new Ray(4e6 * up, -up), out SurfaceHit own) && own.Facet == hit.Facet)
                    {
                        Vector3D source = sources[random.Next(sources.Length)];
                        Assert.Equal(found == PieceLight.Dark, tracer.IsHidden(own.PointBodyFixed, own.Facet, source));
                    }
                }
            }
        }

        // All that may be dark to a part of the disc is left unsure.
        Assert.All(
            hasDisc ? [PieceLight.Unsure, PieceLight.Lit] : Enum.GetValues<PieceLight>(),
            kind => Assert.True(counts.GetValueOrDefault(kind) > 20, $"{kind} is rare"));

        Vector3D InPlane(Vector3D normal, double size)
        {
            Vector3D any = size * new Vector3D(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5);
            return any - (Vector3D.Dot(any, normal) * normal);
        }
    }
}
