using System.Globalization;
using System.Text;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>Paths of several points: their length, the area that they enclose, their profile, their place in the address.</summary>
[Collection(Chromium.Collection)]
public class PathTests(Chromium chromium, ViewerServer server)
{
    private const string View = "names=false&samples=1&fit=false&width=160&height=120&latitude=0&longitude=0&altitude=400000&mjd=55307";

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Path_OfThreePoints_HasLengthAreaAndProfile()
    {
        // One degree is 30.32335 km; a right angle with such legs has the excess 2 atan(tan² 0.5°): 459.776 km²
        const string pins = "&path=true&pins=0%2C0%2C0%3B0%2C1%2C0%3B1%2C1%2C0";
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, $"{View}{pins}");
        Assert.Equal(
            "From A to C over 3 points: 60.647 km great-circle distance, +0.00 m in height. Closed to A they enclose 459.78 km².",
            await viewer.Page.TextContentAsync("#between"));
        Assert.Equal("Pin C", await viewer.Page.TextContentAsync("#readings thead th:last-child"));

        await viewer.Page.ClickAsync("#profile");
        await viewer.Page.Locator("#profile-save:enabled").WaitForAsync();
        string[] rows = Encoding.UTF8.GetString(await viewer.SavedAsync("profile-save")).Trim().Split('\n');
        Assert.Equal([30_323.0, 0.0, 1.0], Rounded(rows[201])); // the corner is half way
        Assert.Equal([60_647.0, 1.0, 1.0], Rounded(rows[401]));

        await viewer.PointAsync(40, 30);
        await viewer.Page.Mouse.DownAsync();
        await viewer.Page.Mouse.UpAsync();
        await viewer.WaitAsync("() => document.getElementById('between').textContent.startsWith('From A to D over 4 points')");
        await viewer.Page.ReloadAsync();
        await viewer.AtRestAsync();
        Assert.StartsWith("From A to D over 4 points", await viewer.Page.TextContentAsync("#between"), StringComparison.Ordinal);
        await viewer.ShowAllAsync();
        await viewer.Page.ClickAsync("#unpin");
        Assert.StartsWith("From A to C over 3 points", await viewer.Page.TextContentAsync("#between"), StringComparison.Ordinal);
        await viewer.Page.UncheckAsync("#path");
        await viewer.Page.ClickAsync("#unpin");
        Assert.DoesNotContain("pins=", viewer.Page.Url, StringComparison.Ordinal);
    }

    private static double[] Rounded(string row) => [.. row.Split(',')[..3].Select(
        (text, index) => Math.Round(double.Parse(text, CultureInfo.InvariantCulture), index == 0 ? 0 : 6))];
}
