using Msisf.Core.Attitude;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Photometry;

/// <summary>Maps of a site as bright as the map around them.</summary>
public sealed class AlbedoMatchTests
{
    /// <summary>12 x 8 degrees at 20 to 32 E, 10 to 18 N, 600 x 400 px.</summary>
    private static readonly MapExtent Site = new(Radians(20.0), Radians(18.0), Radians(12.0), Radians(8.0));

    [Fact]
    public void Of_BorderOfKnownValues_IsTheRatioOfTheMeansThere()
    {
        // Inside the site is ten times as bright, which must not count; the map around has the gradient 1000 + 10 a degree of longitude.
        AlbedoMap site = SyntheticMaps.Of(600, 400, Site, (x, y) => x is < 20 or >= 580 || y is < 20 or >= 380 ? 500 : 5000);
        AlbedoMap around = SyntheticMaps.Of(720, (x, _) => (int)(1000 + (10.0 * (((x + 0.5) / 2.0) - 180.0))) + 2000);

        (AlbedoMap found, double factor) = AlbedoMatch.Of(site, [around])!.Value;

        Assert.Same(around, found);
        Assert.Equal((3000.0 + (10.0 * 26.0)) / 500.0, factor, 0.02); // the middle of the border lies at 26 E
    }

    [Fact]
    public void Of_SiteWithHolesAndMapsOfParts_TakesTheFinestThatShowsHalfOfTheBorder()
    {
        // Data in a disc only, whose border is its rim; the finer map around shows the western tenth of it, so the coarser one counts.
        AlbedoMap site = SyntheticMaps.Of(
            600, 400, Site, (x, y) => double.Hypot(x - 300.0, y - 200.0) < 150.0 ? 100 + (y / 4) : 0);
        AlbedoMap part = SyntheticMaps.Of(100, 200, new(Radians(20.0), Radians(18.0), Radians(3.3), Radians(8.0)), (_, _) => 40_000);
        AlbedoMap moon = SyntheticMaps.Of(720, (_, _) => 300);

        (AlbedoMap found, double factor) = AlbedoMatch.Of(site, [part, moon])!.Value;

        Assert.Same(moon, found);
        Assert.Equal(300.0 / 150.0, factor, 0.02);
        Assert.Null(AlbedoMatch.Of(site, [part]));
    }

    [Fact]
    public void Of_SiteAroundThePole_HasNoBorderAtThePole()
    {
        MapExtent cap = new(0.0, Radians(-88.0), 2.0 * Math.PI, Radians(2.0));
        AlbedoMap site = SyntheticMaps.Of(800, 200, cap, (_, y) => y < 100 ? 200 : 4000);
        AlbedoMap moon = SyntheticMaps.Of(720, (_, _) => 600);

        Assert.Equal(3.0, AlbedoMatch.Of(site, [moon])!.Value.Factor, 1e-3); // codes of 200 and 600 are whole numbers
    }

    [Theory]
    [InlineData(26.0, 14.0, true)]
    [InlineData(20.1, 17.9, true)]
    [InlineData(26.0, 26.0, false)]
    [InlineData(206.0, -14.0, false)]
    public void MayHold_PointsOnAndFarBeside_TellsThemApart(double longitude, double latitude, bool expected)
    {
        AlbedoMap site = SyntheticMaps.Of(60, 40, Site, (_, _) => 1);
        Vector3D far = Direction(-60.0, 120.0);
        Vector3D point = 1_737_400.0 * Direction(latitude, longitude);

        Assert.Equal(expected, site.MayHold([far.X, point.X], [far.Y, point.Y], [far.Z, point.Z]));
    }

    [Theory]
    [InlineData(50.0, 40.0, true, false)] // the cap north of 50
    [InlineData(50.0, 60.0, true, true)]
    [InlineData(-50.0, -60.0, false, true)]
    [InlineData(-50.0, 10.0, false, false)]
    public void MayHold_RingAroundAPole_IsItsCap(double edge, double latitude, bool isNorth, bool expected)
    {
        MapExtent ring = new(0.0, Radians(isNorth ? 90.0 : edge), 2.0 * Math.PI, Radians(40.0));
        Vector3D point = 1_737_400.0 * Direction(latitude, 77.0);

        Assert.Equal(expected, SyntheticMaps.Of(90, 10, ring, (_, _) => 1).MayHold([point.X], [point.Y], [point.Z]));
    }

    /// <summary>A site counts where its pixels have data and the point lies on it, whatever lies around it; else the other map.</summary>
    [Fact]
    public void Scale_SiteOverAMap_ReplacesItWhereItHasData()
    {
        AlbedoMap moon = SyntheticMaps.Of(720, (_, _) => 1000);
        AlbedoMap site = SyntheticMaps.Of(600, 400, Site, (x, y) => x < 300 ? 0 : 3000);
        Vector3D position = 1_760_000.0 * Direction(14.0, 26.0);
        Core.Camera.PinholeCamera camera = new(position, NadirPointing.MoonFromCamera(position), 0.5, 512, 512);
        (double Longitude, double Expected)[] places = [(24.0, 0.1), (28.0, 0.3), (31.99, 0.3), (32.01, 0.1), (26.02, 0.3)];
        SunlitPoints points = new();
        points.Clear(places.Length);
        foreach ((double longitude, _) in places)
        {
            Vector3D up = Direction(14.0, longitude);
            points.Add(points.Count, 1.0, 1_737_400.0 * up, up, 0.5);
        }

        points.Factors.AsSpan().Fill(2.0);
        double[] ofLaw = [.. points.Factors];
        AlbedoSampler sampler = new();
        sampler.Scale(points, camera, 1.0, moon, factorOfReference: 0.5, ofLaw);
        sampler.Scale(points, camera, 1.0, site, factorOfReference: 0.5, ofLaw, isSite: true);

        Assert.All(places.Zip(points.Factors), pair => Assert.Equal(2.0 * pair.First.Expected / 0.5, pair.Second, Rounding.OfChains));
    }

    [Fact]
    public void Scaled_AnyMap_HasTheFactorAndTheGeometry()
    {
        AlbedoMap map = SyntheticMaps.Of(60, 40, Site, (_, _) => 7).Scaled(3.0, new ReferenceGeometry(30.0, 0.0, 30.0));

        Assert.Equal(3e-4, map.Step, Rounding.OfChains);
        Assert.Equal(new ReferenceGeometry(30.0, 0.0, 30.0), map.Reference);
        Assert.False(new Core.Render.Shading.RowShader(new Core.Surface.SurfaceModel(FunctionGrid.Hilly(4))).IsFlat(
            new NativeRenderOptions { Reflectance = new LambertReflectance(0.5), AlbedoSites = [map] }));
    }

    private static double Radians(double degrees) => double.DegreesToRadians(degrees);

    private static Vector3D Direction(double latitude, double longitude) =>
        new Core.Terrain.SelenographicPoint(Radians(latitude), Radians(longitude)).ToDirectionBodyFixed();
}
