using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>Invented detail in the viewer: switched on, it is drawn, marked where it is read, and taken along.</summary>
[Collection(Chromium.Collection)]
public class InventedDetailTests(Chromium chromium, ViewerServer server)
{
    private const string Near = "samples=1&fit=false&width=96&height=64&latitude=-40&longitude=345&altitude=60000";

    /// <summary>Cells of 7.6 km from 60 km: 16 px in the picture, and below 10 px from ten times as high.</summary>
    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task WideCells_AreTold_WithTheSwitchBesideThem()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Near, hasPanel: false);
        Assert.Equal("A finer model would show more.", await viewer.Page.TextContentAsync("#coarse-said"));
        await viewer.MoveAsync(() => viewer.Page.CheckAsync("#refine-here"));
        Assert.StartsWith(
            "Terrain finer than LDEM_4 is invented (seed 1)", await viewer.Page.TextContentAsync("#coarse-said"), StringComparison.Ordinal);
        Assert.True(await viewer.Page.IsCheckedAsync("#refine"));
        Assert.Contains("refine=true", viewer.Page.Url, StringComparison.Ordinal);

        await viewer.MoveAsync(() => viewer.Page.UncheckAsync("#refine-here"));
        Assert.Equal("A finer model would show more.", await viewer.Page.TextContentAsync("#coarse-said"));
        await viewer.ShowAllAsync();
        await viewer.MoveAsync(async () =>
        {
            await viewer.Page.FillAsync("#altitude", "600");
            await viewer.Page.Keyboard.PressAsync("Enter");
        });
        Assert.True(await viewer.Page.IsHiddenAsync("#coarse"));
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Switch_DrawsMarksAndTakesAlongInventedGround()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Near);
        await viewer.ShowAllAsync();
        await viewer.PointAsync(40, 30);
        Assert.EndsWith(" m", await viewer.ReadAsync("Height"), StringComparison.Ordinal);
        Assert.False(await viewer.Page.IsVisibleAsync("#refine-note"));

        await viewer.MoveAsync(() => viewer.Page.CheckAsync("#refine"));
        await viewer.MoveAsync(async () =>
        {
            await viewer.Page.FillAsync("#seed", "12");
            await viewer.Page.Keyboard.PressAsync("Enter");
        });

        await viewer.PointAsync(40, 30);
        Assert.EndsWith(" m, INVENTED", await viewer.ReadAsync("Height"), StringComparison.Ordinal);
        Assert.True(await viewer.Page.IsVisibleAsync("#refine-note"));
        Assert.Contains("--refine 12", await viewer.CopiedAsync("copy-command"), StringComparison.Ordinal);

        await viewer.Page.ReloadAsync();
        await viewer.AtRestAsync();
        await viewer.ShowAllAsync();
        Assert.True(await viewer.Page.IsCheckedAsync("#refine"));
        Assert.Equal(12.0, await viewer.NumberAsync("seed"));
    }
}
