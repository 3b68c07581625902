using Msisf.Core.Numerics;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Shadows;

/// <summary>What the zones say is hidden is hidden by a facet, ray by ray; and they find the most of what is deep in a shadow.</summary>
public sealed class DarkZonesTests(Ldem4Fixture ldem4) : IClassFixture<Ldem4Fixture>
{
    private const int AnyNumberOfBlocks = 1_000_000;

    [RequiresTheory(Part.Ldem4)]
    [InlineData(-88.0, 40.0, 8.0, 0.5)]
    [InlineData(89.0, 10.0, 4.0, 1.5)]
    [InlineData(-43.0, 349.0, 8.0, 1.0)]
    [InlineData(20.0, 200.0, 8.0, 4.0)]
    public void HiddenUpTo_RealModel_HidesOnlyWhatAFacetHides(double latitude, double longitude, double radius, double elevation) =>
        Compare(ldem4.Grid, ldem4.Moon, SurfacePoints.Direction(latitude, longitude), radius, elevation, minShare: 0.2);

    [Theory]
    [InlineData(90.0, 0.0, 8.0, 1.0)]
    [InlineData(0.0, 0.0, 10.0, 6.0)]
    public void HiddenUpTo_RoughMoon_HidesOnlyWhatAFacetHides(double latitude, double longitude, double radius, double elevation)
    {
        FunctionGrid rough = FunctionGrid.Rough(2);
        Compare(
            rough, new BruteForceMoon(rough), SurfacePoints.Direction(latitude, longitude), radius, elevation, minShare: 0.02);
    }

    private static void Compare(
        IGlobalGrid grid, BruteForceMoon moon, Vector3D middle, double radius, double elevation, double minShare)
    {
        SurfaceModel surface = new(grid);
        CasterSearch search = new(surface);
        Random random = new(20120222);
        SunDisc disc = new(SurfacePoints.Sun(middle, elevation, 360.0 * random.NextDouble()));
        List<SurfacePoint> points = SurfacePoints.Facing(moon, middle, radius, disc.CentreMoonMe, 300, random, -disc.Slope);
        ReceiverSort receivers = new();
        receivers.Read(
            new PointReceivers([.. points.Select(point => point.Position)], 50),
            new LightSource(disc.CentreMoonMe, disc.Slope),
            new NightZone(search.SolidRadius, disc.Slope),
            hide: _ => { },
            threads: 2,
            default);
        search.Find(receivers, disc.Slope, threads: 2, default); // reads the blocks
        DarkZones zones = new DarkZoneSearch(surface).Find(receivers, disc.Slope, AnyNumberOfBlocks, threads: 2, default)!;
        int hidden = 0;
        int found = 0;
        foreach (SurfacePoint point in points)
        {
            double top = zones.HiddenUpTo(receivers.Frame.FromMoonMe(point.Position));
            foreach (Vector3D target in disc.PointsMoonMe)
            {
                // A ray that its own facet hides may be anywhere.
                if (Vector3D.Dot(moon.Normal(point.Facet), (target - point.Position).Normalized()) <= SurfacePoints.MinCosine)
                {
                    continue;
                }

                bool isHidden = moon.IsShadowed(point.Facet, point.Position, target);
                bool isFound = Vector3D.Dot(target - disc.CentreMoonMe, receivers.Frame.AxisU) <= top * disc.CentreMoonMe.Length;
                Assert.True(isHidden || !isFound, $"{point} is lit from {target}, but hidden up to {top}.");
                hidden += isHidden ? 1 : 0;
                found += isFound ? 1 : 0;
            }
        }

        Assert.InRange(hidden, 1000, 300 * SunDisc.Points);
        Assert.InRange(found, minShare * hidden, hidden);
    }
}
