using Deque.AxeCore.Commons;
using Deque.AxeCore.Playwright;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>The page as axe-core judges it, from a telephone to 4K, with all that can be open.</summary>
[Collection(Chromium.Collection)]
public class AccessibilityTests(Chromium chromium, ViewerServer server)
{
    private const string Small = "samples=1&fit=false&width=96&height=64";

    [RequiresTheory(Part.Chromium, Part.Ldem4)]
    [InlineData(360, 640)]
    [InlineData(3840, 2160)]
    public async Task Page_WithAllOpen_HasNoFindingsAndFitsItsWindow(int width, int height)
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small, width, height);
        await viewer.ShowAllAsync();
        await viewer.Page.SelectOptionAsync("#folder", "run");
        await viewer.Page.Locator("#timeline").WaitForAsync();
        await viewer.Page.SelectOptionAsync("#layer-choice", "mask");
        await viewer.Page.Locator("#scale").WaitForAsync();

        AssertNothingFound(await viewer.Page.RunAxe());
        Assert.Equal(width, await viewer.Page.EvaluateAsync<int>("() => document.documentElement.scrollWidth"));
        foreach (string part in new[] { "aside", "#settings", "#reading" })
        {
            Assert.Equal(
                await viewer.Page.EvaluateAsync<int>("part => document.querySelector(part).clientWidth", part),
                await viewer.Page.EvaluateAsync<int>("part => document.querySelector(part).scrollWidth", part));
        }

        if (width < 1000)
        {
            await viewer.Page.ClickAsync("#help-open"); // of one size in all windows
            AssertNothingFound(await viewer.Page.Locator("#help").RunAxe());
        }
    }

    private static void AssertNothingFound(AxeResult result)
    {
        Assert.NotEmpty(result.Passes);
        Assert.Empty(result.Violations.Select(violation =>
            $"{violation.Id}: {violation.Help}: {string.Join(" | ", violation.Nodes.Select(node => node.Html))}"));
    }
}
