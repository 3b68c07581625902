using System.Globalization;
using System.Text.RegularExpressions;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>Runs that choose the noise of their detector.</summary>
public sealed class NoiseSeedRunTests : IDisposable
{
    private const string State = "55289 2E6 2E6 0 0 0 3.826834323650898E-1 9.238795325112867E-1";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>One state, three times: other noise each time, which pieces and the frame's own command line make again.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_OneStateManyTimes_HasOtherNoiseEachTime()
    {
        _folder.Write("states.tab", $"{State}\n{State}\n{State}\n");
        Succeed("seven", "--noise-seed", "7");
        Succeed("pieces", "--noise-seed", "7", "--frames", "3");
        Succeed("pieces", "--noise-seed", "7", "--frames", "1:2", "--jobs", "1");
        Succeed("eight", "--noise-seed", "8");
        Succeed("later", "--noise-seed", "7:2");
        Succeed("none");
        byte[][] seven = Images("seven");
        string meta = File.ReadAllText(Output("seven", 2, ".xml"));

        Assert.Equal(3, seven.Select(Convert.ToHexString).Distinct().Count());
        Assert.Equal(seven, Images("pieces"));
        Assert.Empty(Images("eight").Select(Convert.ToHexString).Intersect(seven.Select(Convert.ToHexString)));
        Assert.Equal(seven[1..], Images("later")[..2]);
        Assert.Single(Images("none").Select(Convert.ToHexString).Distinct()); // as ever: the noise follows from the state
        Assert.Equal("7:2", Regex.Match(meta, "--noise-seed ([^ <]*)").Groups[1].Value);
        Assert.DoesNotContain("--noise-seed", File.ReadAllText(Output("none", 2, ".xml")), StringComparison.Ordinal);

        string[] words = [.. Regex.Match(meta, "<CommandLine>([^<]*)</CommandLine>").Groups[1].Value.Split('\'')
            .SelectMany((part, i) => i % 2 == 1 ? [part] : part.Split(' ', StringSplitOptions.RemoveEmptyEntries))];
        words[Array.IndexOf(words, "--camera") + 1] = Camera();
        CommandLineRun again = CommandLineRun.Of(
            [.. words, "--ldem", TestParts.Ldem4Label!, "--batch", "--output-dir", _folder["again"]]);
        Assert.True(again.ExitCode == 0, again.Error);
        Assert.Equal(seven[1], File.ReadAllBytes(Output("again", 1, ".png")));
        Assert.Equal(File.ReadAllText(Output("seven", 2, ".xml")), File.ReadAllText(Output("again", 1, ".xml")));
    }

    /// <summary>A restart knows its frames; another seed is another frame, which a series does not replace.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_AnotherSeedInTheSameFolder_IsAnotherFrame()
    {
        _folder.Write("states.tab", $"{State}\n{State}\n");
        Succeed("out", "--noise-seed", "7");

        Assert.Contains("2 there and complete", Run("out", "--noise-seed", "7").Error, StringComparison.Ordinal);
        CommandLineRun other = Run("out", "--noise-seed", "8");
        Assert.Equal(1, other.ExitCode);
        Assert.Contains("2 frames made for another time, position, orientation, motion or noise", other.Error, StringComparison.Ordinal);
    }

    /// <summary>The column is the option line by line; said twice it is refused, and without a detector it has no meaning.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_Column_IsTheOptionOfEachLine()
    {
        _folder.Write("states.tab", $"{State}\n{State}\n");
        Succeed("five", "--noise-seed", "5");
        Succeed("six", "--noise-seed", "6");
        string state = State.Replace(' ', ',');
        _folder.Write("states.tab", $"time,x,y,z,qx,qy,qz,qw,noise_seed\n{state},6\n{state},5\n");
        Succeed("column");

        Assert.Equal([Images("six")[0], Images("five")[1]], Images("column"));
        Assert.Contains(
            "--noise-seed and the batch file both say the noise seed.", Run("twice", "--noise-seed", "5").Error, StringComparison.Ordinal);
        CommandLineRun grey = CommandLineRun.Of(
        [
            "--batch-file", _folder["states.tab"], "--renderer", "native", "--width", "8", "--height", "8", "--ldem", TestParts.Ldem4Label!,
            "--ephemeris", "builtin", "--output-dir", _folder["grey"], "--albedo-map", "none",
        ]);
        Assert.Equal(0, grey.ExitCode);
        Assert.DoesNotContain("--noise-seed", File.ReadAllText(Output("grey", 1, ".xml")), StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4, Part.CFitsio)]
    public void Run_FitsHeader_HasBothSeeds()
    {
        _folder.Write("states.tab", $"{State}\n");
        Succeed("with", "--noise-seed", "7:3");
        Succeed("without");

        string header = File.ReadAllText(Output("with", 1, ".dn.fits"), System.Text.Encoding.Latin1);
        Assert.Matches("SEED    = '3 +' +/ of the fixed pattern", header);
        Assert.Matches("NOISSEED= '7 +' +/ of the noise", header);
        Assert.Matches("NOISSTEP= '3 +' +/ step of the noise", header);
        string plain = File.ReadAllText(Output("without", 1, ".dn.fits"), System.Text.Encoding.Latin1);
        Assert.Matches("SEED    = '3 +' +/ of all random numbers", plain);
        Assert.DoesNotMatch("NOISSEED|NOISSTEP", plain);
    }

    private string Camera() => _folder.Write(
        "camera.yaml",
        "width: 24\nheight: 16\nfocal-length: 5\npixel-pitch: 0.1\ndetector:\n  f-number: 4\n  exposure-time: 1e-5\n"
            + "  band: [500, 650]\n  quantum-efficiency: 0.45\n  gain: 1\n  adc-bits: 16\n  read-noise: 5\n  prnu: 0.02\n  seed: 3\n");

    private byte[][] Images(string folder) =>
        [.. Directory.EnumerateFiles(_folder[folder], "*.png").Order(StringComparer.Ordinal).Select(File.ReadAllBytes)];

    private string Output(string folder, int step, string ending) =>
        Path.Combine(_folder[folder], string.Create(CultureInfo.InvariantCulture, $"MoonSurfIllumSim_step_{step:00000}{ending}"));

    private void Succeed(string folder, params string[] more)
    {
        CommandLineRun run = Run(folder, more);
        Assert.True(run.ExitCode == 0, run.Error);
    }

    private CommandLineRun Run(string folder, params string[] more) => CommandLineRun.Of(
    [
        "--batch-file", _folder["states.tab"], "--renderer", "native", "--camera", Camera(), "--grid", "16",
        "--ldem", TestParts.Ldem4Label!, "--ephemeris", "builtin", "--output-dir", _folder[folder], "--batch",
        "--albedo-map", "none", .. more,
    ]);
}
