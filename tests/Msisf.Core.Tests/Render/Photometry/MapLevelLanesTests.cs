using Msisf.Core.Render.Photometry;
using Xunit;

namespace Msisf.Core.Tests.Render.Photometry;

public sealed class MapLevelLanesTests
{
    private const int Seed = 20120222;

    /// <summary>Many places at once give the bits of single ones, or NaN where only the single one knows what to do.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(2)]
    [InlineData(5)]
    public void Read_AnyPlaces_GivesTheBitsOfSinglePlaces(int level)
    {
        AlbedoMap map = SyntheticMaps.Of(256, (column, row) => (column / 40) + (row / 40) == 3
            ? 0
            : 1 + (((79 * column) + (131 * row)) % 60000));
        Random random = new(Seed);
        double[] x = [.. Enumerable.Range(0, 203 + 8).Select(_ => (random.NextDouble() * 258.0) - 1.0)];
        double[] y = [.. Enumerable.Range(0, x.Length).Select(_ => (random.NextDouble() * 130.0) - 1.0)];
        double[] codes = new double[x.Length];
        new MapLevelLanes().Read(map.Levels[level], map.Levels[0], x, y, codes, 203);

        MapLevelReader reader = new(map, level);
        int direct = 0;
        for (int i = 0; i < 203; i++)
        {
            double expected = reader.At(x[i], y[i]);
            Assert.True(double.IsNaN(codes[i]) || codes[i] == expected, $"{x[i]}, {y[i]}: {codes[i]}, not {expected}");
            direct += double.IsNaN(codes[i]) ? 0 : 1;
        }

        Assert.InRange(direct, level == 5 ? 20 : 100, 202); // the map has edges and gaps
    }

    [Fact]
    public void Read_LevelOfOnePixel_IsLeftToSinglePlaces()
    {
        AlbedoMap map = SyntheticMaps.Of(64, (_, _) => 100);
        double[] place = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0];
        double[] codes = new double[8];
        new MapLevelLanes().Read(map.Levels[^1], map.Levels[0], place, place, codes, 3);

        Assert.Equal([double.NaN, double.NaN, double.NaN], codes[..3]);
    }
}
