using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Indirect;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Indirect;

/// <summary>Rays through boxes of sixteen and facets of eight, against the exact tracer, which shares neither.</summary>
public sealed class GroundTreeTests
{
    /// <summary>Models of the whole Moon, maps, and several with seams and gaps.</summary>
    [Theory]
    [InlineData("moon", -30.0, 75.0)]
    [InlineData("moon", 89.9, 0.0)]
    [InlineData("map", -89.99, 10.0)]
    [InlineData("five", -89.9, 0.0)]
    [InlineData("gaps", -88.0, 40.0)]
    public void FirstGround_RaysFromTheGround_IsAsTheTracer(string name, double latitude, double longitude)
    {
        ITerrain terrain = name switch
        {
            "moon" => FunctionGrid.Rugged(4),
            "map" => PolarFunctionGrid.Rugged(true, 20.0, 200, 99.5, 99.5),
            _ => NestedScenes.Named(name),
        };
        (double sine, double cosine) = Math.SinCos(double.DegreesToRadians(latitude));
        (double east, double along) = Math.SinCos(double.DegreesToRadians(longitude));
        Vector3D up = new(cosine * along, cosine * east, sine);
        TerrainTracer tracer = new(terrain);
        GroundTree tree = new(SurfaceModel.Of(terrain), up);
        Random random = new(20120222);
        int hits = 0;
        int rays = TestLength.Of(1500, 30_000);
        for (int ray = 0; ray < rays; ray++)
        {
            Vector3D place = (up + (1e-3 * Any(random))).Normalized();
            Vector3D above = 1_780_000.0 * place;
            if (!tracer.TryTrace(new Ray(above, -place), out SurfaceHit start))
            {
                continue;
            }

            Vector3D direction = (Any(random) + (0.3 * start.NormalBodyFixed)).Normalized();
            direction -= Math.Min(0.0, 1.05 * Vector3D.Dot(direction, start.NormalBodyFixed)) * start.NormalBodyFixed; // out of the ground
            direction = direction.Normalized();
            bool isHit = tracer.TryTrace(new Ray(start.PointBodyFixed, direction), out SurfaceHit expected);
            (double Distance, Vector3D Normal)? found = tree.FirstGround(start.PointBodyFixed, direction, 1e7);

            Assert.True(isHit == (found is not null), $"{name} {ray}: {(isHit ? expected : null)}, {found}");
            hits += isHit ? 1 : 0;
            Assert.Equal(isHit, tree.IsBlocked(start.PointBodyFixed, direction, 1e7));
            if (found is { } ground)
            {
                Assert.Equal(expected.RayParameter, ground.Distance, 1e-7);
                Assert.True((expected.NormalBodyFixed - ground.Normal).Length < Rounding.OfPlaces);
                Assert.False(tree.IsBlocked(start.PointBodyFixed, direction, ground.Distance - 1e-3));
            }
        }

        Assert.InRange(hits, rays / 50, rays);
    }

    /// <summary>Ways that are followed together, of which some are left out, end where single ones do.</summary>
    [Theory]
    [InlineData(-30.0, 75.0)]
    [InlineData(89.9, 0.0)]
    public void Reach_WaysOfAGroup_IsAsEachAlone(double latitude, double longitude)
    {
        ITerrain terrain = FunctionGrid.Rugged(4);
        (double sine, double cosine) = Math.SinCos(double.DegreesToRadians(latitude));
        (double east, double along) = Math.SinCos(double.DegreesToRadians(longitude));
        Vector3D up = new(cosine * along, cosine * east, sine);
        GroundTree tree = new(SurfaceModel.Of(terrain), up);
        Random random = new(31);
        Receivers group = new();
        GroundFan fan = new();
        (int open, int closed) = (0, 0);
        for (int round = 0; round < TestLength.Of(300, 3000); round++)
        {
            group.Clear();
            double width = Math.Pow(10.0, -2.0 - (1.5 * random.NextDouble())); // rad
            int count = random.Next(1, Receivers.Size + 1);
            while (group.Count < count)
            {
                (Vector3D point, Vector3D normal) = Ground(tree, up + (width * Any(random)));
                group.Add(point, normal, normal, normal, 0.0, group.Count);
            }

            tree.Start(fan, group);
            Vector3D end = Ground(tree, up + (width * Any(random))).Point;
            ulong asked = (ulong)random.NextInt64(long.MinValue, long.MaxValue) & (ulong.MaxValue >> (Receivers.Size - count));
            ulong reached = tree.Reach(fan, end, asked, count);

            Assert.Equal(0UL, reached & ~asked);
            for (int i = 0; i < count; i++)
            {
                Vector3D way = end - group.Points[i];
                if (((asked >> i) & 1) != 0 && Vector3D.Dot(way, group.Facets[i]) > 0.0)
                {
                    bool isOpen = ((reached >> i) & 1) != 0;
                    Assert.Equal(!tree.IsBlocked(group.Points[i], way.Normalized(), way.Length - GroundTree.Gap), isOpen);
                    (open, closed) = isOpen ? (open + 1, closed) : (open, closed + 1);
                }
            }
        }

        Assert.InRange(open, 30, int.MaxValue);
        Assert.InRange(closed, 30, int.MaxValue);
    }

    private static (Vector3D Point, Vector3D Normal) Ground(GroundTree tree, Vector3D towards)
    {
        Vector3D from = 1_780_000.0 * towards.Normalized();
        (double distance, Vector3D normal) = tree.FirstGround(from, -towards.Normalized(), 1e6)!.Value;
        return (from - (distance * towards.Normalized()), normal);
    }

    private static Vector3D Any(Random random) =>
        new((2.0 * random.NextDouble()) - 1.0, (2.0 * random.NextDouble()) - 1.0, (2.0 * random.NextDouble()) - 1.0);
}
