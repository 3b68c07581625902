using Deque.AxeCore.Commons;
using Deque.AxeCore.Playwright;
using Microsoft.Playwright;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>The page as axe-core judges it, from a telephone to 4K, with all that can be open.</summary>
[Collection(Chromium.Collection)]
public class AccessibilityTests(Chromium chromium, ViewerServer server)
{
    private const string Small = "samples=1&fit=false&width=96&height=64";

    /// <summary>Two pins whose rows are as long as they can be: LDEM_1024, invented ground, half a Sun.</summary>
    private const string LongestReadings = """
        () => {
            document.getElementById('readings').dataset.pins = 'AB';
            const texts = { Height: '−9123.45 m, INVENTED', Light: 'penumbra, 53 % of the Sun', Facet: '184319, 368639 NE' };
            for (const cell of document.querySelectorAll('#readings td[data-row]')) {
                cell.textContent = texts[cell.dataset.row] ?? '358.184364° S';
            }
        }
        """;

    /// <summary>Texts that are seen and smaller than 14 px, and parts whose text is wider than they are.</summary>
    private const string SmallOrClipped = """
        () => [...document.querySelectorAll('body *')].filter(part => part.checkVisibility() && !part.closest('.unseen, #rail span')
            && [...part.childNodes].some(node => node.nodeType === 3 && node.textContent.trim()))
            .filter(part => parseFloat(getComputedStyle(part).fontSize) < 14
                || (!part.matches('select, option, textarea') && part.scrollWidth > part.clientWidth + 1 && part.clientWidth > 0))
            .map(part => `${part.tagName} ${part.id} ${getComputedStyle(part).fontSize} ${part.scrollWidth} in ${part.clientWidth}: `
                + part.textContent.trim().slice(0, 40))
        """;

    [RequiresTheory(Part.Chromium, Part.Ldem4)]
    [InlineData(360, 640, 768, 1024)]
    [InlineData(1440, 900, 3840, 2160)]
    public async Task Page_WithAllOpen_HasNoFindingsAndFitsItsWindow(int width, int height, int wider, int higher)
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small, width, height);
        await viewer.ShowAllAsync();
        await viewer.Page.SelectOptionAsync("#folder", "run");
        await viewer.Page.Locator("#timeline").WaitForAsync();
        await viewer.Page.SelectOptionAsync("#layer-choice", "mask");
        await viewer.Page.Locator("#scale").WaitForAsync();

        await viewer.Page.EvaluateAsync(LongestReadings);
        await AssertRightAsync(viewer.Page, width, height);
        await viewer.Page.SetViewportSizeAsync(wider, higher);
        await AssertRightAsync(viewer.Page, wider, higher);
        if (width < 500)
        {
            await viewer.Page.ClickAsync("#help-open"); // of one size in all windows
            AssertNothingFound(await viewer.Page.Locator("#help").RunAxe());
        }
    }

    private static async Task AssertRightAsync(IPage page, int width, int height)
    {
        AssertNothingFound(await page.RunAxe());
        await AssertFitsAsync(page, width, height);
        Assert.Empty(await page.EvaluateAsync<string[]>(SmallOrClipped));
    }

    /// <summary>The page itself never scrolls, and nothing in the panel is cut off at its right.</summary>
    private static async Task AssertFitsAsync(IPage page, int width, int height)
    {
        int[] all = await page.EvaluateAsync<int[]>(
            "() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight]");
        Assert.Equal([width, height], all);
        foreach (string part in new[] { "#panel", "#settings", "#drawer-reading" })
        {
            int[] widths = await page.EvaluateAsync<int[]>(
                "part => [document.querySelector(part).clientWidth, document.querySelector(part).scrollWidth]", part);
            Assert.True(widths[0] == widths[1], $"{part} is {widths[1]} px wide in {widths[0]} of a window of {width} px");
        }
    }

    private static void AssertNothingFound(AxeResult result)
    {
        Assert.NotEmpty(result.Passes);
        Assert.Empty(result.Violations.Select(violation =>
            $"{violation.Id}: {violation.Help}: {string.Join(" | ", violation.Nodes.Select(node => node.Html))}"));
    }
}
