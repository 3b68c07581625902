using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>The page's address: what a reload brings back, and addresses that are wrong. Also what cannot be copied.</summary>
[Collection(Chromium.Collection)]
public class AddressTests(Chromium chromium, ViewerServer server)
{
    private const string Small = "names=false&samples=1&fit=false&width=96&height=96";

    /// <summary>
    /// How much of the limb the grid's lines cover: of 180 points on the circle of a sphere of 1737.4 km, 6000 km from the camera, with a
    /// field of view of 40 degrees, the share with a line within 1 px.
    /// </summary>
    private const string LimbDrawn = """
        () => {
            const canvas = document.getElementById('overlay');
            const radius = canvas.width / 2 / Math.tan(20 * Math.PI / 180) * Math.tan(Math.asin(1737.4 / 6000));
            const { data, width } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
            const isDrawn = (x, y) => data[4 * (y * width + x) + 3] > 0;
            const drawn = Array.from({ length: 180 }, (_, i) => i * Math.PI / 90).filter(angle => {
                const x = Math.round(canvas.width / 2 + radius * Math.cos(angle));
                const y = Math.round(canvas.height / 2 + radius * Math.sin(angle));
                return [-1, 0, 1].some(dx => [-1, 0, 1].some(dy => isDrawn(x + dx, y + dy)));
            });
            return drawn.length / 180;
        }
        """;

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Reload_BringsBackLayersMarksAndPins()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, $"{Small}&altitude=4262600");
        await viewer.Page.SelectOptionAsync("#layer-choice", "mask");
        await viewer.Page.Locator("#layer-opacity").FillAsync("40");
        await viewer.Page.SelectOptionAsync("#catalogue", "craters.csv");
        await viewer.Page.CheckAsync("#show-grid");
        await viewer.Page.UncheckAsync("#show-arrow");
        foreach (int pixel in new[] { 45, 60 })
        {
            await viewer.PointAsync(pixel, 40);
            await viewer.Page.Mouse.DownAsync();
            await viewer.Page.Mouse.UpAsync();
        }

        await viewer.WaitAsync("() => document.getElementById('readings').dataset.pins === 'AB'");
        string[] pins = await PinsAsync(viewer);
        Assert.Equal(1.0, await viewer.Page.EvaluateAsync<double>(LimbDrawn)); // the grid's lines end at a line, not in the sky

        await viewer.Page.ReloadAsync();
        await viewer.Page.Locator("#layer").WaitForAsync();

        Assert.Equal("mask", await viewer.Page.InputValueAsync("#layer-choice"));
        Assert.Equal(40.0, await viewer.NumberAsync("layer-opacity"));
        Assert.Equal("0.4", await viewer.Page.EvaluateAsync<string>("document.getElementById('layer').style.opacity"));
        Assert.Equal("craters.csv", await viewer.Page.InputValueAsync("#catalogue"));
        Assert.True(await viewer.Page.IsCheckedAsync("#show-grid"));
        Assert.False(await viewer.Page.IsCheckedAsync("#show-arrow"));
        Assert.Equal(pins, await PinsAsync(viewer));
        Assert.Contains("60, 40", pins);
    }

    /// <summary>Each view at rest is an entry of the browser's history; marks and pins change the entry that is there.</summary>
    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Back_GoesToTheViewBefore_AndForwardComesBack()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, $"{Small}&latitude=10&altitude=900000");
        int before = await viewer.Page.EvaluateAsync<int>("history.length");
        await viewer.MoveAsync(() => LookAsync("latitude", "20"));
        await viewer.Page.CheckAsync("#show-grid");
        await viewer.MoveAsync(() => LookAsync("altitude", "500"));
        Assert.Equal(before + 2, await viewer.Page.EvaluateAsync<int>("history.length"));

        await viewer.MoveAsync(async () => await viewer.Page.GoBackAsync());
        Assert.Equal(20.0, await viewer.NumberAsync("latitude"), 1e-6);
        Assert.Equal(900.0, await viewer.NumberAsync("altitude"), 1e-6);
        Assert.True(await viewer.Page.IsCheckedAsync("#show-grid"));
        await viewer.MoveAsync(async () => await viewer.Page.GoBackAsync());
        Assert.Equal(10.0, await viewer.NumberAsync("latitude"), 1e-6);
        Assert.False(await viewer.Page.IsCheckedAsync("#show-grid"));
        await viewer.MoveAsync(async () => await viewer.Page.GoForwardAsync());
        Assert.Equal(20.0, await viewer.NumberAsync("latitude"), 1e-6);
        Assert.Equal(before + 2, await viewer.Page.EvaluateAsync<int>("history.length"));

        async Task LookAsync(string field, string number)
        {
            await viewer.Page.FillAsync($"#{field}", number);
            await viewer.Page.Keyboard.PressAsync("Enter");
        }
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task WrongAddress_IsToldAndDrawnWithoutIt()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(
            chromium, server, $"{Small}&model=LDEM_5&latitude=95&seed=1.5&lat=3&layer=hight&grid=maybe", expected: "400 (Bad Request)");

        Assert.EndsWith(
            ": layer=hight, grid=maybe, model=LDEM_5, latitude=95, seed=1.5, lat=3.",
            await viewer.Page.TextContentAsync("#notice"), StringComparison.Ordinal);
        Assert.True(await viewer.Page.IsVisibleAsync("#notice"));
        Assert.Equal(string.Empty, await viewer.Page.InputValueAsync("#model"));
        Assert.StartsWith("LDEM_4: cells of 7.581 km", await viewer.Page.TextContentAsync("#model-said"), StringComparison.Ordinal);
        Assert.Equal(0.0, await viewer.NumberAsync("latitude"));

        await viewer.Page.EvaluateAsync("text => location.hash = text", $"{Small}&reflectance=mirror");
        await viewer.WaitAsync("() => document.getElementById('status').textContent === 'Not drawn.'");
        Assert.Contains("'mirror' is not known", await viewer.Page.TextContentAsync("#notice"), StringComparison.Ordinal);
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task ForbiddenClipboard_SelectsTheTextToCopy()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small);
        await ForbidAsync("{ writeText: () => Promise.reject(new DOMException('denied', 'NotAllowedError')) }");
        await viewer.Page.ClickAsync("#readings-copy");
        await AssertSelectedAsync("{\n");

        await ForbidAsync("undefined"); // as on a page of another computer without https
        await viewer.Page.ClickAsync("#copy-command");
        await AssertSelectedAsync("msis ");

        Task ForbidAsync(string clipboard) => viewer.Page.EvaluateAsync(
            $"() => Object.defineProperty(navigator, 'clipboard', {{ value: {clipboard}, configurable: true }})");

        async Task AssertSelectedAsync(string start)
        {
            await viewer.WaitAsync("start => getSelection().toString().startsWith(start)", start);
            Assert.StartsWith("The browser forbids copying.", await viewer.Page.TextContentAsync("#status"), StringComparison.Ordinal);
        }
    }

    private static async Task<string[]> PinsAsync(ViewerPage viewer) =>
        [.. await viewer.Page.Locator("#readings td:is([data-column=A], [data-column=B])").AllTextContentsAsync()];
}
