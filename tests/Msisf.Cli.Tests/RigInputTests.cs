using System.Globalization;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Rig files and options that are wrong: one line that says what and where, and no output.</summary>
public sealed class RigInputTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("", 2, "rig.yaml, line 1, column 1: a rig needs 'cameras': below it the name of each camera")]
    [InlineData("cameras: {}\n", 2, "rig.yaml, line 1, column 1: the rig has no camera. Add the name of one below 'cameras'")]
    [InlineData("cameras:\n", 2, "rig.yaml, line 1, column 9: 'cameras' has no value")]
    [InlineData(
        "cameras:\n  a:\n    fov: 5\n    quaternion: [0, 0, 0, 1]\n  a:\n    fov: 4\n", 2,
        "line 5, column 3: 'a' is there already")]
    [InlineData("cameras:\n  a:\n    fov: 5\n    quaternion: [0, 0, 0.5, 1]\n", 2, "line 4, column 5: 'quaternion' has length 1.118")]
    [InlineData("cameras:\n  a:\n    fov: 5\n    quaternion: [0, 0, 1]\n", 2, "line 4, column 5: 'quaternion' has 3 numbers; 4 are needed")]
    [InlineData("cameras:\n  a:\n    fov: 5\n", 2, "line 2, column 3: a camera of a rig needs 'quaternion'")]
    [InlineData(
        "cameras:\n  a:\n    quaternoin: [0, 0, 0, 1]\n", 2, "'quaternoin' is not a key of a camera of a rig: did you mean quaternion?")]
    [InlineData("camera:\n  a:\n    fov: 5\n", 2, "'camera' is not a key of a rig: did you mean cameras?")]
    [InlineData("cameras:\n  a b:\n    quaternion: [0, 0, 0, 1]\n", 2, "'a b' is not a name of a camera: 1 to 40 letters")]
    [InlineData("cameras:\n  a: 5\n", 2, "'a' is a camera of a rig: put its keys below it")]
    [InlineData("cameras:\n  a:\n    width: x\n    quaternion: [0, 0, 0, 1]\n", 2, "rig.yaml, camera a: --width is 'x'")]
    [InlineData(
        "cameras:\n  a:\n    camera: no.yaml\n    quaternion: [0, 0, 0, 1]\n", 2,
        "camera a: --camera no.yaml: there is no such file.")]
    [InlineData("cameras:\n  a:\n    lines: 5\n    quaternion: [0, 0, 0, 1]\n", 2, "camera a: --lines needs a camera that scans")]
    [InlineData(
        "cameras:\n  a:\n    quaternion: [0, 0, 0, 1]\n  A:\n    quaternion: [0, 0, 0, 1]\n", 2,
        "line 4, column 3: 'A' differs from another name in its capitals only, and files would differ so")]
    public void Run_WrongRig_SaysWhatAndWhere(string content, int exitCode, string message)
    {
        string rig = _folder.Write("rig.yaml", content);
        CommandLineRun run = CommandLineRun.Of(
            ["--fixed-state", "{55289,1.9E6,0,0,0,0,0,1}", "--rig", rig, "--renderer", "native", "--output-dir", _folder["wrong"]]);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.Equal(exitCode, run.ExitCode);
        Assert.False(Directory.Exists(_folder["wrong"]));
    }

    /// <summary>Half of a right angle about z to four decimals: sqrt(0.3827^2 + 0.9239^2) is 1.000025.</summary>
    [Theory]
    [InlineData("--fixed-state {55289,1.9E6,0,0,0,0,0,1}")]
    [InlineData("--position 0,0,1E5 --time 55289")]
    [InlineData("--kepler-set {1.9E6,0.05,0.7,1.1,0.9,2.0} --epoch 55289 --time 55289")]
    public void Run_MountingOfFewDecimals_IsTakenWithNormalize(string place)
    {
        string rounded = _folder.Write(
            "rounded.yaml", "cameras:\n  a:\n    fov: 5\n    width: 4\n    height: 4\n    quaternion: [0, 0, 0.3827, 0.9239]\n");
        string exact = _folder.Write(
            "exact.yaml",
            "cameras:\n  a:\n    fov: 5\n    width: 4\n    height: 4\n    quaternion: [0, 0, 0.38269033719097734, 0.9238766724085289]\n");

        CommandLineRun refused = StatesOf(rounded);
        CommandLineRun taken = StatesOf(rounded, "--normalize");
        CommandLineRun expected = StatesOf(exact);

        Assert.Contains("'quaternion' has length 1.0000252", refused.Error, StringComparison.Ordinal);
        Assert.Contains("Add decimals, or give --normalize.", refused.Error, StringComparison.Ordinal);
        Assert.Equal(0, taken.ExitCode);
        Assert.NotEmpty(taken.Output);
        double[] found = NumbersOf(taken.Output);
        double[] numbers = NumbersOf(expected.Output);
        Assert.Equal(numbers.Length, found.Length);
        Assert.All(numbers.Zip(found), pair => Assert.Equal(pair.First, pair.Second, 1e-12 * Math.Max(1.0, Math.Abs(pair.First))));

        CommandLineRun StatesOf(string rig, params string[] more) => CommandLineRun.Of(
        [
            "states", "--format", "batch", "--to", _folder["{camera}.tab"], "--renderer", "native", "--rig", rig, .. place.Split(' '),
            .. more,
        ]);

        static double[] NumbersOf(string path) =>
        [
            .. File.ReadAllLines(path.Trim()).Where(line => !line.StartsWith('#'))
                .SelectMany(line => line.Split([' ', ','], StringSplitOptions.RemoveEmptyEntries))
                .Select(word => double.TryParse(word, CultureInfo.InvariantCulture, out double number) ? number : 0.0),
        ];
    }

    [Theory]
    [InlineData("--rig FILE --renderer native --fov 5", 1, "--fov and --rig exclude each other: the rig file says it of each camera.")]
    [InlineData("--rig FILE", 1, "--rig draws with the program's own renderer. Add --renderer native.")]
    [InlineData("--rig no.yaml --renderer native", 2, "--rig no.yaml: there is no such file.")]
    [InlineData("--rig . --renderer native", 2, "--rig .: is a folder; a rig file is needed.")]
    [InlineData("--output-name {camera} --renderer native", 1, "and {camera} with --rig.")]
    [InlineData("states --rig FILE --renderer native --to a.tab", 1, "Give --to a path with {camera} in it")]
    public void Run_RigWithOtherOptions_IsRefused(string words, int exitCode, string message)
    {
        string rig = _folder.Write("rig.yaml", "cameras:\n  plain:\n    fov: 25\n    quaternion: [0, 0, 0, 1]\n");
        CommandLineRun run = CommandLineRun.Of(
        [
            .. words.Split(' ').Select(word => word == "FILE" ? rig : word), "--fixed-state", "{55289,1.9E6,0,0,0,0,0,1}",
        ]);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.Equal(exitCode, run.ExitCode);
    }
}
