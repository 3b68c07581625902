using Msisf.Core.Maps;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Xunit;

namespace Msisf.Core.Tests.Maps;

public sealed class MapGridTests
{
    private const double Radius = 1_737_400.0;

    /// <summary>A zone of a sphere has the area 2 pi R^2 (sin of one latitude - sin of the other).</summary>
    [Fact]
    public void AreaOf_CellsOfDegrees_AreThatOfTheirZone()
    {
        MapGrid grid = new(new GroundProjection(MapKind.LongitudeLatitude, 0.0, 0.0, Radius), 40, 30, -15.0, 60.0, 1.0, 0.5);
        double zone = Math.Sin(double.DegreesToRadians(60.0)) - Math.Sin(double.DegreesToRadians(40.0));

        Assert.Equal(2.0 * Math.PI * Radius * Radius * zone * (30.0 / 360.0), AreaOf(grid), Radius * Radius * 1e-5);

        // Half of the way from the equator to the pole a degree of longitude is cos 45 degrees as long as one of latitude.
        MapGrid one = grid with { Lines = 1, Samples = 1, Top = 45.0 + 0.25 };
        (double width, double height) = one.SizeOf(0, 0);
        Assert.Equal(Math.Sqrt(0.5) * Radius * Math.PI / 180.0, width, 1.0);
        Assert.Equal(0.5 * Radius * Math.PI / 180.0, height, 1.0);
    }

    /// <summary>
    /// A cap of a sphere has the area of a circle whose radius is the chord from the pole; on the map its radius is 2 R tan of half of its
    /// angle.
    /// </summary>
    [Theory]
    [InlineData(90.0)]
    [InlineData(-90.0)]
    public void AreaOf_CellsOfAPolarMap_AreThatOfTheirCap(double pole)
    {
        const double Cap = 60.0;
        const int Side = 400;
        double reach = 2.0 * Radius * Math.Tan(0.5 * double.DegreesToRadians(Cap));
        double cell = 2.0 * reach / Side;
        MapGrid grid = new(
            new GroundProjection(MapKind.PolarStereographic, double.DegreesToRadians(pole), 0.0, Radius), Side, Side, -reach, reach, cell,
            cell);
        double area = 0.0;
        for (int i = 0; i < grid.Count; i++)
        {
            double latitude = SelenographicPoint.Below(grid.DirectionOf(i / Side, i % Side)).Latitude;
            area += Math.Sign(pole) * double.RadiansToDegrees(latitude) > 90.0 - Cap ? grid.AreaOf(i / Side, i % Side) : 0.0;
        }

        double chord = 2.0 * Radius * Math.Sin(0.5 * double.DegreesToRadians(Cap));
        Assert.Equal(1.0, area / (Math.PI * chord * chord), 0.001); // cells at the cap's border are in or out as a whole
    }

    [Fact]
    public void DirectionsOf_Lines_AreThoseOfTheirCells()
    {
        MapGrid grid = new(new GroundProjection(MapKind.LongitudeLatitude, 0.0, 0.0, Radius), 4, 3, 10.0, 20.0, 2.0, 1.0);

        Vector3D[] directions = grid.DirectionsOf(1, 3);

        Assert.Equal(6, directions.Length);
        SelenographicPoint last = SelenographicPoint.Below(directions[^1]);
        Assert.Equal((17.5, 15.0), (double.RadiansToDegrees(last.Latitude), double.RadiansToDegrees(last.Longitude)), new Near());
        Assert.Contains(grid.DirectionOf(3, 2), grid.Spread());
    }

    private static double AreaOf(MapGrid grid) => Enumerable.Range(0, grid.Count).Sum(i => grid.AreaOf(i / grid.Samples, i % grid.Samples));

    private sealed class Near : IEqualityComparer<(double, double)>
    {
        public bool Equals((double, double) x, (double, double) y) =>
            Math.Max(Math.Abs(x.Item1 - y.Item1), Math.Abs(x.Item2 - y.Item2)) < 1e-9;

        public int GetHashCode((double, double) obj) => 0;
    }
}
