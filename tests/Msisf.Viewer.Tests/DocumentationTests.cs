using Microsoft.Playwright;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>The screenshots of docs/viewer.md; MSISF_WRITE_DOCS=1 takes them anew.</summary>
[Collection(Chromium.Collection)]
public class DocumentationTests(Chromium chromium, ViewerServer server)
{
    /// <summary>
    /// Levels of 255 by which the mean of a square may be another one: its letters, or one sample a pixel instead of nine.
    /// </summary>
    private const double AlikeLevels = 12.0;

    /// <summary>Squares that may be others: those of words.</summary>
    private const int OtherSquares = 6;

    private static readonly bool IsWriting = Environment.GetEnvironmentVariable("MSISF_WRITE_DOCS") == "1";

    private static readonly string Samples = IsWriting ? "samples=9" : "samples=1";

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Screenshots_OfTheScenesOfThePage_AreThere()
    {
        const string overTycho = "latitude=-30&longitude=352&altitude=1100000&tilt=24&heading=180&mjd=55309.2";
        await using ViewerPage viewer = await ViewerPage.OpenAsync(
            chromium, server, $"{Samples}&{overTycho}&grid=true", 1280, 800, hasPanel: false);
        await viewer.PointAsync(400, 400);
        await viewer.Page.Mouse.DownAsync();
        await viewer.Page.Mouse.UpAsync();
        await viewer.PointAsync(520, 450);
        await viewer.Page.Mouse.DownAsync();
        await viewer.Page.Mouse.UpAsync();
        await viewer.WaitAsync("() => document.getElementById('between').textContent.startsWith('From A to B')");
        await viewer.PointAsync(330, 480);
        await TakeAsync(viewer, "viewer.png");

        await viewer.Page.ClickAsync("[data-drawer=show]");
        await viewer.Page.UncheckAsync("#show-grid");
        await viewer.Page.CheckAsync("#show-contours");
        await viewer.Page.SelectOptionAsync("#layer-choice", "height");
        await viewer.Page.Locator("#layer").WaitForAsync();
        await viewer.PointAsync(330, 480);
        await TakeAsync(viewer, "viewer-height.png");
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Screenshot_OfATelephone_IsThere()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(
            chromium, server, $"{Samples}&altitude=5500000", 360, 720, hasPanel: false);
        await viewer.PointAsync(200, 250);
        await TakeAsync(viewer, "viewer-telephone.png");
    }

    /// <summary>Takes a screenshot; that of the docs has its size, and the page shows it.</summary>
    private static async Task TakeAsync(ViewerPage viewer, string name)
    {
        await viewer.Page.EvaluateAsync("() => document.getElementById('status').style.visibility = 'hidden'"); // has times
        Assert.True(await viewer.Page.EvaluateAsync<bool>(
            "() => document.getElementById('settings').scrollWidth <= document.getElementById('settings').clientWidth"));
        string path = Path.Combine(TestParts.RepositoryRoot, "docs", "images", name);
        byte[] taken = await viewer.Page.ScreenshotAsync(new PageScreenshotOptions { Animations = ScreenshotAnimations.Disabled });
        if (IsWriting)
        {
            await File.WriteAllBytesAsync(path, taken);
        }

        AssertAlike(PngPixels.Read(path), PngPixels.Read(new MemoryStream(taken)), name);
        string docs = await File.ReadAllTextAsync(Path.Combine(TestParts.RepositoryRoot, "docs", "viewer.md"));
        Assert.Contains($"images/{name}", docs, StringComparison.Ordinal);
    }

    /// <summary>
    /// The screenshot of the docs is that of the page as it is now, but for fonts, times in milliseconds and the samples of a pixel: in
    /// squares of 40 px their means are alike.
    /// </summary>
    private static void AssertAlike(PngPixels docs, PngPixels now, string name)
    {
        const int side = 40; // px: a line of text is half as high, so that other letters hardly count
        Assert.Equal((docs.Width, docs.Height), (now.Width, now.Height));
        int others = 0;
        for (int top = 0; top < docs.Height; top += side)
        {
            for (int left = 0; left < docs.Width; left += side)
            {
                others += Math.Abs(Mean(docs, left, top, side) - Mean(now, left, top, side)) > AlikeLevels ? 1 : 0;
            }
        }

        Assert.True(
            others <= OtherSquares, $"{others} squares of {name} are other ones than on the page: take it anew (MSISF_WRITE_DOCS=1)");
    }

    private static double Mean(PngPixels image, int left, int top, int side)
    {
        (int right, int bottom) = (Math.Min(left + side, image.Width), Math.Min(top + side, image.Height));
        double sum = 0.0;
        for (int y = top; y < bottom; y++)
        {
            for (int x = left; x < right; x++)
            {
                sum += image[x, y, 1]; // green
            }
        }

        return sum / ((right - left) * (bottom - top));
    }
}
