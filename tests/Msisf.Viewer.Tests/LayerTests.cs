using System.Globalization;
using System.Text.Json;
using Microsoft.Playwright;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>Layers as colours, craters, and two pictures over each other.</summary>
[Collection(Chromium.Collection)]
public class LayerTests(Chromium chromium, ViewerServer server)
{
    private const string Small = "names=false&samples=1&fit=false&width=160&height=120&latitude=-9&longitude=358&altitude=400000&mjd=55307";

    private const string ColourAt = """
        ([x, y]) => [...document.getElementById('layer').getContext('2d').getImageData(x - 1, y - 1, 1, 1).data]
        """;

    /// <summary>Whether something is drawn within a pixel of a place of the picture, which may lie outside it.</summary>
    private const string IsMarked = """
        ([x, y]) => {
            const canvas = document.getElementById('overlay');
            const unit = canvas.width / document.getElementById('image').width;
            const [left, top] = [(x - 0.5) * unit, (y - 0.5) * unit];
            if (left < 1 || top < 1 || left > canvas.width - 2 || top > canvas.height - 2) {
                return true;
            }
            const copy = Object.assign(document.createElement('canvas'), { width: 3, height: 3 });
            copy.getContext('2d').drawImage(canvas, 1 - Math.round(left), 1 - Math.round(top));
            const data = copy.getContext('2d').getImageData(0, 0, 3, 3).data;
            return data.some((value, index) => index % 4 === 3 && value > 40);
        }
        """;

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task LayersAsColours_HaveTheColourOfWhatIsRead()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small);
        await viewer.PointAsync(100, 40);

        await ChooseAsync(viewer, "mask");
        int[] expected = await viewer.ReadAsync("Light") switch
        {
            "lit" => [253, 231, 37, 255],
            "shadow" => [59, 82, 139, 255],
            _ => [68, 1, 84, 255],
        };
        Assert.Equal(expected, await viewer.Page.EvaluateAsync<int[]>(ColourAt, new[] { 100, 40 }));

        await ChooseAsync(viewer, "height");
        string[] ends = [.. await viewer.Page.Locator("#scale div span").AllTextContentsAsync()];
        double height = Number(await viewer.ReadAsync("Height"));
        Assert.InRange(height, Metres(ends[0]) - 60.0, Metres(ends[2]) + 60.0);
        Assert.InRange(Metres(ends[2]) - Metres(ends[0]), 500.0, 15_000.0); // the Moon's heights span 20 km; a view has a part of them

        foreach (string layer in new[] { "slope", "incidence", "depth" })
        {
            await ChooseAsync(viewer, layer);
            Assert.Equal(3, await viewer.Page.Locator("#scale div span").CountAsync());
        }

        await viewer.Page.SelectOptionAsync("#layer-choice", string.Empty);
        Assert.True(await viewer.Page.IsHiddenAsync("#scale"));
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task CatalogueOfCraters_DrawsOnThePicture()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small);
        string before = await OverlayAsync(viewer);

        await viewer.Page.SelectOptionAsync("#catalogue", "craters.csv");
        await viewer.WaitAsync("before => document.getElementById('overlay').toDataURL() !== before", before);
        await viewer.Page.SelectOptionAsync("#catalogue", string.Empty);
        await viewer.WaitAsync("before => document.getElementById('overlay').toDataURL() === before", before);
    }

    /// <summary>At rest the rim is the ellipse of the answer's meta file, and the cross of a landmark is at its pixel.</summary>
    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task CratersAndLandmarksAtRest_AreWhereTheAnswerHasThem()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small);
        await viewer.PointAsync(100, 40);
        await viewer.Page.SelectOptionAsync("#catalogue", "craters.csv");
        IResponse response = await viewer.Page.RunAndWaitForResponseAsync(
            async () => await viewer.Page.SelectOptionAsync("#landmarks", "landmarks.csv"),
            answer => answer.Request.PostData?.Contains("\"landmarks\"", StringComparison.Ordinal) == true);
        JsonElement meta = (await response.JsonAsync())!.Value;
        JsonElement crater = meta.GetProperty("CraterInformation").GetProperty("Crater")[0];
        JsonElement landmark = meta.GetProperty("LandmarkInformation").GetProperty("Landmark")[0];
        double turn = double.DegreesToRadians(crater.GetProperty("turn").GetDouble());
        double major = crater.GetProperty("semiMajor").GetDouble();
        double[][] marked =
        [
            [Of(crater, "h") + (major * Math.Cos(turn)), Of(crater, "v") + (major * Math.Sin(turn))],
            [Of(crater, "h") - (major * Math.Cos(turn)), Of(crater, "v") - (major * Math.Sin(turn))],
            [Of(landmark, "h") + 2.0, Of(landmark, "v")],
            [Of(landmark, "h"), Of(landmark, "v") - 2.0],
        ];

        Assert.Equal("Peak", landmark.GetProperty("name").GetString());
        foreach (double[] place in marked)
        {
            await viewer.WaitAsync(IsMarked, place);
        }

        static double Of(JsonElement element, string name) => element.GetProperty(name).GetDouble();
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task OwnPicture_OverTheDrawnOne_IsCutByTheSliderAndBlinks()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small);
        string own = Path.Combine(server.Folder, "own.png");
        await File.WriteAllBytesAsync(own, await viewer.SavedAsync("save-image"));
        await viewer.Page.SetInputFilesAsync("#compare-file", own);
        await viewer.Page.Locator("#other").WaitForAsync();

        Assert.Equal(
            await viewer.Page.EvaluateAsync<string>("document.getElementById('image').toDataURL()"),
            await viewer.Page.EvaluateAsync<string>("document.getElementById('other').toDataURL()"));
        await viewer.Page.Locator("#compare-slider").FillAsync("25");
        Assert.Equal("inset(0px 75% 0px 0px)", await viewer.Page.EvaluateAsync<string>("document.getElementById('other').style.clipPath"));
        await viewer.Page.FocusAsync("#stage");
        await viewer.Page.Keyboard.PressAsync("b");
        await viewer.WaitAsync("() => document.getElementById('other').hidden");
        await viewer.WaitAsync("() => !document.getElementById('other').hidden");
        await viewer.Page.ClickAsync("#compare-clear");
        Assert.True(await viewer.Page.IsHiddenAsync("#other"));
        Assert.Equal("false", await viewer.Page.GetAttributeAsync("#blink", "aria-pressed"));
    }

    private static async Task ChooseAsync(ViewerPage viewer, string layer)
    {
        await viewer.Page.SelectOptionAsync("#layer-choice", layer);
        await viewer.Page.Locator("#layer").WaitForAsync(new LocatorWaitForOptions { State = WaitForSelectorState.Visible });
    }

    private static Task<string> OverlayAsync(ViewerPage viewer) =>
        viewer.Page.EvaluateAsync<string>("document.getElementById('overlay').toDataURL()");

    private static double Metres(string text) => Number(text) * (text.EndsWith("km", StringComparison.Ordinal) ? 1000.0 : 1.0);

    private static double Number(string text) => double.Parse(
        new string([.. text.Replace('−', '-').TakeWhile(letter => letter is '-' or '.' || char.IsAsciiDigit(letter))]),
        CultureInfo.InvariantCulture);
}
