using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests.Config;

/// <summary>Settings from files, seen at the error that a call ends with: no image is made.</summary>
public sealed class ConfigurationTests : IDisposable
{
    private const string Fixed = "--fixed-state {55289,2E6,2E6,0,0,0,3.826834323650898E-1,9.238795325112867E-1} --ephemeris builtin";

    private readonly TemporaryFolder _folder = new();

    private Dictionary<string, string> Settings => new() { ["XDG_CONFIG_HOME"] = _folder.Path };

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("fov: x", 2, "--fov: 'x' is not a number")]
    [InlineData("fov: true", 2, "--fov: 'true' is not a number")]
    [InlineData("fov: 180", 2, "--fov is 180")]
    [InlineData("fov: \"\"", 2, "--fov: a number is missing")]
    [InlineData("width: 0", 2, "--width is '0'")]
    [InlineData("res: 4.0", 2, "--res is '4.0'")]
    [InlineData("renderer: blender", 2, "--renderer is 'blender'")]
    [InlineData("pov-options: [-J, fast]", 2, "--pov-options: 'fast' is not a POV-Ray option")]
    [InlineData("renderer: native\nlayers: [depth, foo]", 2, "--layers depth,foo: 'foo' is not a layer")]
    [InlineData("output-name: a/b", 2, "--output-name 'a/b'")]
    [InlineData("output-dir: \" \"", 2, "--output-dir is empty")]
    [InlineData("renderer: native\nreflectance: hapke:w=0.3\nalbedo: x", 2, "missing.lbl")]
    public void Run_WrongValueInFile_IsTheErrorOfTheOptionWithItsPlace(string settings, int exitCode, string message)
    {
        string file = _folder.Write("a.yaml", $"# settings\n{settings}\n");
        CommandLineRun run = Run($"{Fixed} --ldem missing.lbl --config", file);

        Assert.True(exitCode == run.ExitCode, run.Error);
        Assert.Contains(message, ErrorOf(run), StringComparison.Ordinal);
        if (message.StartsWith("--", StringComparison.Ordinal))
        {
            string key = message.Split(' ', ':')[0];
            Assert.EndsWith($"{key} comes from {file}, line {1 + settings.Split('\n').Length}.", ErrorOf(run), StringComparison.Ordinal);
        }
    }

    [Theory]
    [InlineData("hight: 5", "line 1, column 1: 'hight' is not an option: did you mean height?")]
    [InlineData("--fov: 5", "line 1, column 1: '--fov' is not an option: did you mean fov?")]
    [InlineData("Fov: 5", "did you mean fov?")]
    [InlineData("frobnicate: 5", "'frobnicate' is not an option. 'msis config show' lists all.")]
    [InlineData("fov: 5\ngridh: 5", "line 2, column 1: 'gridh' is not an option: did you mean gridH?")]
    [InlineData("batch: yes", "'batch' is 'yes'; true or false is needed")]
    [InlineData("batch: 1", "'batch' is '1'; true or false is needed")]
    [InlineData("fov: [40]", "'fov' takes one value, not a list")]
    [InlineData("batch: [true]", "'batch' takes one value, not a list")]
    [InlineData("fixed-state: 5", "'fixed-state' can't be in a configuration file: it says where the camera is, or when")]
    [InlineData("time: 5", "it says where the camera is, or when")]
    [InlineData("attitude: 5", "it says where the camera is, or when")]
    [InlineData("list-patterns: true", "'list-patterns' can't be in a configuration file: it belongs to one call")]
    [InlineData("verify: true", "it belongs to one call")]
    [InlineData("config: b.yaml", "it belongs to one call")]
    [InlineData("help: true", "it belongs to one call")]
    [InlineData("<<: {fov: 4}", "'<<' takes a value")]
    public void Run_WrongFile_IsRefusedWithItsPlace(string settings, string message)
    {
        string file = _folder.Write("a.yaml", settings);
        foreach (string call in (string[])[$"{Fixed} --config", "config show --config", "patterns --res x --config"])
        {
            CommandLineRun run = Run(call, file);

            Assert.True(run.ExitCode == 2, run.Error);
            Assert.Contains($"error: {file}, line ", ErrorOf(run), StringComparison.Ordinal);
            Assert.Contains(message, ErrorOf(run), StringComparison.Ordinal);
        }
    }

    [Theory]
    [InlineData("missing.yaml", "there is no such file")]
    [InlineData(".", "is a folder")]
    [InlineData("/proc/self/mem", "the configuration file can't be read")] // for root too
    public void Run_NoSuchFile_IsRefused(string name, string message)
    {
        CommandLineRun run = Run($"{Fixed} --config", name.Length > 1 ? _folder[name] : name);

        Assert.Equal(2, run.ExitCode);
        Assert.Contains(message, ErrorOf(run), StringComparison.Ordinal);
    }

    [Fact]
    public void Run_EmptyPathOfAFile_IsAWrongOption()
    {
        CommandLineRun run = Run($"{Fixed} --config", string.Empty);

        Assert.Equal(1, run.ExitCode);
        Assert.Contains("--config is empty", ErrorOf(run), StringComparison.Ordinal);
    }

    /// <summary>Words in capitals reach the missing model, as those in small letters do.</summary>
    [Theory]
    [InlineData(
        "renderer: Native\nsamples: 9\nbatch: TRUE\nreflectance: Hapke:W=0.3\nalbedo: 0.5\nlayers: [Depth, MASK]", "--aberration LT+S")]
    [InlineData("timeout: 5\nlod: OFF\nlod-error: 1", "--renderer NATIVE")]
    public void Run_WordsInCapitals_MeanTheSame(string settings, string arguments)
    {
        _folder.Write("msisf/config.yaml", settings);
        CommandLineRun run = Run($"{Fixed} --ldem missing.lbl {arguments}");

        Assert.Contains("missing.lbl", ErrorOf(run), StringComparison.Ordinal);
    }

    [Fact]
    public void Run_FileTwice_IsRefused() =>
        Assert.Contains(
            "--config",
            ErrorOf(CommandLineRun.Of(
                [.. Fixed.Split(' '), "--config", _folder.Write("a.yaml", ""), "--config", _folder["a.yaml"]], environment: Settings)),
            StringComparison.Ordinal);

    /// <summary>Each file has another wrong value, so that the error shows which one is used.</summary>
    [Theory]
    [InlineData("--fov 1000", "--fov is 1000")]
    [InlineData("", "--fov is 2000")]
    public void Run_ValueInSeveralPlaces_TakesLineThenFileThenUser(string arguments, string message)
    {
        _folder.Write("msisf/config.yaml", "fov: 3000\n");
        string file = _folder.Write("a.yaml", "fov: 2000\n");

        Assert.Contains(
            message,
            ErrorOf(Run($"{Fixed} {arguments} --config".Replace("  ", " ", StringComparison.Ordinal), file)),
            StringComparison.Ordinal);
        Assert.Contains("--fov is 3000", ErrorOf(Run(Fixed)), StringComparison.Ordinal);
    }

    [Fact]
    public void Run_FlagOfUserFile_IsTakenBackByGivenFile()
    {
        _folder.Write("msisf/config.yaml", "ignore-sun: true\nldem: missing.lbl\n");
        string file = _folder.Write("a.yaml", "ignore-sun: false\naberration: cn\n");

        Assert.Contains("--aberration is 'cn'", ErrorOf(Run($"{Fixed} --config", file)), StringComparison.Ordinal);
    }

    /// <summary>Each call would be an error, were all of it on the command line; so it gets as far as the missing model.</summary>
    [Theory]
    [InlineData("timeout: 5\npov-path: p\npov-options: -A\npattern-repos: r", "--renderer native")]
    [InlineData("timeout: 5\nrenderer: native", "")]
    [InlineData("samples: 9\nlayers: all\nalbedo: 0.5", "")]
    [InlineData("samples: 9\nlayers: all\nrenderer: native", "--renderer povray")]
    [InlineData("layers-format: npy", "--renderer native")]
    [InlineData("lod-error: 1", "--lod off")]
    [InlineData("lod: off", "--lod-error 1")]
    [InlineData("lod: off\nlod-error: 1", "")]
    [InlineData("aberration: lt", "--ignore-sun")]
    [InlineData("ignore-sun: true", "--aberration lt")]
    [InlineData("albedo: 0.5", "--renderer native --reflectance hapke:w=0.3")]
    [InlineData("margin: 5\nseed: 1\nsource: mysql\ndefaults-file: f", "")]
    public void Run_SettingWithoutMeaningInTheCall_IsLeftOut(string settings, string arguments)
    {
        _folder.Write("msisf/config.yaml", settings);
        CommandLineRun run = Run($"{Fixed} --ldem missing.lbl {arguments}".TrimEnd());

        Assert.Contains("missing.lbl", ErrorOf(run), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("renderer: native", "--timeout 5", "--timeout has no meaning with --renderer native")]
    [InlineData("renderer: native", "--list-patterns", "--list-patterns has no meaning with --renderer native")]
    [InlineData("reflectance: hapke:w=0.3\nrenderer: native", "--albedo 0.5", "Leave one out")]
    public void Run_GivenOptionWithoutMeaning_StaysAnErrorThatNamesTheSetting(string settings, string arguments, string message)
    {
        string file = _folder.Write("msisf/config.yaml", settings);
        CommandLineRun run = Run($"{Fixed} {arguments}");

        Assert.Contains(message, ErrorOf(run), StringComparison.Ordinal);
        Assert.Contains(
            settings.Contains("hapke", StringComparison.Ordinal) ? "hapke" : $"--renderer comes from {file}, line 1.",
            ErrorOf(run),
            StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("patterns --ldem missing.lbl", "source: mysql\ndefaults-file: missing.cnf", "missing.lbl")]
    [InlineData("patterns --source mysql", "ldem: missing.lbl\ndefaults-file: missing.cnf", "missing.cnf")]
    [InlineData("patterns", "ldem: missing.lbl\ndefaults-file: missing.cnf", "missing.lbl")]
    [InlineData("ldem synthesize --seed 1", "res: 0", "--res is '0'")]
    [InlineData("ldem synthesize --res 4", "seed: x", "--seed is 'x'")]
    [InlineData("ldem pyramid", "res: 1025", "--res is '1025'")]
    public void Run_OtherCommand_TakesItsSettings(string call, string settings, string message)
    {
        _folder.Write("msisf/config.yaml", settings);

        Assert.Contains(message, ErrorOf(Run(call)), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("ldem: sub/missing.lbl", "sub/missing.lbl")]
    [InlineData("ldem: ../missing.lbl", "../missing.lbl")]
    [InlineData("ldem: /missing.lbl", "/missing.lbl")]
    public void Run_RelativePath_BeginsAtTheFilesFolder(string settings, string path)
    {
        string file = _folder.Write("folder/a.yaml", settings);

        Assert.Contains(
            $"error: {Path.GetFullPath(path, _folder["folder"])}: ", ErrorOf(Run($"{Fixed} --config", file)), StringComparison.Ordinal);
    }

    [Fact]
    public void Run_TildeInPath_IsTheUsersHome()
    {
        string file = _folder.Write("a.yaml", "ldem: ~/missing-model.lbl");

        Assert.Contains(
            $"error: {Path.Combine(Environment.GetEnvironmentVariable("HOME")!, "missing-model.lbl")}: ",
            ErrorOf(Run($"{Fixed} --config", file)), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--help")]
    [InlineData("--version")]
    [InlineData("patterns --help")]
    public void Run_NothingToSet_DoesNotFailForABrokenUserFile(string call)
    {
        _folder.Write("msisf/config.yaml", "fov: [");
        CommandLineRun run = Run(call);

        Assert.True(run.ExitCode == 0, run.Error);
    }

    [Fact]
    public void Run_BrokenUserFile_IsOneLineWithItsPlace()
    {
        string file = _folder.Write("msisf/config.yaml", "fov: [\n");

        Assert.StartsWith($"msis: error: {file}, line 2, column 1: this is not YAML: ", ErrorOf(Run(Fixed)), StringComparison.Ordinal);
    }

    [Fact]
    public void Run_NoArguments_PrintsHelpWhateverTheFileSays()
    {
        _folder.Write("msisf/config.yaml", "batch: true");

        Assert.Equal(0, CommandLineRun.Of([], environment: Settings).ExitCode);
    }

    private CommandLineRun Run(string words, string? last = null) =>
        CommandLineRun.Of(last is null ? words.Split(' ') : [.. words.Split(' '), last], environment: Settings);

    private static string ErrorOf(CommandLineRun run) =>
        Assert.Single(
            run.Error.Split('\n', StringSplitOptions.RemoveEmptyEntries),
            line => line.StartsWith("msis: error: ", StringComparison.Ordinal));
}
