using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Models that do not go together, or not with other options, are one line.</summary>
public sealed class SeveralModelsErrorsTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("MOON MAP --res 4", 1, "--res has no meaning with several --ldem")]
    [InlineData("MOON MAP --renderer povray --list-patterns", 1, "only one model of the whole Moon has tiles")]
    [InlineData("MOON MAP MAP", 1, "is given twice")]
    [InlineData("MOON FOLDER", 2, "a folder; of several --ldem each names")]
    [InlineData("MOON missing.LBL", 2, "missing.LBL")]
    [InlineData("MOON ''", 1, "--ldem is empty")]
    [InlineData("MOON MAP --body mercury", 1, "several --ldem are of the Moon only")]
    public void Run_WrongModels_AreRefusedInOneLine(string models, int exitCode, string message)
    {
        List<string> arguments = [.. SeveralModelsTests.View.Split(' '), "--output-dir", _folder["out"]];
        string[] words = models.Split(' ');
        for (int i = 0; i < words.Length; i++)
        {
            arguments.AddRange(words[i] switch
            {
                "MOON" => ["--ldem", SyntheticModels.Make(_folder["model"], "--res", "2")],
                "MAP" => ["--ldem", SyntheticModels.MakePolar(_folder["model"], 10000)],
                "OTHER" => ["--ldem", SyntheticModels.MakePolar(_folder["model"], 20000)],
                "FOLDER" => ["--ldem", _folder["model"]],
                "''" => ["--ldem", string.Empty],
                "missing.LBL" => ["--ldem", "missing.LBL"],
                _ => (string[])[words[i]],
            });
        }

        if (!models.Contains("--renderer", StringComparison.Ordinal))
        {
            arguments.AddRange(["--renderer", "native"]);
        }

        CommandLineRun run = CommandLineRun.Of([.. arguments]);

        Assert.Equal(exitCode, run.ExitCode);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.Single(run.Error.Split('\n'), line => line.Contains("error", StringComparison.Ordinal));
        Assert.False(Directory.Exists(_folder["out"]));
    }

    /// <summary>Options that can't be are one line that says what to do.</summary>
    [RequiresTheory(Part.Ldem4, Part.PolarPieces, Part.GdalLibrary)]
    [InlineData(",offset=3", "", 1, "a model of the whole Moon is what others are joined to")]
    [InlineData("", ",shift=2e5,0", 1, "shift= is at most 100 km")]
    [InlineData("", ",offset=30000", 2, "offset=30000 makes heights of it")]
    [InlineData(",scale=2", "", 1, "scale= is for other rasters")]
    [InlineData(",values=samples", "", 1, "values= is for other rasters")]
    public void Run_MoveThatCantBe_IsRefused(string ofMoon, string ofMap, int exitCode, string message)
    {
        CommandLineRun run = CommandLineRun.Of(
            ["--renderer", "native", "--ldem", TestParts.Ldem4Label! + ofMoon, "--ldem", TestParts.PolarPiece("NPC")! + ofMap,
             "--position=-84.8,126,9000", "--time", "61060", "--batch", "--output-dir", _folder["out"]]);
        Assert.Equal(exitCode, run.ExitCode);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
    }

    [RequiresFact(Part.PolarPieces, Part.GdalLibrary)]
    public void Run_OneMapThatIsToMeetOthers_SaysThatThereAreNone()
    {
        CommandLineRun run = CommandLineRun.Of(
            ["--renderer", "native", "--ldem", TestParts.PolarPiece("NPC")! + ",offset=auto", "--position=-84.8,126,9000", "--time",
             "61060", "--batch", "--output-dir", _folder["out"]]);
        Assert.Equal(1, run.ExitCode);
        Assert.Contains("and there are none. Give a model of the whole Moon", run.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("patterns")]
    public void Run_CommandsOfOneModel_RefuseSeveral(string command)
    {
        CommandLineRun run = CommandLineRun.Of([command, "--ldem", "a.LBL", "--ldem", "b.LBL"]);
        Assert.Equal(1, run.ExitCode);
        Assert.Contains("--ldem is given 2 times; here it names one.", run.Error, StringComparison.Ordinal);
    }
}
