using Msisf.Adapters.Tiles;
using Msisf.Core.Errors;
using Msisf.Core.Tiles;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.MySql.Tests;

public class LdemTableGridTests
{
    private static readonly FunctionGrid Rough = FunctionGrid.Rough(2);

    [Theory]
    [InlineData(0, 0, 720)]
    [InlineData(359, 719, 1)]
    [InlineData(100, 710, 30)]
    [InlineData(7, 5, 11)]
    public void ReadRadii_AnyRun_IsWhatTheTableHas(int line, int firstSample, int samples)
    {
        FakeMoon moon = new(Rough, FakeMoon.Record("TEST_GRID"));
        double[] expected = new double[samples];
        Rough.ReadRadii(line, firstSample, expected);
        double[] radii = new double[samples];

        LdemTableGrid.Open(moon.Database, 2).ReadRadii(line, firstSample, radii);

        Assert.Equal(expected, radii);
        Assert.Equal(0, moon.Source.OpenConnections);
    }

    [Fact]
    public void ReadRadii_LongLines_AreReadInRuns()
    {
        FunctionGrid fine = FunctionGrid.Rough(64);
        FakeMoon moon = new(fine, FakeMoon.Record("TEST_GRID"));
        double[] expected = new double[23040];
        fine.ReadRadii(5000, 23000, expected);
        double[] radii = new double[23040];

        LdemTableGrid.Open(moon.Database, 64).ReadRadii(5000, 23000, radii);

        Assert.Equal(expected, radii);
        Assert.Equal(3, moon.SampleQueries);
    }

    [Fact]
    public void RadiusBounds_BlockOverTheSeam_IsMinAndMax()
    {
        FunctionGrid peaks = new(
            1, (line, sample) => 1_737_400.0 + (line == 90 && sample == 1 ? 9.5 : 0.0) - (line == 91 && sample == 358 ? 7.5 : 0.0));
        LdemTableGrid grid = LdemTableGrid.Open(new FakeMoon(peaks, FakeMoon.Record("TEST_GRID")).Database, 1);

        Assert.Equal((1_737_392.5, 1_737_409.5), grid.RadiusBounds(89, 3, 357, 6));
        Assert.Equal((1_737_400.0, 1_737_400.0), grid.RadiusBounds(92, 3, 357, 6));
    }

    [Fact]
    public void EnsurePatterns_FromTheTable_AreThoseFromTheGrid()
    {
        using TemporaryFolder folder = new();
        FakeMoon moon = new(Rough, FakeMoon.Record("TEST_GRID"));
        TileId[] tiles = [new(85, 0), new(-90, 355), new(0, 355), new(0, 0)];

        IReadOnlyList<string> expected = new PatternRepository(folder["grid"]).EnsurePatterns(tiles, Rough, default, 2).Paths;
        IReadOnlyList<string> made = new PatternRepository(folder["table"]).EnsurePatterns(
            tiles, LdemTableGrid.Open(moon.Database, 2), default, 2).Paths;

        Assert.Equal(expected.Select(File.ReadAllBytes), made.Select(File.ReadAllBytes));
        Assert.Equal(11 + 11 + 10, moon.SampleQueries); // each line once, whatever the number of threads and tiles
    }

    [Fact]
    public void ReadRadii_MissingSample_IsRefusedWithItsPlace()
    {
        FakeMoon moon = new(Rough, FakeMoon.Record("TEST_GRID")) { MissingColumn = 3 };
        LdemTableGrid grid = LdemTableGrid.Open(moon.Database, 2);

        BadInputException exception = Assert.Throws<BadInputException>(() => grid.ReadRadii(9, 0, new double[2]));

        Assert.StartsWith("table ldem_2: only 719 of 720 samples of line 10 ", exception.Message, StringComparison.Ordinal);
    }
}
