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

    [RequiresFact(Part.Ldem4)]
    public void Merge_VideoWithoutFfmpeg_IsAnError()
    {
        Run("out");
        CommandLineRun merge = CommandLineRun.Of(["merge", Folder["out"], "--video", "10"], searchPath: "/nowhere");

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
        string program = Folder.Write("programs/ffmpeg", "#!/bin/sh\nexit 0\n");
        File.SetUnixFileMode(program, UnixFileMode.UserRead | UnixFileMode.UserExecute);
        CommandLineRun merge = CommandLineRun.Of(["merge", Folder["out"], .. wish], searchPath: Folder["programs"]);

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

    [RequiresFact(Part.Ldem4, Part.Cairo)]
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
