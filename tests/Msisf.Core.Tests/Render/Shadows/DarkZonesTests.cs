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
        Compare(new SurfaceModel(ldem4.Grid), PointsOf(ldem4.Moon), (latitude, longitude), radius, elevation, minShare: 0.2);

    [Theory]
    [InlineData(90.0, 0.0, 8.0, 1.0)]
    [InlineData(0.0, 0.0, 10.0, 6.0)]
    public void HiddenUpTo_RoughMoon_HidesOnlyWhatAFacetHides(double latitude, double longitude, double radius, double elevation)
    {
        FunctionGrid rough = FunctionGrid.Rough(2);
        Compare(new SurfaceModel(rough), PointsOf(new BruteForceMoon(rough)), (latitude, longitude), radius, elevation, minShare: 0.02);
    }

    /// <summary>Places inside the finer models and around their seams, which belong to the sections as all other facets do.</summary>
    [Theory]
    [InlineData("polar", -88.0, 0.0, 16.0, 1.0)]
    [InlineData("five", -88.0, 40.0, 12.0, 1.5)]
    [InlineData("gaps", -89.0, 200.0, 12.0, 1.0)]
    [InlineData("meridian", 20.0, 1.0, 16.0, 2.0)]
    public void HiddenUpTo_SeveralModels_HidesOnlyWhatAFacetHides(
        string scene, double latitude, double longitude, double radius, double elevation)
    {
        SurfaceModel surface = NestedScenes.Named(scene).Surface;
        AllFacets all = NestedScenes.FacetsOf(scene);
        Compare(surface, FirstHit, (latitude, longitude), radius, elevation, minShare: 0.02);

        GroundPoint FirstHit(Vector3D direction)
        {
            (FacetId facet, Vector3D point, _) = all.FirstHit(4e6 * direction, -direction)!.Value;
            (Vector3D a, Vector3D b, Vector3D c) = surface.CornersOf(facet);
            return new GroundPoint(point, Vector3D.Cross(b - a, c - a).Normalized(), target => all.IsShadowed(facet, point, target));
        }
    }

    private static Func<Vector3D, GroundPoint> PointsOf(BruteForceMoon moon) => direction =>
    {
        (BruteForceMoon.FacetId facet, double t) = moon.FirstHit(4e6 * direction, -direction)!.Value;
        Vector3D point = (4e6 - t) * direction;
        return new GroundPoint(point, moon.Normal(facet), target => moon.IsShadowed(facet, point, target));
    };

    private static void Compare(
        SurfaceModel surface, Func<Vector3D, GroundPoint> pointAt, (double Latitude, double Longitude) place, double radius,
        double elevation, double minShare)
    {
        Vector3D middle = SurfacePoints.Direction(place.Latitude, place.Longitude);
        CasterSearch search = new(surface);
        Random random = new(20120222);
        SunDisc disc = new(SurfacePoints.Sun(middle, elevation, 360.0 * random.NextDouble()));
        GroundPoint[] points = [.. SurfacePoints.Around(middle, radius, 6000, random).Select(pointAt)
            .Where(point => Vector3D.Dot(point.Normal, (disc.CentreBodyFixed - point.Position).Normalized()) > -disc.Slope).Take(300)];
        ReceiverJob job = new(
            new PointReceivers([.. points.Select(point => point.Position)], 50),
            new NightZone(search.SolidRadius, disc.Slope),
            Hide: _ => { },
            Threads: 2,
            default);
        PlacedReceivers receivers = new ReceiverSort().Read(job, new LightSource(disc.CentreBodyFixed, disc.Slope));
        search.Find(receivers, disc.Slope, threads: 2, default); // reads the blocks
        DarkZones zones = new DarkZoneSearch(surface).Find(receivers, disc.Slope, AnyNumberOfBlocks, threads: 2, default)!;
        int hidden = 0;
        int found = 0;
        foreach (GroundPoint point in points)
        {
            double top = zones.HiddenUpTo(receivers.Frame.FromBodyFixed(point.Position));
            foreach (Vector3D target in disc.PointsBodyFixed)
            {
                // A ray that its own facet hides may be anywhere.
                if (Vector3D.Dot(point.Normal, (target - point.Position).Normalized()) <= SurfacePoints.MinCosine)
                {
                    continue;
                }

                bool isHidden = point.IsHidden(target);
                bool isFound = Vector3D.Dot(target - disc.CentreBodyFixed, receivers.Frame.AxisU) <= top * disc.CentreBodyFixed.Length;
                Assert.True(isHidden || !isFound, $"{point} is lit from {target}, but hidden up to {top}.");
                hidden += isHidden ? 1 : 0;
                found += isFound ? 1 : 0;
            }
        }

        Assert.InRange(hidden, 1000, 300 * SunDisc.Points);
        Assert.InRange(found, minShare * hidden, hidden);
    }

    private readonly record struct GroundPoint(Vector3D Position, Vector3D Normal, Predicate<Vector3D> IsHidden);
}
