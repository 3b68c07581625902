using Msisf.App.DataSets;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.App.Tests.DataSets;

public class RegionTests
{
    [Theory]
    [InlineData(-90.0, 90.0, 0.0, 360.0, 1.0)]
    [InlineData(0.0, 90.0, 0.0, 360.0, 0.5)]
    [InlineData(30.0, 90.0, -90.0, 90.0, 0.125)]
    public void Area_OfKnownRegions_IsTheirPartOfTheSphere(double south, double north, double west, double east, double part) =>
        Assert.Equal(part, new Region(south, north, west, east).Area, Rounding.OfUnits);

    /// <summary>On a grid of the square each band between two parallels gets its part of the area.</summary>
    [Fact]
    public void At_EvenPoints_AreEvenOnTheSphere()
    {
        Region region = new(-60.0, 90.0, 350.0, 370.0);
        (double Latitude, double Longitude)[] places = [.. Enumerable.Range(0, 10000)
            .Select(i => region.At(((i % 100) + 0.5) / 100.0, ((i / 100) + 0.5) / 100.0))];

        double north = (1.0 - Math.Sin(Math.PI / 4.0)) / (1.0 + Math.Sin(Math.PI / 3.0));
        Assert.Equal(north, places.Count(place => place.Latitude > 45.0) / 10000.0, 0.01);
        Assert.All(places, place => Assert.InRange(place.Longitude, 350.0, 370.0));
        Assert.All(places, place => Assert.True(region.Contains(PointOf(place.Latitude, place.Longitude))));
    }

    [Theory]
    [InlineData(-10.0, 355.0, true)]
    [InlineData(-10.0, 5.0, true)]
    [InlineData(-10.0, 15.0, false)]
    [InlineData(-10.0, 345.0, false)]
    [InlineData(-61.0, 0.0, false)]
    public void Contains_AcrossTheMeridian_Wraps(double latitude, double longitude, bool isInside) =>
        Assert.Equal(isInside, new Region(-60.0, 60.0, 350.0, 370.0).Contains(PointOf(latitude, longitude)));

    [Theory]
    [InlineData(0.0, 10.0, 20.0, 30.0, false)]
    [InlineData(0.0, 10.0, 10.0, 30.0, true)]
    [InlineData(0.0, 10.0, 5.0, 6.0, true)]
    [InlineData(350.0, 370.0, 5.0, 6.0, true)]
    [InlineData(350.0, 370.0, 11.0, 349.0, false)]
    [InlineData(-20.0, -10.0, 345.0, 346.0, true)]
    [InlineData(0.0, 360.0, 5.0, 6.0, true)]
    public void Touches_OnOneParallel_IsFoundBothWays(double west, double east, double otherWest, double otherEast, bool touches)
    {
        Region region = new(-10.0, 10.0, west, east);
        Region other = new(10.0, 20.0, otherWest, otherEast);

        Assert.Equal(touches, region.Touches(other));
        Assert.Equal(touches, other.Touches(region));
        Assert.False(region.Touches(other with { South = 10.5 }));
    }

    [Fact]
    public void At_SplitOfTwoRegions_VisitsEachByItsArea()
    {
        Split split = new("a", 1, [new Region(0.0, 10.0, 0.0, 30.0), new Region(0.0, 10.0, 100.0, 110.0)], IsBound: true);
        double[] longitudes = [.. Enumerable.Range(0, 400).Select(i => split.At((i + 0.5) / 400.0, 0.5).Place.Longitude)];

        Assert.Equal(300, longitudes.Count(longitude => longitude < 30.0));
        Assert.Equal(100, longitudes.Count(longitude => longitude is > 100.0 and < 110.0));
    }

    private static Vector3D PointOf(double latitude, double longitude)
    {
        (double sine, double cosine) = Math.SinCos(latitude * Math.PI / 180.0);
        (double y, double x) = Math.SinCos(longitude * Math.PI / 180.0);
        return new Vector3D(2e6 * cosine * x, 2e6 * cosine * y, 2e6 * sine);
    }
}
