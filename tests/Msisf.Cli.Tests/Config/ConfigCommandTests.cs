using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests.Config;

public sealed class ConfigCommandTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    private Dictionary<string, string> Settings => new() { ["XDG_CONFIG_HOME"] = _folder.Path };

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Show_TwoFiles_SaysWhereEachValueComesFrom()
    {
        string user = _folder.Write("msisf/config.yaml", "fov: 41\nbatch: true\n");
        string given = _folder.Write("a.yaml", "# mine\nfov: 42\nlayers:\n  - depth\n  - mask\n");
        CommandLineRun run = CommandLineRun.Of(["config", "show", "--config", given], environment: Settings);

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Equal($"msis: {given}: read (--config).\nmsis: {user}: read (the user's file).\n", run.Error);
        string[] lines = run.Output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Contains($"fov\t42\t{given}:2", lines);
        Assert.Contains($"batch\ttrue\t{user}:2", lines);
        Assert.Contains($"layers\tdepth,mask\t{given}:3", lines);
        Assert.Contains("width\t1024\tdefault", lines);
        Assert.Contains("timing\tfalse\tdefault", lines);
        Assert.Contains("albedo\t0.64\tdefault", lines);
        Assert.Contains("defaults-file\t-\tdefault", lines);
        Assert.Contains("ephemeris\tauto\tdefault", lines);
        Assert.Contains("pov-path\tsearched along the PATH\tdefault", lines);
        Assert.Equal(lines.Length, lines.Select(line => line.Split('\t')[0]).Distinct().Count());
        Assert.DoesNotContain(lines, line => line.Split('\t')[0] is "config" or "fixed-state" or "help" or "list-patterns");
    }

    [Fact]
    public void Show_NoFile_SaysWhereItLooked()
    {
        CommandLineRun run = CommandLineRun.Of(["config", "show"], environment: Settings);

        Assert.Equal(0, run.ExitCode);
        Assert.Equal($"msis: {_folder["msisf/config.yaml"]}: not there (the user's file).\n", run.Error);
        Assert.All(
            run.Output.Split('\n', StringSplitOptions.RemoveEmptyEntries),
            line => Assert.EndsWith("\tdefault", line, StringComparison.Ordinal));
    }
}
