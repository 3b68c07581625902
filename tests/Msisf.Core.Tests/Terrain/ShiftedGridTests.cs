using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Terrain;

public sealed class ShiftedGridTests
{
    private const double Radius = 1_737_400.0;

    /// <summary>m, of a pixel with 8 px/deg.</summary>
    private const double Pixel = Radius * Math.PI / 180.0 / 8.0;

    /// <summary>The middle of a polar map goes as far east and north as is said; its samples keep their heights.</summary>
    [Theory]
    [InlineData(true, 300.0, -120.0)]
    [InlineData(false, -40.0, 25_000.0)]
    public void Of_PolarMap_GoesEastAndNorth(bool isSouth, double east, double north)
    {
        PolarFunctionGrid map = PolarFunctionGrid.Rugged(isSouth, 100.0, 64, -700.0, 400.0);
        ITerrainGrid shifted = ShiftedGrid.Of(map, east, north);
        Vector3D before = map.Projection.DirectionOf(31.5, 31.5);
        Vector3D way = shifted.Projection.DirectionOf(31.5, 31.5) - before;
        double longitude = Math.Atan2(before.Y, before.X);

        Assert.InRange(Radius * ((way.Y * Math.Cos(longitude)) - (way.X * Math.Sin(longitude))), east - 0.5, east + 0.5);
        Vector3D northward = new(-before.Z * Math.Cos(longitude), -before.Z * Math.Sin(longitude), double.Hypot(before.X, before.Y));
        Assert.InRange(Radius * Vector3D.Dot(way, northward), north - 3.0, north + 3.0); // 25 km of a tangent
        Assert.Equal(RadiiOf(map, 7, 3, 50), RadiiOf(shifted, 7, 3, 50));
        Assert.Equal(new GridWindow(0, 64, 0, 64), shifted.Window);
    }

    /// <summary>By whole samples nothing is interpolated; 60 degrees south a degree of longitude is half as wide.</summary>
    [Fact]
    public void Of_BandShiftedByWholeSamples_HasTheSameHeights()
    {
        WindowGrid map = new(FunctionGrid.Rugged(8), new GridWindow(1195, 1205, 2870, 2901));
        ITerrainGrid shifted = ShiftedGrid.Of(map, 5.0 * Pixel * Math.Cos(Math.PI / 3.0), -2.0 * Pixel);
        Assert.Equal(new GridWindow(1197, 1207, 2875, 2906), shifted.Window);
        Assert.Equal(RadiiOf(map, 1196, 2870, 31), RadiiOf(shifted, 1198, 2875, 31));
        GridWindow across = ShiftedGrid.Of(map, 15.0 * Pixel * Math.Cos(Math.PI / 3.0), 0.0).Window;
        Assert.Equal((5, 36), (across.FirstSample, across.EndSample)); // over the prime meridian
    }

    /// <summary>Heights that rise evenly are known between samples.</summary>
    [Fact]
    public void Of_PieceShiftedByPartsOfSamples_IsBilinear()
    {
        FunctionGrid moon = new(8, (line, sample) => Radius + (10.0 * line) + (3.0 * sample));
        ITerrainGrid shifted = ShiftedGrid.Of(new WindowGrid(moon, new GridWindow(710, 731, 100, 131)), 1.25 * Pixel, -0.5 * Pixel);
        Assert.Equal(new GridWindow(711, 731, 102, 132), shifted.Window);
        double[] radii = RadiiOf(shifted, 720, 102, 30);
        for (int i = 0; i < radii.Length; i++)
        {
            Assert.InRange(radii[i] - (Radius + (10.0 * 719.5) + (3.0 * (102 + i - 1.25))), -1e-2, 1e-2);
        }
    }

    /// <summary>A band around the Moon turns: its samples go on behind the last.</summary>
    [Fact]
    public void Of_Ring_GoesOnAcrossThePrimeMeridian()
    {
        FunctionGrid moon = new(2, (_, sample) => Radius + sample);
        ITerrainGrid shifted = ShiftedGrid.Of(new WindowGrid(moon, new GridWindow(170, 190, 0, 720)), 10.5 * 4.0 * Pixel, 0.0);
        double[] radii = RadiiOf(shifted, 180, 0, 720);
        Assert.InRange(radii[0] - Radius, 709.4, 709.6);
        Assert.InRange(radii[10] - Radius, 359.4, 359.6); // between the last and the first
        Assert.InRange(radii[719] - Radius, 708.4, 708.6);
    }

    [Fact]
    public void ReadGaps_BetweenSamples_AreWhereOneOfTheFourHasNone()
    {
        GridWithGaps holed = new(
            new WindowGrid(FunctionGrid.Rugged(8), new GridWindow(710, 731, 100, 131)), (line, sample) => (line, sample) == (720, 110));
        ITerrainGrid shifted = ShiftedGrid.Of(holed, 0.25 * Pixel, 0.0);
        bool[] gaps = new bool[20];
        shifted.ReadGaps(720, 105, gaps);
        Assert.Equal([5, 6], gaps.Index().Where(gap => gap.Item).Select(gap => gap.Index));
    }

    [Fact]
    public void Of_MapAroundAPole_HasNoEast() => Assert.Contains(
        "no way is east",
        Assert.Throws<BadInputException>(() => ShiftedGrid.Of(PolarFunctionGrid.Rugged(true, 100.0, 64, 31.5, 31.5), 1.0, 0.0)).Message,
        StringComparison.Ordinal);

    [Fact]
    public void Of_BandShiftedBeyondThePole_IsRefused() => Assert.Contains(
        "smaller shift=",
        Assert.Throws<BadInputException>(() => ShiftedGrid.Of(
            new WindowGrid(FunctionGrid.Rugged(8), new GridWindow(2, 40, 100, 131)), 0.0, 5.0 * Pixel)).Message,
        StringComparison.Ordinal);

    private static double[] RadiiOf(ITerrainGrid grid, int line, int sample, int count)
    {
        double[] radii = new double[count];
        grid.ReadRadii(line, sample, radii);
        return radii;
    }
}
