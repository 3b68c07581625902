using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Shadows;

/// <summary>Random points of the surface against every facet of the Moon, at Suns from below the horizon to high up.</summary>
public sealed class ShadowPassTests(Ldem4Fixture ldem4) : IClassFixture<Ldem4Fixture>
{
    /// <summary>Where the real Moon hides a little, this one hides much.</summary>
    private static readonly FunctionGrid Rough = FunctionGrid.Rough(2);

    [RequiresTheory(Part.Ldem4)]
    [InlineData(90.0, 0.0, 3.0)]
    [InlineData(-90.0, 0.0, 3.0)]
    [InlineData(5.0, 0.0, 8.0)]
    [InlineData(-43.0, 349.0, 1.0)]
    [InlineData(10.0, 200.0, 90.0)]
    public void Run_RealModel_IsWhatEveryFacetSays(double latitude, double longitude, double radius) =>
        Compare(ldem4.Grid, ldem4.Moon, SurfacePoints.Direction(latitude, longitude), radius);

    [Theory]
    [InlineData(0.0, 0.0, 20.0)]
    [InlineData(90.0, 0.0, 3.0)]
    [InlineData(-90.0, 0.0, 3.0)]
    [InlineData(6.0, 70.0, 90.0)]
    public void Run_RoughMoon_IsWhatEveryFacetSays(double latitude, double longitude, double radius) =>
        Compare(Rough, new BruteForceMoon(Rough), SurfacePoints.Direction(latitude, longitude), radius);

    [Fact]
    public void Run_AnyNumberOfThreads_GivesTheSame()
    {
        Vector3D sun = SurfacePoints.Sun(SurfacePoints.Direction(0.0, 0.0), 4.0, 50.0);
        List<SurfacePoint> points = SurfacePoints.Facing(
            new BruteForceMoon(Rough), SurfacePoints.Direction(0.0, 0.0), 30.0, sun, 3000, new Random(11));
        ShadowPass pass = new(new SurfaceModel(Rough));
        Run(pass, points, sun, 1); // reads the bounds of the blocks
        (byte[] expected, ShadowStatistics statistics) = Run(pass, points, sun, 1);
        foreach (int threads in new[] { 2, 3, 20 })
        {
            (byte[] hidden, ShadowStatistics others) = Run(pass, points, sun, threads);
            Assert.Equal(expected, hidden);
            Assert.Equal(statistics, others);
        }
    }

    [Fact]
    public void Run_HighSunOverGentleHills_ReadsNoBlock()
    {
        FunctionGrid hills = FunctionGrid.OfHeights(16, (line, sample) => 20.0 * ((line + sample) % 10));
        Vector3D up = SurfacePoints.Direction(2.0, 30.0);
        List<Vector3D> points = [.. Enumerable.Range(0, 100).Select(i => 1_737_500.0 * SurfacePoints.Direction(2.0 + (0.01 * i), 30.0))];
        ShadowPass pass = new(new SurfaceModel(hills));
        byte[] hidden = new byte[100];
        pass.Run(new PointReceivers(points, 10), SurfacePoints.Sun(up, 60.0, 0.0), hidden, 1, default);
        Assert.All(hidden, pixel => Assert.Equal(0, pixel));
        Assert.Equal(100, pass.Statistics.Receivers);
        Assert.Equal(0, pass.Statistics.Blocks);
    }

    [Fact]
    public void Run_SmallPartOfAFineModel_ReadsFewBlocks()
    {
        FunctionGrid rough = FunctionGrid.Hilly(512);
        Vector3D up = SurfacePoints.Direction(20.0, 30.0);
        List<Vector3D> points = [.. Enumerable.Range(0, 400).Select(
            i => 1_737_400.0 * SurfacePoints.Direction(20.0 + (0.001 * (i % 20)), 30.0 + (0.001 * (i / 20))))];
        ShadowPass pass = new(new SurfaceModel(rough));
        byte[] hidden = new byte[400];
        pass.Run(new PointReceivers(points, 20), SurfacePoints.Sun(up, 10.0, 90.0), hidden, 1, default);
        Assert.InRange(pass.Statistics.Groups, 1, 40); // as far as a model of any height may throw shadows

        pass.Run(new PointReceivers(points, 20), SurfacePoints.Sun(up, 10.0, 90.0), hidden, 1, default);
        Assert.Contains((byte)1, hidden);
        Assert.InRange(pass.Statistics.Groups, 1, 4);
        Assert.InRange(pass.Statistics.Blocks, 1, 9);
        Assert.InRange(pass.Statistics.Strips, 1, 200);
        Assert.InRange(pass.Statistics.Tries, 1, 4000);
    }

    [Fact]
    public void Run_DeepNight_LooksAtNothing()
    {
        Vector3D sun = SurfacePoints.Sun(SurfacePoints.Direction(0.0, 0.0), -40.0, 0.0);
        ShadowPass pass = new(new SurfaceModel(Rough));
        byte[] hidden = new byte[2];
        pass.Run(
            new PointReceivers([1_740_000.0 * SurfacePoints.Direction(0.0, 0.0), 1_740_000.0 * SurfacePoints.Direction(1.0, 0.0)], 1),
            sun,
            hidden,
            1,
            default);
        Assert.Equal([1, 1], hidden);
        Assert.Equal(default, pass.Statistics);
    }

    [Fact]
    public void Run_PixelsWithoutReceiver_BecomeZero()
    {
        ShadowPass pass = new(new SurfaceModel(FunctionGrid.Hilly(4)));
        byte[] hidden = [7, 7, 7, 7];
        pass.Run(new PointReceivers([], 2), 1.5e11 * Vector3D.UnitX, hidden, 2, default);
        Assert.Equal([7, 7, 7, 7], hidden); // an image without rows has no pixel
        pass.Run(new PointReceivers([1_738_000.0 * Vector3D.UnitX], 4), 1.5e11 * Vector3D.UnitX, hidden, 2, default);
        Assert.Equal([0, 0, 0, 0], hidden);
    }

    [Fact]
    public void Run_SunInsideTheMoon_IsRefused()
    {
        ShadowPass pass = new(new SurfaceModel(FunctionGrid.Hilly(4)));
        BadInputException error = Assert.Throws<BadInputException>(
            () => pass.Run(new PointReceivers([], 1), 1_700_000.0 * Vector3D.UnitX, [], 1, default));
        Assert.Contains("inside the Moon", error.Message);
    }

    [Fact]
    public void Run_Cancelled_Ends()
    {
        ShadowPass pass = new(new SurfaceModel(FunctionGrid.Hilly(4)));
        Assert.ThrowsAny<OperationCanceledException>(() => pass.Run(
            new PointReceivers([1_738_000.0 * Vector3D.UnitX], 1), 1.5e11 * Vector3D.UnitX, new byte[1], 2,
            new CancellationToken(canceled: true)));
    }

    private static void Compare(IGlobalGrid grid, BruteForceMoon moon, Vector3D middle, double radiusDegrees)
    {
        Random random = new(20120222);
        ShadowPass pass = new(new SurfaceModel(grid));
        int shadows = 0;
        foreach (double elevation in new[] { -8.0, -0.5, 0.5, 2.0, 5.0, 12.0, 30.0 })
        {
            Vector3D sun = SurfacePoints.Sun(middle, elevation, 360.0 * random.NextDouble());
            List<SurfacePoint> points = SurfacePoints.Facing(moon, middle, radiusDegrees, sun, 1500, random);
            (byte[] hidden, _) = Run(pass, points, sun, 2);
            for (int i = 0; i < points.Count; i++)
            {
                bool isShadowed = moon.IsShadowed(points[i].Facet, points[i].Position, sun);
                Assert.True(isShadowed == (hidden[i] != 0), $"Sun {elevation}: {points[i]}, shadowed {isShadowed}");
                shadows += isShadowed ? 1 : 0;
            }
        }

        Assert.InRange(shadows, 300, 10_200);
    }

    private static (byte[] Hidden, ShadowStatistics Statistics) Run(ShadowPass pass, List<SurfacePoint> points, Vector3D sun, int threads)
    {
        PointReceivers receivers = new([.. points.Select(point => point.Position)], 60);
        byte[] hidden = new byte[receivers.Rows * receivers.Width];
        pass.Run(receivers, sun, hidden, threads, default);
        return (hidden, pass.Statistics);
    }
}
