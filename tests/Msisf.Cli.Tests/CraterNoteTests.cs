using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Labelled craters that the elevation model cannot show. Cells of LDEM_4 are 7.58 km wide.</summary>
public sealed class CraterNoteTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.Ldem4)]
    [InlineData("0,0,60\n1,1,20\n", "msis: 1 of 2 listed craters are smaller than 4 cells of the model (30.32 km)")]
    [InlineData("0,0,60\n1,1,31\n", null)]
    public void Run_CratersSmallerThanFourCells_AreNoted(string craters, string? note)
    {
        CommandLineRun run = CommandLineRun.Of(
            ["--renderer", "native", "--position", "0.5,0.5,300000", "--time", "2010-04-03T00:00:00Z", "--width", "200", "--height", "150",
             "--craters", _folder.Write("craters.csv", $"lat,lon,diam_km\n{craters}"), "--output-dir", _folder["out"]]);

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Equal(note is not null, run.Error.Contains("listed craters", StringComparison.Ordinal));
        Assert.Contains(note ?? string.Empty, run.Error, StringComparison.Ordinal);
    }
}
