using System.Globalization;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>The time line: finished folders, batch files, flights.</summary>
[Collection(Chromium.Collection)]
public class FrameTests(Chromium chromium, ViewerServer server)
{
    private const string Small = "samples=1&fit=false&width=96&height=64";

    /// <summary>How the picture differs from one that was read before.</summary>
    private const string DifferenceOfPixels = """
        async stored => {
            const bytesOf = source => {
                const canvas = document.createElement('canvas');
                [canvas.width, canvas.height] = [source.width, source.height];
                canvas.getContext('2d').drawImage(source, 0, 0);
                return canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
            };
            const before = new Image();
            before.src = stored;
            await before.decode();
            const now = document.getElementById('image');
            const [a, b] = [bytesOf(before), bytesOf(now)];
            const most = a.reduce((most, value, index) => Math.max(most, Math.abs(value - (b[index] ?? -1))), 0);
            return most === 0 && a.length === b.length ? 'equal'
                : `${before.width} x ${before.height} before, ${now.width} x ${now.height} now, up to ${most} levels apart`;
        }
        """;

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task FinishedFolder_StepAnnotateAndDrawAnew_ShowsItsImagesAndMetaFiles()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small);
        await viewer.ShowAllAsync();
        await viewer.Page.SelectOptionAsync("#folder", "run");
        await StatusAsync(viewer, "Stored image of frame 1: 96 × 64.");
        string stored = await PixelsAsync(viewer);
        Assert.Contains("1 of 2, 2010-04-03 00:00:00 UTC", await viewer.Page.TextContentAsync("#frame-label"), StringComparison.Ordinal);
        Assert.Equal(30.0, await viewer.NumberAsync("fov"));

        await viewer.Page.ClickAsync("#frame-after");
        await StatusAsync(viewer, "Stored image of frame 2: 96 × 64.");
        await viewer.WaitAsync("() => document.getElementById('meta').textContent.includes('55289.25')");
        Assert.NotEqual(stored, await PixelsAsync(viewer));
        string meta = (await viewer.Page.TextContentAsync("#meta"))!;
        Assert.Contains("--fixed-state '{55289.25,2000000,0,0,0,0,0,1}'", meta, StringComparison.Ordinal);
        Assert.Contains("x 2000000, y 0, z 0 m", meta, StringComparison.Ordinal);

        await viewer.Page.FocusAsync("#stage");
        await viewer.Page.Keyboard.PressAsync("PageUp");
        await StatusAsync(viewer, "Stored image of frame 1: 96 × 64.");
        await viewer.Page.CheckAsync("input[value=annotated]");
        await StatusAsync(viewer, "Stored annotated image of frame 1: 96 × 64.");
        await viewer.MoveAsync(() => viewer.Page.CheckAsync("input[value=drawn]"));
        Assert.Equal("equal", await viewer.Page.EvaluateAsync<string>(DifferenceOfPixels, stored));
        Assert.Equal("smooth", await viewer.Page.InputValueAsync("#shading"));
        Assert.Contains("--transfer linear", await viewer.CopiedAsync("copy-command"), StringComparison.Ordinal);

        await viewer.MoveAsync(() => viewer.Page.ClickAsync("#frames-close"));
        Assert.DoesNotContain("--transfer", await viewer.CopiedAsync("copy-command"), StringComparison.Ordinal);
    }

    /// <summary>An OEM that rises by 1 km/s for 100 s is a frame a second.</summary>
    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Trajectory_ToItsEnd_ShowsItsStates()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small);
        await viewer.ShowAllAsync();

        await viewer.MoveAsync(() => viewer.Page.SelectOptionAsync("#folder", "orbit.oem"));
        Assert.Contains("1 of 101, 2024-01-19 12:00:00 UTC", await viewer.Page.TextContentAsync("#frame-label"), StringComparison.Ordinal);
        Assert.Equal(262.6, await viewer.NumberAsync("altitude"), 1e-3); // km: the states are in m
        await viewer.MoveAsync(() => viewer.Page.Locator("#frame-slider").FillAsync("100"));

        Assert.Contains(
            "101 of 101, 2024-01-19 12:01:40 UTC", await viewer.Page.TextContentAsync("#frame-label"), StringComparison.Ordinal);
        Assert.Equal(362.6, await viewer.NumberAsync("altitude"), 1e-3); // km: the states are in m
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task OwnBatchFile_PlayedToItsEnd_ShowsEachState()
    {
        string batch = Path.Combine(server.Folder, "own.tab");
        await File.WriteAllTextAsync(batch, "55289 2e6 0 0 0 0 0 1\n55289.1 2.1e6 0 0 0 0 0 1\n55289.2 2.2e6 0 0 0 0 0 1\n");
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small);
        await viewer.ShowAllAsync();

        await viewer.MoveAsync(() => viewer.Page.SetInputFilesAsync("#batch-file", batch));
        Assert.Equal(262.6, await viewer.NumberAsync("altitude"), 1e-3); // km: the states are in m
        await viewer.Page.ClickAsync("#frame-play");
        await viewer.WaitAsync("() => document.getElementById('frame-label').textContent.startsWith('3 of 3')");
        await viewer.MoveAsync(() => viewer.Page.ClickAsync("#frame-play"));

        Assert.Equal("Play", await viewer.Page.TextContentAsync("#frame-play"));
        await viewer.MoveAsync(() => viewer.Page.Locator("#frame-slider").FillAsync("1"));
        Assert.Equal(362.6, await viewer.NumberAsync("altitude"), 1e-3); // km: the states are in m
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task WrongBatchFile_IsRefusedByItsLine()
    {
        string batch = Path.Combine(server.Folder, "wrong.tab");
        await File.WriteAllTextAsync(batch, "55289 2e6 0 0 0 0 0 1\n55289 2e6\n");
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small);
        await viewer.ShowAllAsync();

        await viewer.Page.SetInputFilesAsync("#batch-file", batch);
        await viewer.Page.Locator("#notice").WaitForAsync();

        Assert.StartsWith("wrong.tab, line 2: ", await viewer.Page.TextContentAsync("#notice"), StringComparison.Ordinal);
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task RecordedFlight_SavedAsBatchFileAndVideo_IsWhatMsisDrawsAndABrowserPlays()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, $"{Small}&altitude=500000");
        await viewer.ShowAllAsync();
        await viewer.Page.ClickAsync("#record");
        for (int step = 0; step < 3; step++)
        {
            await viewer.MoveAsync(() => viewer.Page.ClickAsync("#time-steps button:last-child"));
            await viewer.WaitAsync(
                "count => document.getElementById('record').textContent === `Stop recording (${count})`", step + 2);
        }

        await viewer.Page.ClickAsync("#record");
        string flight = Path.Combine(server.Folder, "flight.tab");
        await File.WriteAllBytesAsync(flight, await viewer.SavedAsync("flight-save"));
        byte[] video = await viewer.SavedAsync("flight-video");

        CommandLineRun run = CommandLineRun.Of(["--batch-file", flight, "--dry-run", "--format", "csv"]);
        Assert.True(run.ExitCode == 0, run.Error);
        string[] lines = run.Output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(4, lines.Length - 1);
        Assert.Equal(
            ["2010-04-22", "2010-04-23", "2010-04-24", "2010-04-25"], lines.Skip(1).Select(line => line.Split(',')[1][..10]));
        Assert.Equal([0x1A, 0x45, 0xDF, 0xA3], video[..4]); // the head of each WebM file (EBML)
        Assert.True(video.Length > 1000, $"a video of {video.Length.ToString(CultureInfo.InvariantCulture)} bytes");
    }

    private static async Task StatusAsync(ViewerPage viewer, string text) =>
        await viewer.WaitAsync("text => document.getElementById('status').textContent === text", text);

    private static Task<string> PixelsAsync(ViewerPage viewer) =>
        viewer.Page.EvaluateAsync<string>("document.getElementById('image').toDataURL()");
}
