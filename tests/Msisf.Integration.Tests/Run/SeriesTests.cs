using System.Globalization;
using System.Xml.Linq;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>Runs of several frames: in pieces, begun again, by several at once, and what the manifest says of them.</summary>
public sealed class SeriesTests : SeriesRuns
{
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
        Assert.Equal(0, CommandLineRun.Of(["merge", Folder["whole"]]).ExitCode);
        Assert.Equal(0, CommandLineRun.Of(["merge", Folder["pieces"]]).ExitCode);
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
        CommandLineRun again = Run("out", "--overwrite", "--frame-times", Folder["times"]);

        Assert.Equal(0, again.ExitCode);
        Assert.Equal(
            Enumerable.Range(1, Frames),
            File.ReadAllLines(Folder["times"]).Select(line => int.Parse(line.Split('\t')[0], CultureInfo.InvariantCulture)).Order());
        Assert.Equal(0, Look("verify", "out").ExitCode);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_OtherSettings_StopsBeforeFinishedFramesAreReplaced()
    {
        Run("out", "--frames", "2:3");
        byte[] manifest = File.ReadAllBytes(Folder["out/msisf-manifest.jsonl"]);
        CommandLineRun wide = Run("out", "--fov", "50", "--samples", "4", "--frames", "1");

        Assert.Equal(1, wide.ExitCode);
        Assert.Contains(
            "out: finished frames would be replaced: 2 frames made with --fov 40, now 50; --samples 1, now 4. "
                + "Use --overwrite to replace them, or another --output-dir to keep them.",
            wide.Error,
            StringComparison.Ordinal);
        Assert.Equal(manifest, File.ReadAllBytes(Folder["out/msisf-manifest.jsonl"]));
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
        Array.ForEach(Directory.GetFiles(Folder["out"], "*.*"), path =>
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

    [RequiresFact(Part.Ldem4)]
    public void Run_SingleImageAgain_IsReplacedWithItsCompanions()
    {
        Single("out", "--rendering-annotation", "--layers", "depth", "--layers-format", "npy");
        File.WriteAllText(Folder["out/MoonSurfIllumSim_step_00001.txt"], "mine");
        File.WriteAllText(Folder["out/MoonSurfIllumSim_step_00001.notes.png"], "mine");
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
        byte[] other = File.ReadAllBytes(Folder["out/a.annotated.png"]);
        Single("out", "--output-name", "a");
        Assert.Equal(0, Single("out", "--output-name", "a", "--fov", "50").ExitCode);

        Assert.Equal(other, File.ReadAllBytes(Folder["out/a.annotated.png"]));
        Assert.Equal(0, Look("verify", "out").ExitCode);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_OtherInputsThanTheFrameNames_WarnsOnceAndSaysWhich()
    {
        Directory.CreateDirectory(Folder["model"]);
        string label = Folder["model/LDEM_4.LBL"];
        File.Copy(TestParts.Ldem4Label!, label);
        byte[] samples = File.ReadAllBytes(Path.ChangeExtension(TestParts.Ldem4Label!, ".IMG"));
        File.WriteAllBytes(Folder["model/LDEM_4.IMG"], samples);
        Run("out", "--ldem", label);

        // Between the pieces that the manifest's checksum covers: the frames count as complete.
        (samples[1_000_000], samples[1_000_001]) = (samples[1_000_002], samples[1_000_003]);
        File.WriteAllBytes(Folder["model/LDEM_4.IMG"], samples);
        CommandLineRun kept = Run("out", "--ldem", label);
        CommandLineRun replaced = Run("out", "--ldem", label, "--overwrite");

        Assert.All([kept, replaced], run => Assert.Equal(0, run.ExitCode));
        Assert.All([kept, replaced], run => Assert.Equal(
            1, run.Error.Split("was made from other input files: another LDEM_4.IMG (SHA-256 972d66d7f330..., now ").Length - 1));
        Assert.DoesNotContain("other input files", Run("out", "--ldem", label).Error, StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4)]
    public async Task Run_FourAtOnceInOneFolder_ShareTheFrames()
    {
        Run("alone");
        CommandLineRun[] runs = await Within.Seconds(
            300, "four runs at once", Task.WhenAll(Enumerable.Range(0, 4).Select(_ => Task.Run(() => Run("shared")))));

        Assert.All(runs, run => Assert.True(run.ExitCode == 0, run.Error));
        Assert.All(runs, run => Assert.Equal(2 * Frames, run.Output.Trim().Split('\n').Length));
        CommandLineRun.Of(["merge", Folder["alone"]]);
        CommandLineRun.Of(["merge", Folder["shared"]]);
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
        CommandLineRun alone = CommandLineRun.Of([.. words, "--ldem", TestParts.Ldem4Label!, "--output-dir", Folder["alone"], "--batch"]);

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
        Assert.False(Directory.Exists(Folder["out"]));
    }
}
