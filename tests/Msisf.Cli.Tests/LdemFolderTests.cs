using System.Globalization;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary><c>--ldem FOLDER</c>, whose models say their resolution as a label does.</summary>
public sealed class LdemFolderTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void DryRun_FolderOfOneResolution_TakesIt()
    {
        Synthesize(2);

        CommandLineRun run = DryRun();

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Contains("LDEM_2", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void DryRun_FolderOfSeveralResolutions_AsksForOneThatThenWorks()
    {
        Synthesize(2);
        Synthesize(3);

        CommandLineRun run = DryRun();
        CommandLineRun chosen = DryRun("--res", "3");

        Assert.Equal(2, run.ExitCode);
        Assert.Contains(
            $"{_folder["moon"]}: it has elevation models of 2, 3 px/deg. Add --res with one of these numbers, or name a label.",
            run.Error, StringComparison.Ordinal);
        Assert.True(chosen.ExitCode == 0, chosen.Error);
        Assert.Contains("LDEM_3", chosen.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void DryRun_FolderWithTheUsualResolution_TakesThat()
    {
        Synthesize(2);
        Synthesize(4);

        CommandLineRun run = DryRun();

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Contains("LDEM_4", run.Error, StringComparison.Ordinal);
    }

    private void Synthesize(int resolution)
    {
        CommandLineRun run = CommandLineRun.Of(
        [
            "ldem", "synthesize", "--res", resolution.ToString(CultureInfo.InvariantCulture), "--seed", "1", "--output-dir",
            _folder["moon"],
        ]);
        Assert.True(run.ExitCode == 0, run.Error);
    }

    private CommandLineRun DryRun(params string[] more) => CommandLineRun.Of(
        ["--position", "10,20,1E5", "--time", "55289", "--ephemeris", "builtin", "--dry-run", "--ldem", _folder["moon"], .. more]);
}
