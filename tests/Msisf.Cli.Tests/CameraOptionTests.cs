using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>What <c>--camera</c> says and what it leaves to other options.</summary>
public sealed class CameraOptionTests : IDisposable
{
    private static readonly string[] View =
    [
        "--fixed-state", "{55289,1837400,0,0,0,0,0,1}", "--renderer", "native", "--dry-run", "--format", "csv",
        "--ldem", TestParts.Ldem4Label ?? string.Empty,
    ];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>LROC's narrow camera shows less than a cell of LDEM_4: only a --fov may be meant in radians.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_NarrowPreset_IsNotAskedWhetherItsFieldOfViewIsRadians()
    {
        CommandLineRun preset = CommandLineRun.Of([.. View, "--camera", "lroc-nac-l"]);
        CommandLineRun given = CommandLineRun.Of([.. View, "--fov", "2.8502"]);

        Assert.True(preset.ExitCode == 0, preset.Error);
        Assert.DoesNotContain("--fov", preset.Error, StringComparison.Ordinal);
        Assert.Contains("--fov 2.8502 is in degrees", given.Error, StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_CameraWithoutSize_TakesWidthAndHeight()
    {
        string camera = _folder.Write("c.yaml", "focal-length-px: 50\n");
        string whole = _folder.Write("whole.yaml", "focal-length-px: 50\nwidth: 400\nheight: 200\n");

        CommandLineRun run = CommandLineRun.Of([.. View, "--camera", camera, "--width", "400", "--height", "200"]);

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Equal(CommandLineRun.Of([.. View, "--camera", whole]).Output, run.Output);
        Assert.NotEqual(CommandLineRun.Of([.. View, "--camera", camera, "--width", "200", "--height", "200"]).Output, run.Output);
        Assert.Contains(
            "a camera needs 'height': how many rows the image has; or give --height",
            CommandLineRun.Of([.. View, "--camera", camera, "--width", "400"]).Error, StringComparison.Ordinal);
        Assert.Contains(
            "--width and --camera exclude each other: the camera file says it.",
            CommandLineRun.Of([.. View, "--camera", whole, "--width", "400"]).Error, StringComparison.Ordinal);
    }

    /// <summary>The size that the file does not say belongs to what the frame is made with.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_CameraWithoutSize_NamesTheSizeInItsCommandLine()
    {
        string camera = _folder.Write("c.yaml", "focal-length-px: 10\n");

        CommandLineRun run = CommandLineRun.Of(
            [
                .. View.Except(["--dry-run", "--format", "csv"]), "--camera", camera, "--width", "8", "--height", "4", "--output-dir",
                _folder["out"], "--output-name", "a", "--batch",
            ]);

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Matches("--camera c.yaml#[0-9a-f]{16} --width 8 --height 4 ", File.ReadAllText(Path.Combine(_folder["out"], "a.xml")));
    }
}
