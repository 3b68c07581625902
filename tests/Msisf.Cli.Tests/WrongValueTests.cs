using System.Globalization;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>
/// Every option of every command: a value that it does not take is exit code 1, whatever kind of option it is. In this process: two
/// thousand starts of a built program would take longer than all other tests of the command line, and ask the same table.
/// </summary>
public sealed class WrongValueTests : IDisposable
{
    private const string Fixed = "--fixed-state {55289,2E6,2E6,0,0,0,0,1}";
    private const string Orbit = "--kepler-set {1.9E6,0,0,0,1,0} --epoch 55289 --time 55289 --attitude {0,0,0,1}";
    private const string Place = "--position 1,2,3E4 --time 55289";

    /// <summary>Options whose value can be any text or path.</summary>
    private static readonly string[] TakingAnything = ["--output-name", "--pov-options"];

    /// <summary>Wrong values of options with a syntax of their own.</summary>
    private static readonly Dictionary<string, string[]> WrongTexts = new(StringComparer.Ordinal)
    {
        ["--time-interval"] = ["x", "[1:2]", "[1:0:2]", "[1:x:2]", "[1e9:1:2e9]"],
        ["--image-lines"] = ["x", "5", "0-3", "5-3", "1-2-3"],
        ["--camera-model"] = ["x", "csm,x", "csm,"],
        ["--map"] = ["x", "orthographic", "orthographic,0", "orthographic,x", "orthographic,1e9", "mercator,100", "orthographic,100,2"],
        ["--to"] = ["x", "csm,x"],
        ["--output-name"] = ["a/b", "{frame}", " "],
        ["--reflectance"] = ["x", "lambrt", "hapke:x=1", "hapke:w=x", "hapke:w=5"],
        ["--layers"] = ["x", "depth,x", "depth,depth"],
        ["--samples"] = ["x", "", "0", "2", "257", "1.5", "auto:", "auto:x", "auto:0", "4:0.5"],
        ["--indirect"] = ["x", "0", "-1", "9", "1.5"],
        ["--pov-options"] = ["fast", "+W64"],
        ["--frames"] = ["x", "0", "5:3"],
        ["--refine"] = ["x", "-1", "1.5"],
        ["--exposure-time"] = ["x", "0", "-1", "1e999", "NaN", "86401", "5ms", "automatic"],
        ["--noise-seed"] = ["x", "-1", "1.5", "1:", ":1", "1:2:3", "18446744073709551616"],
        ["--position"] = ["x", "1,2", "91,0,1e5", "0,400,1e5", "0,0,x", "0,0,terrain+x"],
        ["--camera"] = [" ", "lroc-wac"],
        ["--albedo-map-properties"] = ["x", "scale=x", "colour=red", "band=x"],
        ["--albedo-map-checksum"] = ["x", "abc"],
        ["--look-at"] = ["x", "1", "91,0", "0,0,x", "horizon:x"],
        ["--off-nadir"] = ["x", "-1", "181", "10,x"],
        ["--spacecraft"] = ["x"],
        ["--instrument"] = ["x"],
        ["--instrument-axes"] = ["x", "+x", "+x,+x"],
        ["--flow"] = ["x", "{1,2}"],
        ["--flow-format"] = ["x", "fits,x"],
        ["--exposure"] = ["x", "0", "-1", "NaN", "1e999", ""],
        ["--certify"] = ["x", "height=x", "height=-1", "roll=1", "height=1,height=2", ""],
        ["--certify-sigmas"] = ["x", "-1", "1000"],
        ["--sensitivity"] = ["x", "turn-x,x", "turn-x,turn-x", "pose"],
        ["--information"] = ["x", "pose,turn-x", "turn-x,turn-x"],
        ["--center"] = ["x", "1", "91,0", "1,2,3"],
        ["--size"] = ["x", "-1", "0", "1,2,3"],
        ["--corners"] = ["x", "1,2,3", "91,0,0,0"],
        ["--above-ground"] = ["x", "-1", "2,x"],
        ["--plane"] = ["x", "1", "181,0", "10,x"],
        ["--piece"] = ["x", "0/2", "3/2", "1"],
        ["--seed"] = ["x", "-1", "1.5"],
        ["--region"] = ["x", "1:2", "5:4:0:1", "0:91:0:1", "0:1:400:401"],
        ["--memory"] = ["x", "4X"],
        ["--time-limit"] = ["x", "1:x"],
        ["--partition"] = ["a b"],
        ["--account"] = ["a b"],
        ["--listen"] = ["x", "127.0.0.1", "127.0.0.1:65536", "moon.example.org:80", "0.0.0.0:80"],
        ["--basilisk"] = ["x", "http://127.0.0.1:5556", "tcp://127.0.0.1:65536"],
        ["--allow-host"] = ["a b", "http://moon.example.org", "a,,b"],
        ["--folders"] = ["a=", "a=b,a=c", "a/b=c"],
        ["--catalogues"] = ["a=", "a=b,a=c", "a/b=c"],
        ["--sbatch-options"] = ["-x", "time=1"],
        ["--batch-euler"] = ["XYQ", "12"],
        ["--from"] = ["x", ""],
        ["--near"] = ["x", "nadir", "1,2,3,4", "91,0"],
        ["--stars"] = ["no-such-file"],
        ["--columns"] = ["x", "lat=", "depth=2", "lat=1,lat=2"],
    };

    private readonly TemporaryFolder _folder = new();

    /// <summary>A command, an option and a wrong value.</summary>
    public static TheoryData<string, string, string> WrongValues
    {
        get
        {
            TheoryData<string, string, string> rows = [];
            foreach ((string path, CommandSpec command) in CommandTable.All.Where(
                entry => entry.Command.Commands.Count == 0 || entry.Path.Length == 0))
            {
                foreach (OptionSpec option in command.Options)
                {
                    foreach (string value in Wrong(option))
                    {
                        rows.Add(path, option.Name, value);
                    }
                }
            }

            return rows;
        }
    }

    public void Dispose() => _folder.Dispose();

    [Theory]
    [MemberData(nameof(WrongValues))]
    public void Run_WrongValueOfAnOption_IsExitCode1(string path, string option, string value)
    {
        string[] given = [option, value];
        string[] arguments = [.. Words(path), .. Others(path, option), .. given];
        CommandLineRun run = CommandLineRun.InThisProcess(
            option is "--output-dir" || !Has(path, "--output-dir") ? arguments : [.. arguments, "--output-dir", _folder["new"]]);

        Assert.True(run.ExitCode == 1, $"{string.Join(' ', arguments)}: exit code {run.ExitCode}: {run.Error}");
        Assert.Single(run.Error.Split('\n', StringSplitOptions.RemoveEmptyEntries));
        Assert.StartsWith("msis: error: ", run.Error, StringComparison.Ordinal);
        Assert.Contains(option, run.Error, StringComparison.Ordinal);
        Assert.Empty(Directory.EnumerateFileSystemEntries(_folder.Path));
    }

    [Fact]
    public void WrongTexts_HaveEachOptionWithASyntax() => Assert.Empty(
        CommandTable.All.SelectMany(entry => entry.Command.Options).OfType<TextSpec>().Select(option => option.Name)
            .Except(TakingAnything).Except(WrongTexts.Keys));

    private static string[] Wrong(OptionSpec option) => option switch
    {
        FlagSpec => [],
        PathSpec => [" "],
        TextSpec => WrongTexts.GetValueOrDefault(option.Name) ?? [],
        WholeNumberSpec number =>
        [
            "x", "1.5", string.Empty, (number.Min - 1L).ToString(CultureInfo.InvariantCulture),
            (number.Max + 1L).ToString(CultureInfo.InvariantCulture),
        ],
        NumberSpec number => ["x", "NaN", "1,5", "1e999", .. number.Limits is { } limits ? OutOf(limits) : []],
        NumberListSpec list =>
            ["x", "{1,2", "{}", $"{{{string.Join(',', list.Fields.Skip(1).Select(_ => "0"))},x}}", "{1e999}"],
        _ => ["nonsense", string.Empty], // a choice
    };

    private static string[] OutOf(NumberRange limits) =>
    [
        (limits.ExcludesMin ? limits.Min : limits.Min - 1.0).ToString("R", CultureInfo.InvariantCulture),
        (limits.ExcludesMax ? limits.Max : limits.Max + 1.0).ToString("R", CultureInfo.InvariantCulture),
    ];

    /// <summary>What the command needs besides, so that the option is looked at.</summary>
    private static string[] Others(string path, string option)
    {
        string needed = path switch
        {
            "batchconvert" => "--format slurm --pieces 2",
            "states" => $"--to {Path.Combine(Path.GetTempPath(), "msis-states")}",
            "submit" => "--pieces 2",
            "ldem synthesize" => "--res 4 --seed 1",
            "status" or "verify" or "merge" => "a-folder",
            "kernels" => "a.bsp",
            "illumination" => "--center=-89.45,222.7 --size 1 --time-interval [55289:0.1:55290]",
            "camera-model" => "a.xml --to csm",
            "twin" => "a.cub",
            "completion" => "bash",
            "dataset" => Path.Combine(TestParts.RepositoryRoot, "input", "data-set.yaml"),
            _ => string.Empty,
        };
        List<string> words = [.. Words(needed)];
        if (Has(path, "--fixed-state") && !(path == "patterns" && IsOfWholeMoon(option)))
        {
            words.AddRange(Words(IsOfPlace(option) ? Place : IsOfOrbit(option) ? Orbit : IsCamera(option) ? string.Empty : Fixed));
        }

        if (Has(path, "--renderer") && NativeOptions.Group.Options.Any(native => native.Name == option))
        {
            words.AddRange(["--renderer", "native"]);
        }

        if (option == NativeOptions.ExposureTime.Name || option == NativeOptions.NoiseSeed.Name)
        {
            words.AddRange(["--camera", Path.Combine(TestParts.RepositoryRoot, "input", "navigation-camera.yaml")]);
        }

        if (option.StartsWith("--layers-", StringComparison.Ordinal))
        {
            words.AddRange(["--layers", "depth"]);
        }

        if (option == "--columns" && path != "illumination")
        {
            words.AddRange(["--landmarks", "a.csv"]);
            words.AddRange(Has(path, "--renderer") ? ["--renderer", "native"] : []);
        }

        if (option == "--rest")
        {
            words.AddRange(["--region", "0:1:0:1"]);
        }

        if (option == "--defaults-file")
        {
            words.AddRange(["--source", "mysql"]);
        }

        return Without(words, option == "--frames-per-piece" ? "--pieces" : option);
    }

    private static string[] Without(List<string> words, string option)
    {
        string[] others = option switch
        {
            "--times" or "--time-interval" => ["--time"],
            "--state-vectors" => ["--kepler-set"],
            _ => [],
        };
        foreach (string name in (string[])[option, .. others])
        {
            int index = words.IndexOf(name);
            if (index >= 0)
            {
                words.RemoveRange(index, 2);
            }
        }

        return [.. words];
    }

    private static bool IsOfWholeMoon(string option) =>
        PatternsOptions.WholeMoon.Options.Any(only => only.Name == option);

    private static bool IsCamera(string option) => option is "--fixed-state" or "--batch-file" or "--for-batch";

    private static bool IsOfPlace(string option) => option is "--position" or "--look-at" or "--off-nadir" or "--up" or "--roll";

    private static bool IsOfOrbit(string option) =>
        !IsCamera(option) && CameraOptions.Group.Options.Any(camera => camera.Name == option);

    private static bool Has(string path, string option) =>
        CommandTable.All.Single(entry => entry.Path == path).Command.Options.Any(known => known.Name == option);

    private static string[] Words(string text) => text.Split(' ', StringSplitOptions.RemoveEmptyEntries);
}
