using System.CommandLine;
using Msisf.Cli.Options;
using Msisf.Cli.Options.Config;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests.Config;

public sealed class ConfigCommandTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Show_TwoFiles_SaysWhereEachValueComesFrom()
    {
        string user = _folder.Write("msisf/config.yaml", "fov: 41\nbatch: true\n");
        string given = _folder.Write("a.yaml", "# mine\nfov: 42\nlayers:\n  - depth\n  - mask\n");
        CommandLineRun run = CommandLineRun.Of(["config", "show", "--config", given], configHome: _folder.Path);

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
        Assert.Equal(lines.Length, lines.Select(line => line.Split('\t')[0]).Distinct().Count());
        Assert.DoesNotContain(lines, line => line.Split('\t')[0] is "config" or "fixed-state" or "help" or "list-patterns");
    }

    [Fact]
    public void Show_NoFile_SaysWhereItLooked()
    {
        CommandLineRun run = CommandLineRun.Of(["config", "show"], configHome: _folder.Path);

        Assert.Equal(0, run.ExitCode);
        Assert.Equal($"msis: {_folder["msisf/config.yaml"]}: not there (the user's file).\n", run.Error);
        Assert.All(
            run.Output.Split('\n', StringSplitOptions.RemoveEmptyEntries),
            line => Assert.EndsWith("\tdefault", line, StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("PX", "Image width, 1 to 16384 (default 1024)", "1024")]
    [InlineData("A", "Albedo (default 0.64, as in POV-Ray's scene)", "0.64")]
    [InlineData("PX", "How far (default 0.33; native 0.35): a cell", "0.33; native 0.35")]
    [InlineData("PATTERN", "Names {step} (default M_{step:00000})", "M_{step:00000}")]
    [InlineData("PATH", "POV-Ray's folder (default: along the PATH)", "along the PATH")]
    [InlineData("a|b|c", "Engine (default auto: a if it loads, else c)", "auto")]
    [InlineData("srgb|linear", "Grey levels along sRGB's curve (default, as POV-Ray's), or in proportion", "srgb")]
    [InlineData("LAW", "Native: lambert (default), lommel-seeliger", "lambert")]
    [InlineData("N", "Drawn from", "-")]
    public void DefaultText_HelpText_IsUnderstood(string valueName, string description, string text) =>
        Assert.Equal(text, DefaultText.Of(OptionFactory.Value("--x", [], valueName, description)));

    [Fact]
    public void Keys_OptionThatDiffersBetweenCommands_IsRefused()
    {
        RootCommand root = new() { new Command("a") { OptionFactory.Value(
            "--form", [], "x|y", "") }, new Command("b") { OptionFactory.Value("--form", [], "z", "") } };

        Assert.Empty(new ConfigKeys(root).Allowed);
    }

    [Theory]
    [InlineData("fovv", "fov")]
    [InlineData("hight", "height")]
    [InlineData("outputdir", "output-dir")]
    [InlineData("", "fov")]
    public void NearestName_MisspeltWord_IsFound(string word, string name) =>
        Assert.Equal(name, NearestName.To(word, ["height", "output-dir", "fov", "width"]));
}
