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
    public void Run_OtherSettings_StopsBeforeFinishedFramesAreReplaced()
    {
        Run("out", "--frames", "2:3");
        byte[] manifest = File.ReadAllBytes(_folder["out/msisf-manifest.jsonl"]);
        CommandLineRun wide = Run("out", "--fov", "50", "--samples", "4", "--frames", "1");

        Assert.Equal(1, wide.ExitCode);
        Assert.Contains(
            "out: finished frames would be replaced: 2 frames made with --fov 40, now 50; --samples 1, now 4. "
                + "Use --overwrite to replace them, or another --output-dir to keep them.",
            wide.Error,
            StringComparison.Ordinal);
        Assert.Equal(manifest, File.ReadAllBytes(_folder["out/msisf-manifest.jsonl"]));
        Assert.Equal(0, Run("out").ExitCode); // the old run goes on
        Assert.Equal(0, Look("verify", "out").ExitCode);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_OtherOrbit_StopsToo()
    {
        Run("out");
        string[] otherOrbit = [.. Arguments("out").Select(
            argument => argument.Replace("{2.0E6,", "{2.1E6,", StringComparison.Ordinal))];
        CommandLineRun higher = CommandLineRun.Of([.. otherOrbit, "--reflectance", "lambert", "--ldem", TestParts.Ldem4Label!]);

        Assert.Equal(1, higher.ExitCode);
        Assert.Contains("6 frames made for another time, position, orientation, motion or noise", higher.Error, StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_OtherSettingsWithoutAFileToReplace_GoesOn()
    {
        Run("out", "--frames", "1:2");
        Array.ForEach(Directory.GetFiles(_folder["out"], "*.*"), path =>
        {
            if (Path.GetExtension(path) is ".png" or ".xml")
            {
                File.Delete(path);
            }
        });

        Assert.Equal(0, Run("out", "--fov", "50").ExitCode);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_OtherSettingsWithOverwrite_ReplacesAndGoesOnWithoutIt()
    {
        Run("out");
        byte[] narrow = File.ReadAllBytes(Image("out", 1));
        Assert.Equal(0, Run("out", "--fov", "50", "--overwrite", "--frames", "1").ExitCode);

        Assert.NotEqual(narrow, File.ReadAllBytes(Image("out", 1)));
        CommandLineRun status = Look("status", "out");
        Assert.Equal(5, status.ExitCode);
        Assert.StartsWith(
            "2\tMoonSurfIllumSim_step_00002\tof other settings\tmade with --fov 40, now 50", status.Output, StringComparison.Ordinal);
        Assert.EndsWith("6 frames: 1 complete, 5 of other settings.", status.Output.Trim(), StringComparison.Ordinal);
        CommandLineRun rest = Run("out", "--fov", "50");
        Assert.Equal(0, rest.ExitCode);
        Assert.Contains("1 there and complete", rest.Error, StringComparison.Ordinal);
        Assert.Contains("to make: 0 missing, 0 damaged, 5 of other settings", rest.Error, StringComparison.Ordinal);
        Assert.Equal(0, Look("verify", "out").ExitCode);
    }

    [RequiresFact(Part.Ldem4, Part.Cairo)]
    public void Run_SingleImageAgain_IsReplacedWithItsCompanions()
    {
        Single("out", "--rendering-annotation", "--layers", "depth", "--layers-format", "npy");
        File.WriteAllText(_folder["out/MoonSurfIllumSim_step_00001.txt"], "mine");
        File.WriteAllText(_folder["out/MoonSurfIllumSim_step_00001.notes.png"], "mine");
        CommandLineRun again = Single("out", "--fov", "50");

        Assert.Equal(0, again.ExitCode);
        Assert.Contains(
            "Replaced: 1 frame made with --fov 40, now 50; --rendering-annotation, now without it; --layers depth, now without it; ",
            again.Error,
            StringComparison.Ordinal);
        Assert.Equal(
            [
                "MoonSurfIllumSim_step_00001.notes.png", "MoonSurfIllumSim_step_00001.png", "MoonSurfIllumSim_step_00001.txt",
                "MoonSurfIllumSim_step_00001.xml", "msisf-manifest.jsonl",
            ],
            NamesIn("out"));
        CommandLineRun verify = Look("verify", "out");
        Assert.Equal(0, verify.ExitCode);
        Assert.Equal(
            [
                "-\tMoonSurfIllumSim_step_00001.notes.png\tunknown\tno record names it",
                "-\tMoonSurfIllumSim_step_00001.txt\tunknown\tno record names it",
                "1 frame: 1 complete. 2 files that no record names.",
            ],
            verify.Output.Trim().Split(Environment.NewLine));
    }

    /// <summary>The names of a frame's companions can be those of another frame's image.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_CompanionThatIsAnotherFrame_IsKept()
    {
        Single("out", "--output-name", "a.annotated");
        byte[] other = File.ReadAllBytes(_folder["out/a.annotated.png"]);
        Single("out", "--output-name", "a");
        Assert.Equal(0, Single("out", "--output-name", "a", "--fov", "50").ExitCode);

        Assert.Equal(other, File.ReadAllBytes(_folder["out/a.annotated.png"]));
        Assert.Equal(0, Look("verify", "out").ExitCode);
    }

    [RequiresFact(Part.Ldem4)]
    public void Verify_FileOfAFrameThatNoRecordNames_IsNotRight()
    {
        Run("out");
        File.Copy(Image("out", 1), _folder["out/MoonSurfIllumSim_step_00002.annotated.png"]);
        CommandLineRun verify = Look("verify", "out");

        Assert.Equal(5, verify.ExitCode);
        Assert.StartsWith("-\tMoonSurfIllumSim_step_00002.annotated.png\tleft over\t", verify.Output, StringComparison.Ordinal);
        Assert.Equal(0, Look("verify", "out", "--print-frames").ExitCode); // no frame has to be made again
        Assert.Equal(0, Look("status", "out").ExitCode);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_OtherInputsThanTheFrameNames_WarnsOnceAndSaysWhich()
    {
        Directory.CreateDirectory(_folder["model"]);
        string label = _folder["model/LDEM_4.LBL"];
        File.Copy(TestParts.Ldem4Label!, label);
        byte[] samples = File.ReadAllBytes(Path.ChangeExtension(TestParts.Ldem4Label!, ".IMG"));
        File.WriteAllBytes(_folder["model/LDEM_4.IMG"], samples);
        Run("out", "--ldem", label);

        // Between the pieces that the manifest's checksum covers: the frames count as complete.
        (samples[1_000_000], samples[1_000_001]) = (samples[1_000_002], samples[1_000_003]);
        File.WriteAllBytes(_folder["model/LDEM_4.IMG"], samples);
        CommandLineRun kept = Run("out", "--ldem", label);
        CommandLineRun replaced = Run("out", "--ldem", label, "--overwrite");

        Assert.All([kept, replaced], run => Assert.Equal(0, run.ExitCode));
        Assert.All([kept, replaced], run => Assert.Equal(
            1, run.Error.Split("was made from other input files: another LDEM_4.IMG (SHA-256 972d66d7f330..., now ").Length - 1));
        Assert.DoesNotContain("other input files", Run("out", "--ldem", label).Error, StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4)]
    public void Merge_VideoWithoutFfmpeg_IsAnError()
    {
        Run("out");
        CommandLineRun merge = CommandLineRun.Of(["merge", _folder["out"], "--video", "10"], searchPath: "/nowhere");

        Assert.Equal(3, merge.ExitCode);
        Assert.Contains("error: no ffmpeg on the PATH: no video is made.", merge.Error, StringComparison.Ordinal);
    }

    [RequiresTheory(Part.Ldem4, Part.Cairo)]
    [InlineData("--video", "10")]
    [InlineData("--contact-sheet")]
    public void Merge_FrameWithAFlippedBit_IsNamed(params string[] wish)
    {
        Run("out");
        byte[] image = File.ReadAllBytes(Image("out", 4));
        image[image.Length / 2] ^= 4;
        File.WriteAllBytes(Image("out", 4), image);
        string program = _folder.Write("programs/ffmpeg", "#!/bin/sh\nexit 0\n");
        File.SetUnixFileMode(program, UnixFileMode.UserRead | UnixFileMode.UserExecute);
        CommandLineRun merge = CommandLineRun.Of(["merge", _folder["out"], .. wish], searchPath: _folder["programs"]);

        Assert.Equal(2, merge.ExitCode);
        Assert.Contains($"{Path.GetFullPath(Image("out", 4))}: not a whole PNG image: ", merge.Error, StringComparison.Ordinal);
        Assert.Empty(Directory.GetFiles(_folder["out"], "video*"));
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

        Assert.Equal(1, run.ExitCode);
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
        .. Arguments(folder), .. more.Contains("--reflectance") ? [] : (string[])["--reflectance", "lambert"],
        .. more.Contains("--ldem") ? [] : (string[])["--ldem", TestParts.Ldem4Label!], .. more,
    ]);

    private string[] Arguments(string folder) =>
    [
        "--kepler-set", "{2.0E6,0.01,0,0.3,1.2,0.5}", "--epoch", "55289", "--time-interval", "[55289:0.001:55289.005]", "--renderer",
        "native", "--width", "24", "--height", "16", "--grid", "8", "--ephemeris", "builtin", "--output-dir", _folder[folder], "--batch",
    ];

    private CommandLineRun Single(string folder, params string[] more) => CommandLineRun.Of(
    [
        "--fixed-state", "{55289,2E6,2E6,0,0,0,3.826834323650898E-1,9.238795325112867E-1}", "--renderer", "native",
        "--reflectance", "lambert", "--width", "24",
        "--height", "16", "--grid", "8", "--ldem", TestParts.Ldem4Label!, "--ephemeris", "builtin", "--output-dir", _folder[folder],
        "--batch", .. more,
    ]);

    private string[] NamesIn(string folder) => [.. Directory.EnumerateFiles(_folder[folder]).Select(Path.GetFileName).OfType<string>()
        .Where(name => name[0] != '.').Order(StringComparer.Ordinal)];

    private CommandLineRun Look(string command, string folder, params string[] more) =>
        CommandLineRun.Of([command, _folder[folder], .. more]);

    private void AssertSameBytes(string folder, string other, int files)
    {
        string[] names = NamesIn(folder);
        Assert.Equal(files, names.Length);
        Assert.Equal(names, NamesIn(other));
        Assert.All(
            names,
            name => Assert.Equal(
                File.ReadAllBytes(Path.Combine(_folder[folder], name)), File.ReadAllBytes(Path.Combine(_folder[other], name))));
    }
}
