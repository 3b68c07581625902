using Msisf.Adapters.Tiles;
using Msisf.Core.Errors;
using Msisf.Core.Tiles;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.MySql.Tests;

[Collection(PrivateServer.Collection)]
public class LdemTableGridTests(PrivateServer server)
{
    private static readonly FunctionGrid Rough = FunctionGrid.Rough(2);

    [RequiresFact(Part.MariaDb)]
    public void ReadRadii_AnyRun_IsWhatTheTableHas()
    {
        using MoonTable moon = new(server, Rough, [0, 7, 100, 359], MoonTable.Record("TEST_GRID"));
        LdemTableGrid grid = LdemTableGrid.Open(moon.Database, 2);

        foreach ((int line, int firstSample, int samples) in new[] { (0, 0, 720), (359, 719, 1), (100, 710, 30), (7, 5, 11) })
        {
            double[] expected = new double[samples];
            Rough.ReadRadii(line, firstSample, expected);
            double[] radii = new double[samples];
            grid.ReadRadii(line, firstSample, radii);
            Assert.Equal(expected, radii);
        }
    }

    [RequiresFact(Part.MariaDb)]
    public void ReadRadii_LongLines_AreReadInRuns()
    {
        FunctionGrid fine = FunctionGrid.Rough(64);
        using MoonTable moon = new(server, fine, [5000], MoonTable.Record("TEST_GRID"));
        double[] expected = new double[23040];
        fine.ReadRadii(5000, 23000, expected);
        double[] radii = new double[23040];

        LdemTableGrid.Open(moon.Database, 64).ReadRadii(5000, 23000, radii);

        Assert.Equal(expected, radii);
        Assert.Equal(3, moon.SampleQueries);
    }

    [RequiresFact(Part.MariaDb)]
    public void EnsurePatterns_FromTheTable_AreThoseFromTheGrid()
    {
        using TemporaryFolder folder = new();
        using MoonTable moon = new(
            server, Rough, [.. Enumerable.Range(0, 11), .. Enumerable.Range(169, 13), .. Enumerable.Range(349, 11)],
            MoonTable.Record("TEST_GRID"));
        TileId[] tiles = [new(85, 0), new(-90, 355), new(0, 355), new(0, 0)];

        IReadOnlyList<string> expected = new PatternRepository(folder["grid"]).EnsurePatterns(tiles, Rough, default, 2).Paths;
        IReadOnlyList<string> made = new PatternRepository(folder["table"]).EnsurePatterns(
            tiles, LdemTableGrid.Open(moon.Database, 2), default, 2).Paths;

        Assert.Equal(expected.Select(File.ReadAllBytes), made.Select(File.ReadAllBytes));
        Assert.Equal(11 + 11 + 10, moon.SampleQueries); // each line once, whatever the number of threads and tiles
    }

    [RequiresFact(Part.MariaDb)]
    public void ReadRadii_MissingSample_IsRefusedWithItsPlace()
    {
        using MoonTable moon = new(server, Rough, [9], MoonTable.Record("TEST_GRID"));
        server.Execute($"DELETE FROM {moon.Name}.{moon.Table} WHERE row_index = 9 AND col_index = 3");
        LdemTableGrid grid = LdemTableGrid.Open(moon.Database, 2);

        BadInputException exception = Assert.Throws<BadInputException>(() => grid.ReadRadii(9, 0, new double[2]));

        Assert.StartsWith("table ldem_2: only 719 of 720 samples of line 10 ", exception.Message, StringComparison.Ordinal);
    }
}
