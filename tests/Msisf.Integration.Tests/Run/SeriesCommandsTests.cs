using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>The commands that look at the folder of a run: <c>status</c>, <c>verify</c>, <c>merge</c>.</summary>
public sealed class SeriesCommandsTests : SeriesRuns
{
    [RequiresFact(Part.Ldem4)]
    public void Verify_FileOfAFrameThatNoRecordNames_IsNotRight()
    {
        Run("out");
        File.Copy(Image("out", 1), Folder["out/MoonSurfIllumSim_step_00002.annotated.png"]);
        CommandLineRun verify = Look("verify", "out");

        Assert.Equal(5, verify.ExitCode);
        Assert.StartsWith("-\tMoonSurfIllumSim_step_00002.annotated.png\tleft over\t", verify.Output, StringComparison.Ordinal);
        Assert.Equal(0, Look("verify", "out", "--print-frames").ExitCode); // no frame has to be made again
        Assert.Equal(0, Look("status", "out").ExitCode);
    }

    /// <summary>Files of two machines in one folder, with one of their manifests: nothing says to remove the other's images.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Verify_FilesOfTwoMachines_SaysHowTheyAreJoined()
    {
        Assert.Equal(0, Run("first", "--frames", "1:3").ExitCode);
        Assert.Equal(0, Run("second", "--frames", "4:6").ExitCode);
        Assert.Equal(0, Run("whole").ExitCode);
        Directory.CreateDirectory(Folder["both"]);
        foreach (string file in Directory.GetFiles(Folder["first"]).Concat(Directory.GetFiles(Folder["second"])))
        {
            File.Copy(file, Path.Combine(Folder["both"], Path.GetFileName(file)), overwrite: true);
        }

        CommandLineRun verify = Look("verify", "both");
        Assert.Equal(5, verify.ExitCode);
        Assert.Contains(
            "-\tMoonSurfIllumSim_step_00001.png\tleft over\tthis folder has no record of its frame; if the frame was made in another "
                + "folder, msis merge with --to copies it with its record",
            verify.Output,
            StringComparison.Ordinal);
        Assert.DoesNotContain("remove", verify.Output, StringComparison.Ordinal);
        Assert.DoesNotContain("delete", verify.Output, StringComparison.Ordinal);

        CommandLineRun merge = CommandLineRun.Of(["merge", Folder["first"], Folder["second"], "--to", Folder["joined"]]);
        Assert.True(merge.ExitCode == 0, merge.Error);
        Assert.Equal(0, Look("verify", "joined").ExitCode);
        Assert.Equal(0, CommandLineRun.Of(["merge", Folder["whole"]]).ExitCode);
        AssertSameBytes("whole", "joined", (2 * Frames) + 1);
        Assert.Contains("of which 6 there and complete", Run("joined").Error, StringComparison.Ordinal);

        // Again, and one after the other, is the same.
        Assert.Equal(0, CommandLineRun.Of(["merge", Folder["second"], "--to", Folder["joined"]]).ExitCode);
        Assert.Equal(5, CommandLineRun.Of(["merge", Folder["first"], "--to", Folder["later"]]).ExitCode);
        Assert.Equal(0, CommandLineRun.Of(["merge", Folder["second"], "--to", Folder["later"]]).ExitCode);
        AssertSameBytes("whole", "later", (2 * Frames) + 1);
    }

    [RequiresFact(Part.Ldem4)]
    public void Merge_FoldersThatContradictEachOther_CopiesNothing()
    {
        Run("first", "--frames", "1:3");
        Run("other", "--reflectance", "lommel-seeliger");
        CommandLineRun different = CommandLineRun.Of(["merge", Folder["first"], Folder["other"], "--to", Folder["joined"]]);
        Assert.Equal(2, different.ExitCode);
        Assert.Contains("have different frames of the name MoonSurfIllumSim_step_00001", different.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(Folder["joined"]));

        CommandLineRun noTarget = CommandLineRun.Of(["merge", Folder["first"], Folder["other"]]);
        Assert.Equal(1, noTarget.ExitCode);
        Assert.Contains("Give that by --to DIR.", noTarget.Error, StringComparison.Ordinal);
        CommandLineRun itself = CommandLineRun.Of(["merge", Folder["first"], "--to", Folder["first"]]);
        Assert.Equal(1, itself.ExitCode);
        Assert.Equal(1, CommandLineRun.Of(["merge"]).ExitCode);

        Directory.CreateDirectory(Folder["mine"]);
        File.WriteAllText(Folder["mine/MoonSurfIllumSim_step_00002.png"], "mine");
        CommandLineRun mine = CommandLineRun.Of(["merge", Folder["first"], "--to", Folder["mine"]]);
        Assert.Equal(1, mine.ExitCode);
        Assert.Contains("MoonSurfIllumSim_step_00002.png: is there, and no record in that folder names it.", mine.Error);
        Assert.Single(Directory.GetFileSystemEntries(Folder["mine"]));
    }

    /// <summary>A file that was damaged without a change of its length is found while it is copied.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Merge_DamagedImage_IsNotCopied()
    {
        Run("first");
        byte[] image = File.ReadAllBytes(Image("first", 2));
        image[^5] ^= 1;
        File.WriteAllBytes(Image("first", 2), image);
        CommandLineRun merge = CommandLineRun.Of(["merge", Folder["first"], "--to", Folder["joined"]]);

        Assert.Equal(2, merge.ExitCode);
        Assert.Contains("MoonSurfIllumSim_step_00002.png: is not as it was written. msis verify", merge.Error, StringComparison.Ordinal);
        Assert.False(File.Exists(Image("joined", 2)));
    }

    [RequiresFact(Part.Ldem4)]
    public void Merge_VideoWithoutFfmpeg_IsAnError()
    {
        Run("out");
        CommandLineRun merge = CommandLineRun.Of(["merge", Folder["out"], "--video", "10"], environment: new() { ["PATH"] = "/nowhere" });

        Assert.Equal(3, merge.ExitCode);
        Assert.Contains("error: no ffmpeg on the PATH: no video is made.", merge.Error, StringComparison.Ordinal);
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("--video", "10")]
    [InlineData("--contact-sheet")]
    public void Merge_FrameWithAFlippedBit_IsNamed(params string[] wish)
    {
        Run("out");
        byte[] image = File.ReadAllBytes(Image("out", 4));
        image[image.Length / 2] ^= 4;
        File.WriteAllBytes(Image("out", 4), image);
        string program = Folder.Write("programs/ffmpeg", "#!/bin/sh\nexit 0\n");
        File.SetUnixFileMode(program, UnixFileMode.UserRead | UnixFileMode.UserExecute);
        CommandLineRun merge = CommandLineRun.Of(["merge", Folder["out"], .. wish], environment: new() { ["PATH"] = Folder["programs"] });

        Assert.Equal(2, merge.ExitCode);
        Assert.Contains($"{Path.GetFullPath(Image("out", 4))}: not a whole PNG image: ", merge.Error, StringComparison.Ordinal);
        Assert.Empty(Directory.GetFiles(Folder["out"], "video*"));
    }

    [Theory]
    [InlineData("status")]
    [InlineData("verify")]
    [InlineData("merge")]
    public void Look_FolderWithoutARun_IsRefused(string command)
    {
        CommandLineRun none = CommandLineRun.Of([command, Folder["none"]]);
        CommandLineRun empty = CommandLineRun.Of([command, Folder.Path]);

        Assert.Equal((2, 2), (none.ExitCode, empty.ExitCode));
        Assert.Contains("there is no such folder", none.Error, StringComparison.Ordinal);
        Assert.Contains("msisf-manifest.jsonl: missing", empty.Error, StringComparison.Ordinal);
        Assert.Empty(Directory.EnumerateFileSystemEntries(Folder.Path));
    }

    [RequiresFact(Part.Ldem4)]
    public void Merge_ContactSheet_ShowsEachFrame()
    {
        Run("out");
        CommandLineRun merge = CommandLineRun.Of(["merge", Folder["out"], "--contact-sheet"]);

        Assert.Equal(0, merge.ExitCode);
        PngPixels sheet = PngPixels.Read(Folder["out/contact-sheet.png"]);
        Assert.Equal((Frames * 176, 192), (sheet.Width, sheet.Height));
        Assert.Equal(
            [".msisf-claims", ".msisf-manifest.lock"],
            Directory.EnumerateFileSystemEntries(Folder["out"], ".*").Select(Path.GetFileName).Order(StringComparer.Ordinal));
    }
}
