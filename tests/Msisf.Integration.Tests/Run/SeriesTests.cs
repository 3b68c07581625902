using System.Globalization;
using System.Xml.Linq;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>Runs of several frames: in pieces, begun again, by several at once, and what the manifest says of them.</summary>
public sealed class SeriesTests : IDisposable
{
    private const int Frames = 6;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.Ldem4)]
    public void Run_InPieces_MakesTheBytesOfOneRun()
    {
        Assert.Equal(0, Run("whole").ExitCode);
        Assert.Equal(0, Run("pieces", "--frames", "4:6").ExitCode);
        CommandLineRun status = Look("status", "pieces");
        Assert.Equal(5, status.ExitCode);
        Assert.Equal("1\tMoonSurfIllumSim_step_00001\tmissing\tnot made yet", status.Output.Split(Environment.NewLine)[0]);
        Assert.Equal("1:3", Look("verify", "pieces", "--print-frames").Output.Trim());
        Assert.Equal(0, Run("pieces", "--frames", "1:3", "--jobs", "2").ExitCode);

        Assert.Equal(0, Look("verify", "pieces").ExitCode);
        Assert.Equal(string.Empty, Look("verify", "pieces", "--print-frames").Output.Trim());
        Assert.Equal(0, CommandLineRun.Of(["merge", _folder["whole"]]).ExitCode);
        Assert.Equal(0, CommandLineRun.Of(["merge", _folder["pieces"]]).ExitCode);
        AssertSameBytes("whole", "pieces", (2 * Frames) + 1);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_Again_MakesOnlyWhatIsNotThereAndRight()
    {
        string all = Run("out").Output;
        byte[] right = File.ReadAllBytes(Image("out", 1));
        DateTime written = File.GetLastWriteTimeUtc(Image("out", 1));
        byte[] damaged = File.ReadAllBytes(Image("out", 3));
        File.Delete(Image("out", 2));
        File.WriteAllBytes(Image("out", 3), [.. damaged[..^1], 0]); // same length
        Assert.Equal(5, Look("verify", "out").ExitCode);
        CommandLineRun again = Run("out");

        Assert.Equal(0, again.ExitCode);
        Assert.Equal(all, again.Output);
        Assert.Contains(
            "Frames: 6, of which 4 there and complete (--overwrite makes them again); to make: 0 missing, 2 damaged, 0 of other settings.",
            again.Error,
            StringComparison.Ordinal);
        Assert.Equal(written, File.GetLastWriteTimeUtc(Image("out", 1)));
        Assert.Equal(right, File.ReadAllBytes(Image("out", 1)));
        Assert.Equal(damaged, File.ReadAllBytes(Image("out", 3)));
        Assert.Equal(0, Look("verify", "out").ExitCode);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_Overwrite_MakesAllAgain()
    {
        Run("out");
        File.WriteAllText(Image("out", 1), "something else");
        CommandLineRun again = Run("out", "--overwrite", "--frame-times", _folder["times"]);

        Assert.Equal(0, again.ExitCode);
        Assert.Equal(
            Enumerable.Range(1, Frames),
            File.ReadAllLines(_folder["times"]).Select(line => int.Parse(line.Split('\t')[0], CultureInfo.InvariantCulture)).Order());
        Assert.Equal(0, Look("verify", "out").ExitCode);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_OtherSettings_ReplacesTheFrames()
    {
        Run("out");
        byte[] narrow = File.ReadAllBytes(Image("out", 1));
        CommandLineRun wide = Run("out", "--fov", "50", "--frames", "1");

        Assert.Equal(0, wide.ExitCode);
        Assert.Contains("to make: 0 missing, 0 damaged, 1 of other settings", wide.Error, StringComparison.Ordinal);
        Assert.NotEqual(narrow, File.ReadAllBytes(Image("out", 1)));
        CommandLineRun status = Look("status", "out");
        Assert.Equal(5, status.ExitCode);
        Assert.EndsWith("6 frames: 1 complete, 5 of other settings.", status.Output.Trim(), StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4)]
    public async Task Run_FourAtOnceInOneFolder_ShareTheFrames()
    {
        Run("alone");
        CommandLineRun[] runs = await Within.Seconds(
            300, "four runs at once", Task.WhenAll(Enumerable.Range(0, 4).Select(_ => Task.Run(() => Run("shared")))));

        Assert.All(runs, run => Assert.True(run.ExitCode == 0, run.Error));
        Assert.All(runs, run => Assert.Equal(2 * Frames, run.Output.Trim().Split('\n').Length));
        CommandLineRun.Of(["merge", _folder["alone"]]);
        CommandLineRun.Of(["merge", _folder["shared"]]);
        AssertSameBytes("alone", "shared", (2 * Frames) + 1);
    }

    /// <summary>The meta file's command line makes the frame, whatever batch or orbit it came from.</summary>
    [RequiresFact(Part.Ldem4)]
    public void CommandLine_OfAFrameOfAnOrbit_MakesTheSameBytes()
    {
        Run("orbit", "--rendering-annotation", "--reflectance", "hapke:w=0.3,b0=1.25", "--samples", "4");
        string xml = Path.ChangeExtension(Image("orbit", 5), ".xml");
        string line = XDocument.Load(xml).Descendants("CommandLine").Single().Value;
        string[] words = [.. System.CommandLine.Parsing.CommandLineParser.SplitCommandLine(line.Replace('\'', '"'))];
        CommandLineRun alone = CommandLineRun.Of([.. words, "--ldem", TestParts.Ldem4Label!, "--output-dir", _folder["alone"], "--batch"]);

        Assert.True(alone.ExitCode == 0, alone.Error);
        Assert.Equal(File.ReadAllBytes(Image("orbit", 5)), File.ReadAllBytes(Image("alone", 1)));
        Assert.Equal(File.ReadAllText(xml), File.ReadAllText(Path.ChangeExtension(Image("alone", 1), ".xml")));
    }

    [RequiresFact(Part.Ldem4)]
    public void Frames_BeyondTheRun_AreRefused()
    {
        CommandLineRun run = Run("out", "--frames", "5:7");

        Assert.Equal(2, run.ExitCode);
        Assert.Contains("--frames 5:7: step 7 is wanted, but the run has 6 only", run.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(_folder["out"]));
    }

    [Theory]
    [InlineData("status")]
    [InlineData("verify")]
    [InlineData("merge")]
    public void Look_FolderWithoutARun_IsRefused(string command)
    {
        CommandLineRun none = CommandLineRun.Of([command, _folder["none"]]);
        CommandLineRun empty = CommandLineRun.Of([command, _folder.Path]);

        Assert.Equal((2, 2), (none.ExitCode, empty.ExitCode));
        Assert.Contains("there is no such folder", none.Error, StringComparison.Ordinal);
        Assert.Contains("msisf-manifest.jsonl: missing", empty.Error, StringComparison.Ordinal);
        Assert.Empty(Directory.EnumerateFileSystemEntries(_folder.Path));
    }

    [RequiresFact(Part.Ldem4, Part.Cairo)]
    public void Merge_ContactSheet_ShowsEachFrame()
    {
        Run("out");
        CommandLineRun merge = CommandLineRun.Of(["merge", _folder["out"], "--contact-sheet"]);

        Assert.Equal(0, merge.ExitCode);
        PngPixels sheet = PngPixels.Read(_folder["out/contact-sheet.png"]);
        Assert.Equal((Frames * 176, 192), (sheet.Width, sheet.Height));
        Assert.Equal(
            [".msisf-claims", ".msisf-manifest.lock"],
            Directory.EnumerateFileSystemEntries(_folder["out"], ".*").Select(Path.GetFileName).Order(StringComparer.Ordinal));
    }

    private string Image(string folder, int step) => Path.Combine(_folder[folder], $"MoonSurfIllumSim_step_{step:00000}.png");

    private CommandLineRun Run(string folder, params string[] more) => CommandLineRun.Of(
    [
        "--kepler-set", "{2.0E6,0.01,0,0.3,1.2,0.5}", "--epoch", "55289", "--time-interval", "[55289:0.001:55289.005]", "--renderer",
        "native", "--reflectance", "lambert",
        "--width", "24", "--height", "16", "--grid", "8", "--ldem", TestParts.Ldem4Label!, "--ephemeris", "builtin", "--output-dir",
        _folder[folder], "--batch", .. more,
    ]);

    private CommandLineRun Look(string command, string folder, params string[] more) =>
        CommandLineRun.Of([command, _folder[folder], .. more]);

    private void AssertSameBytes(string folder, string other, int files)
    {
        string[] names = [.. Directory.EnumerateFiles(_folder[folder]).Select(Path.GetFileName).OfType<string>().Where(
            name => name[0] != '.').Order(StringComparer.Ordinal)];
        Assert.Equal(files, names.Length);
        Assert.Equal(
            names,
            Directory.EnumerateFiles(_folder[other]).Select(Path.GetFileName).OfType<string>().Where(
                name => name[0] != '.').Order(StringComparer.Ordinal));
        Assert.All(
            names,
            name => Assert.Equal(
                File.ReadAllBytes(Path.Combine(_folder[folder], name)), File.ReadAllBytes(Path.Combine(_folder[other], name))));
    }
}
