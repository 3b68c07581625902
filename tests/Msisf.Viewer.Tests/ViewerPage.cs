using System.Globalization;
using Microsoft.Playwright;
using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>The viewer in a window. When it is closed, nothing may have gone wrong, and no other host may have been asked.</summary>
internal sealed class ViewerPage : IAsyncDisposable
{
    /// <summary>Where no graphics card is, each picture of WebGL is read back; Chromium warns of that.</summary>
    private const string StallOfSoftware = "GL Driver Message";

    private readonly IBrowserContext _window;
    private readonly List<string> _troubles = [];

    private ViewerPage(IBrowserContext window, IPage page) => (_window, Page) = (window, page);

    /// <summary>The page.</summary>
    public IPage Page { get; }

    /// <summary>Images that came by the stream.</summary>
    public int Images { get; private set; }

    /// <summary>Messages of the console that belong to the test.</summary>
    public string? Expected { get; init; }

    /// <summary>Opens the viewer with settings in its address, and waits for the picture at rest.</summary>
    public static Task<ViewerPage> OpenAsync(
        Chromium chromium, ViewerServer server, string settings, int width = 1300, int height = 600, string? expected = null,
        bool hasPanel = true, string? before = null, bool hasTouch = false) =>
        OpenAtAsync(chromium, server.Address, settings, width, height, expected, hasPanel, before, hasTouch);

    /// <summary>Opens the page of any server.</summary>
    public static async Task<ViewerPage> OpenAtAsync(
        Chromium chromium, string address, string settings, int width = 1300, int height = 600, string? expected = null,
        bool hasPanel = true, string? before = null, bool hasTouch = false)
    {
        IBrowserContext window = await chromium.WindowAsync(width, height, hasTouch);
        ViewerPage viewer = new(window, await window.NewPageAsync()) { Expected = expected };
        viewer.Page.Console += (_, message) => viewer.Note(
            message.Type is "error" or "warning" && !message.Text.Contains(StallOfSoftware, StringComparison.Ordinal),
            $"{message.Type}: {message.Text}");
        viewer.Page.PageError += (_, error) => viewer.Note(true, error);
        window.Request += (_, request) => viewer.Note(
            !request.Url.StartsWith(address, StringComparison.Ordinal)
                && !request.Url.StartsWith($"blob:{address}", StringComparison.Ordinal),
            $"request to {request.Url}");
        viewer.Page.WebSocket += (_, socket) => socket.FrameReceived += (_, frame) => viewer.Images += frame.Binary is null ? 0 : 1;
        if (before is not null)
        {
            await viewer.Page.AddInitScriptAsync(before);
        }

        await viewer.Page.GotoAsync($"{address}/#{settings}");
        await viewer.AtRestAsync();
        if (hasPanel)
        {
            await viewer.ShowAllAsync();
        }

        return viewer;
    }

    /// <summary>Waits until the picture is there in full size with all its samples.</summary>
    public Task AtRestAsync() => WaitAsync(
        """
        () => {
            const samples = document.getElementById('samples').value;
            const words = samples === 'auto' ? 'samples as needed' : `${samples} samples? a pixel`;
            return new RegExp(`^At rest:.* ${words}`).test(document.getElementById('status').textContent);
        }
        """);

    /// <summary>Waits until a condition holds in the page; if it never does, says how the page stands.</summary>
    public async Task WaitAsync(string condition, object? argument = null)
    {
        try
        {
            await Page.WaitForFunctionAsync(condition, argument);
        }
        catch (TimeoutException exception)
        {
            string page = await Page.EvaluateAsync<string>(
                "['status', 'notice', 'frame-label', 'readings'].map(id => `${id}: ${document.getElementById(id).innerText}`).join('\\n')");
            throw new TimeoutException($"{condition.Trim()}\nof {argument} does not hold; the page has\n{page}", exception);
        }
    }

    /// <summary>Does something that moves the camera, and waits until the new picture is at rest.</summary>
    public async Task MoveAsync(Func<Task> move)
    {
        await Page.EvaluateAsync("document.getElementById('status').textContent = 'The test moves on.'");
        await move();
        await AtRestAsync();
    }

    /// <summary>Puts the mouse on a pixel of the image and waits for what is read there.</summary>
    public async Task PointAsync(int x, int y)
    {
        LocatorBoundingBoxResult box = (await Page.Locator("#picture").BoundingBoxAsync())!;
        double scale = box.Width / await NumberAsync("width");
        await Page.Mouse.MoveAsync((float)(box.X + ((x - 0.5) * scale)), (float)(box.Y + ((y - 0.5) * scale)));
        await WaitAsync(
            "text => document.querySelector('[data-row=Pixel][data-column=here]').textContent === text",
            string.Create(CultureInfo.InvariantCulture, $"{x}, {y}"));
    }

    /// <summary>The text of a reading.</summary>
    public async Task<string> ReadAsync(string row, string column = "here") =>
        (await Page.TextContentAsync($"[data-row='{row}'][data-column='{column}']"))!;

    /// <summary>The number in a field.</summary>
    public async Task<double> NumberAsync(string field) =>
        double.Parse(await Page.InputValueAsync($"#{field}"), CultureInfo.InvariantCulture);

    /// <summary>The bytes that a button saves.</summary>
    public async Task<byte[]> SavedAsync(string button)
    {
        await ShowAllAsync();
        IDownload download = await Page.RunAndWaitForDownloadAsync(() => Page.ClickAsync($"#{button}"));
        return await File.ReadAllBytesAsync((await download.PathAsync())!);
    }

    /// <summary>The text that a button copies.</summary>
    public async Task<string> CopiedAsync(string button)
    {
        await Page.ClickAsync($"#{button}");
        return await Page.InputValueAsync("#copied");
    }

    /// <summary>Shows the panel with all its drawers.</summary>
    public Task ShowAllAsync() => Page.EvaluateAsync(
        """
        () => {
            document.getElementById('panel').hidden = false;
            document.querySelectorAll('details').forEach(drawer => drawer.open = true);
        }
        """);

    /// <summary>Closes the window; fails if something went wrong.</summary>
    public async ValueTask DisposeAsync()
    {
        await _window.CloseAsync();
        lock (_troubles)
        {
            Assert.Empty(_troubles);
        }
    }

    private void Note(bool isTrouble, string text)
    {
        if (isTrouble && (Expected is null || !text.Contains(Expected, StringComparison.Ordinal)))
        {
            lock (_troubles)
            {
                _troubles.Add(text);
            }
        }
    }
}
