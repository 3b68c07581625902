using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>Files in the output folder that have a frame's name and that no run recorded: a user's, or those of a lost manifest.</summary>
public sealed class UnrecordedFilesTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.Ldem4)]
    public void Run_FrameWithoutItsManifest_IsRefusedUnlessOverwritten()
    {
        Assert.Equal(0, Run().ExitCode);
        byte[] image = File.ReadAllBytes(_folder["out/moon.png"]);
        File.Delete(_folder["out/msisf-manifest.jsonl"]);

        CommandLineRun refused = Run("--fov", "20");
        Assert.Equal(1, refused.ExitCode);
        Assert.Contains(
            "out: files would be replaced that no run has recorded there: moon.png, moon.xml. Use --overwrite to replace them, or another "
                + "--output-dir to keep them.",
            refused.Error,
            StringComparison.Ordinal);
        Assert.Equal(image, File.ReadAllBytes(_folder["out/moon.png"]));
        Assert.False(File.Exists(_folder["out/msisf-manifest.jsonl"]));

        Assert.Equal(0, Run("--fov", "20", "--overwrite").ExitCode);
        Assert.NotEqual(image, File.ReadAllBytes(_folder["out/moon.png"]));
        CommandLineRun wide = Run("--fov", "30"); // recorded now: a view may be tried
        Assert.True(wide.ExitCode == 0, wide.Error);
        Assert.Contains("Replaced: 1 frame made with --fov 20, now 30.", wide.Error, StringComparison.Ordinal);
    }

    /// <summary>A frame takes files of its name away also where it does not have them itself, so these are protected too.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("moon.png")]
    [InlineData("moon.depth.npy")]
    [InlineData("moon.annotated.png")]
    public void Run_FileOfTheUser_IsLeftAlone(string name)
    {
        _folder.Write($"out/{name}", "mine");

        CommandLineRun refused = Run();

        Assert.Equal(1, refused.ExitCode);
        Assert.Contains($"no run has recorded there: {name}. ", refused.Error, StringComparison.Ordinal);
        Assert.Equal("mine", File.ReadAllText(_folder[$"out/{name}"]));
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_FilesOfOtherNames_DoNotMatter()
    {
        _folder.Write("out/moon.txt", "mine");
        _folder.Write("out/moon2.png", "mine");

        CommandLineRun run = Run();

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Equal("mine", File.ReadAllText(_folder["out/moon2.png"]));
    }

    private CommandLineRun Run(params string[] more) => CommandLineRun.Of(
    [
        "--fixed-state", "{55289,2E6,2E6,0,0,0,3.826834323650898E-1,9.238795325112867E-1}", "--renderer", "native", "--width", "16",
        "--height", "16", "--ldem", TestParts.Ldem4Label!, "--ephemeris", "builtin", "--output-name", "moon", "--output-dir",
        _folder["out"], "--batch", .. more,
    ]);
}
