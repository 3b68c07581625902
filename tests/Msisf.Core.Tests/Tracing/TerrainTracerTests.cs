using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Tracing;

public sealed class TerrainTracerTests
{
    private const double Radius = 1_737_400.0;

    [Fact]
    public void TryTrace_RaysFromOutsideIntoTheMoon_NeverMiss()
    {
        TerrainTracer tracer = new(FunctionGrid.Rugged(4));
        Random random = new(20120222);
        int missed = 0;
        for (int number = 0; number < 100_000; number++)
        {
            Vector3D origin = Math.Pow(10.0, 6.25 + (3.0 * random.NextDouble())) * Direction(random);
            Vector3D inside = (1.72e6 * Math.Cbrt(random.NextDouble())) * Direction(random);
            missed += tracer.TryTrace(new Ray(origin, inside - origin), out SurfaceHit hit) && hit.RayParameter < 1.0 ? 0 : 1;
        }

        Assert.Equal(0, missed);
    }

    /// <summary>
    /// Straight at vertices, at middles of edges and into the corners beside the poles: where facets meet there is no gap. The slopes are
    /// gentle, so that each facet faces its ray.
    /// </summary>
    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    [InlineData(10)]
    public void TryTrace_RaysAtVerticesAndEdges_DoNotPass(int pixelsPerDegree)
    {
        double step = Math.PI / 180.0 / pixelsPerDegree;
        FunctionGrid grid = FunctionGrid.OfHeights(
            pixelsPerDegree, (line, sample) => 2000.0 * Math.Sin((line + 0.5) * step) * Math.Sin(5.0 * (sample + 0.5) * step));
        TerrainTracer tracer = new(grid);
        LatticeVertices vertices = new(grid);
        Random random = new(20120222);
        List<string> passed = [];
        for (int number = 0; number < 6000; number++)
        {
            int line = number % 10 == 0 ? random.Next(2) : number % 10 == 1 ? vertices.Lines - 2 : random.Next(-1, vertices.Lines);
            (Vector3D a, Vector3D b, Vector3D c) = vertices.CornersOf(
                new FacetId(line, random.Next(vertices.Samples), (FacetHalf)(number % 2)));
            Vector3D target = (number % 4) switch { 0 => a, 1 => 0.5 * (a + b), 2 => 0.5 * (b + c), _ => 0.5 * (c + a) };
            Vector3D origin = (Math.Pow(10.0, 6.3 + random.NextDouble()) * target.Normalized()) + (2e5 * Direction(random));
            if (number % 3 == 0)
            {
                // so that the ray meets the vertex exactly
                origin = new Vector3D(Math.Round(origin.X), Math.Round(origin.Y), Math.Round(origin.Z));
            }

            if (!(tracer.TryTrace(new Ray(origin, target - origin), out SurfaceHit hit) && hit.RayParameter <= 1.0 + 1e-13))
            {
                passed.Add($"{origin} {target}");
            }
        }

        Assert.Empty(passed);
    }

    [Theory]
    [InlineData(1, 0.0)]
    [InlineData(1, 1e-12)]
    [InlineData(1, 0.3)]
    [InlineData(1, 1e5)]
    [InlineData(64, 0.0)]
    [InlineData(64, 1e-3)]
    [InlineData(1024, 40.0)]
    [InlineData(1024, 1e6)]
    public void TryTrace_BallOfFacets_IsHitAtItsRadiusAlsoAtThePoles(int pixelsPerDegree, double fromAxis)
    {
        TerrainTracer tracer = new(FunctionGrid.OfHeights(pixelsPerDegree, (_, _) => 0.0));
        double sagitta = Radius * (1.0 - Math.Cos(0.71 * Math.PI / 180.0 / pixelsPerDegree));
        Random random = new(20120222);
        foreach (double z in (double[])[-1.0, 1.0])
        {
            double angle = random.NextDouble() * 2.0 * Math.PI;
            Vector3D up = new Vector3D(fromAxis * Math.Cos(angle), fromAxis * Math.Sin(angle), z * Radius).Normalized();
            Assert.True(tracer.TryTrace(new Ray(1.9e6 * up, -up), out SurfaceHit hit));
            Assert.InRange(hit.PointBodyFixed.Length, Radius - sagitta - 0.01, Radius + 0.01); // m: vertices are rounded to 2^-7 m
            Assert.InRange(hit.RayParameter, 1.9e6 - Radius - 0.01, 1.9e6 - Radius + sagitta + 0.01); // m: the same
            Assert.Equal(0.0, Vector3D.AngleBetween(hit.NormalBodyFixed, up), pixelsPerDegree == 1 ? 0.02 : 0.5);
        }
    }

    [Theory]
    [InlineData(0.0)]
    [InlineData(60.0)]
    [InlineData(-89.0)]
    [InlineData(89.99)]
    public void TryTrace_RayTangentToAParallel_MeetsTheGroundOnlyIfItDips(double latitudeDegrees)
    {
        TerrainTracer tracer = new(FunctionGrid.OfHeights(64, (_, _) => 0.0));
        for (double longitude = 0.0; longitude < 6.3; longitude += 0.7)
        {
            Vector3D up = new SelenographicPoint(latitudeDegrees * Math.PI / 180.0, longitude).ToDirectionBodyFixed();
            Vector3D east = new(-Math.Sin(longitude), Math.Cos(longitude), 0.0);
            Assert.False(tracer.TryTrace(new Ray(((Radius + 0.02) * up) - (1e6 * east), east), out _));
            Assert.True(tracer.TryTrace(new Ray(((Radius - 60.0) * up) - (1e6 * east), east), out _));
            Assert.True(tracer.TryTrace(new Ray(((Radius + 100.0) * up) - (0.5 * east), east - (0.02 * up)), out _));
        }
    }

    [Fact]
    public void TryTrace_RayThatLeavesTheGround_MeetsNothing()
    {
        FunctionGrid grid = FunctionGrid.OfHeights(4, (line, _) => 10.0 * (line % 2));
        TerrainTracer tracer = new(grid);
        Assert.True(tracer.TryTrace(new Ray(new Vector3D(1.8e6, 1000.0, 2000.0), -Vector3D.UnitX), out SurfaceHit ground));

        Assert.False(tracer.TryTrace(new Ray(ground.PointBodyFixed, ground.NormalBodyFixed), out _));
        Assert.False(tracer.TryFirstHit(new Ray(ground.PointBodyFixed, ground.PointBodyFixed), out Vector3D point));
        Assert.Equal(default, point);
    }

    /// <summary>
    /// A tower of 10 km on flat ground at 1 px/deg. From a place 3 degrees east of it on the equator its top is at the angle
    /// atan((r cos 3 - R) / (r sin 3)) = 4.7 degrees above the horizontal plane (r = 1747400, R = 1737400).
    /// </summary>
    [Theory]
    [InlineData(5.2, false)]
    [InlineData(4.2, true)]
    public void IsHidden_BehindATower_BelowItsTopOnly(double sunElevationDegrees, bool expected)
    {
        TerrainTracer tracer = new(FunctionGrid.OfHeights(1, (line, sample) => line == 89 && sample == 20 ? 10_000.0 : 0.0));
        Vector3D up = new SelenographicPoint(0.5 * Math.PI / 180.0, 23.5 * Math.PI / 180.0).ToDirectionBodyFixed();
        Assert.True(tracer.TryTrace(new Ray(1.8e6 * up, -up), out SurfaceHit ground));
        Vector3D west = new(Math.Sin(23.5 * Math.PI / 180.0), -Math.Cos(23.5 * Math.PI / 180.0), 0.0);
        double elevation = sunElevationDegrees * Math.PI / 180.0;
        Vector3D sun = 1.5e11 * ((Math.Sin(elevation) * up) + (Math.Cos(elevation) * west));

        Assert.Equal(expected, tracer.IsHidden(ground.PointBodyFixed, ground.Facet, sun));
    }

    [Fact]
    public void IsHidden_LightBelowTheFacet_IsTrue()
    {
        TerrainTracer tracer = new(FunctionGrid.OfHeights(4, (_, _) => 0.0));
        Assert.True(tracer.TryTrace(new Ray(new Vector3D(1.8e6, 1000.0, 2000.0), -Vector3D.UnitX), out SurfaceHit ground));

        Assert.True(tracer.IsHidden(ground.PointBodyFixed, ground.Facet, -1e9 * ground.NormalBodyFixed));
        Assert.False(tracer.IsHidden(ground.PointBodyFixed, ground.Facet, 1e9 * ground.NormalBodyFixed));
    }

    [Fact]
    public void TryTrace_FineModel_ReadsOnlyWhatIsNear()
    {
        int farAway = 0;
        FunctionGrid grid = new(256, (line, sample) =>
        {
            bool isNear = Math.Abs(line - (90 * 256)) < 3 * 256 && Math.Abs(sample - (40 * 256)) < 3 * 256;
            farAway += isNear || line == 0 || line == (180 * 256) - 1 ? 0 : 1;
            return Radius;
        });
        TerrainTracer tracer = new(grid);
        Vector3D up = new SelenographicPoint(0.0, 40.0 * Math.PI / 180.0).ToDirectionBodyFixed();

        Assert.True(tracer.TryTrace(new Ray(1.85e6 * up, -up), out _));
        Assert.Equal(0, farAway);
    }

    [Fact]
    public void TryTrace_ManyThreads_SameHits()
    {
        FunctionGrid grid = FunctionGrid.Rugged(4);
        TerrainTracer shared = new(grid);
        TerrainTracer alone = new(grid);
        Vector3D[] directions = Directions(2000);
        SurfaceHit[] hits = new SurfaceHit[directions.Length];
        System.Threading.Tasks.Parallel.For(
            0, hits.Length, i => shared.TryTrace(new Ray(3e6 * directions[i], -directions[i]), out hits[i]));

        Assert.All(Enumerable.Range(0, hits.Length), i =>
        {
            alone.TryTrace(new Ray(3e6 * directions[i], -directions[i]), out SurfaceHit hit);
            Assert.Equal(hit, hits[i]);
        });
    }

    [Fact]
    public void TryTrace_RadiusThatIsNoneOfTheMoon_IsSaid()
    {
        TerrainTracer tracer = new(FunctionGrid.OfHeights(1, (line, sample) => line == 89 && sample == 20 ? 30_000.0 : 0.0));
        BadInputException error = Assert.Throws<BadInputException>(
            () => tracer.TryTrace(new Ray(new Vector3D(3e6, 1e6, 0.0), new Vector3D(-1.0, -1.0 / 3.0, 0.0)), out _));

        Assert.Contains("TEST_GRID has radii from 1737400 to 1767400 m", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void TryTrace_RayThatIsNone_IsRefused()
    {
        TerrainTracer tracer = new(FunctionGrid.OfHeights(1, (_, _) => 0.0));

        Assert.Throws<ArgumentException>(() => tracer.TryTrace(new Ray(new Vector3D(3e6, 0.0, 0.0), default), out _));
        Assert.Throws<ArgumentException>(() => tracer.TryTrace(new Ray(new Vector3D(3e6, double.NaN, 0.0), Vector3D.UnitX), out _));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => tracer.IsHidden(new Vector3D(Radius, 0.0, 0.0), new FacetId(180, 0, FacetHalf.NorthEast), new Vector3D(1e9, 0.0, 0.0)));
    }

    private static Vector3D[] Directions(int count)
    {
        Random random = new(20120222);
        return [.. Enumerable.Range(0, count).Select(_ => Direction(random))];
    }

    private static Vector3D Direction(Random random)
    {
        double z = (2.0 * random.NextDouble()) - 1.0;
        double longitude = 2.0 * Math.PI * random.NextDouble();
        double across = Math.Sqrt((1.0 - z) * (1.0 + z));
        return new Vector3D(across * Math.Cos(longitude), across * Math.Sin(longitude), z);
    }
}
