using Microsoft.Playwright;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>What lies over the picture: no name shines through it, the map of the Moon leaves pins free, plots come into view.</summary>
[Collection(Chromium.Collection)]
public class PlaceOfBoxesTests(Chromium chromium, ViewerServer server)
{
    private const string FullDisc = "samples=1&arrow=false&altitude=4200000&latitude=-20&longitude=40";
    private const string Small = "names=false&samples=1&fit=false&width=160&height=120&latitude=-9&longitude=358&altitude=400000&mjd=55307";

    /// <summary>How many pixels of the overlay, on which there are only names, lie under boxes; and how many there are at all.</summary>
    private const string NamesDrawn = """
        () => {
            const canvas = document.getElementById('overlay');
            const page = canvas.getBoundingClientRect();
            const unit = canvas.width / page.width;
            const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
            const drawn = (left, top, width, height) => {
                let count = 0;
                for (let y = Math.max(Math.ceil(top), 0); y < Math.min(top + height, canvas.height); y++) {
                    for (let x = Math.max(Math.ceil(left), 0); x < Math.min(left + width, canvas.width); x++) {
                        count += data[4 * (y * canvas.width + x) + 3] > 0 ? 1 : 0;
                    }
                }
                return count;
            };
            const boxes = [...document.querySelectorAll('#search, #overview, #compass, #panel, #ground > *')]
                .map(box => box.getBoundingClientRect()).filter(box => box.width > 0);
            const under = boxes.map(box => drawn(
                (box.left - page.left) * unit, (box.top - page.top) * unit, box.width * unit, box.height * unit));
            return [under.reduce((sum, count) => sum + count, 0), drawn(0, 0, canvas.width, canvas.height), boxes.length];
        }
        """;

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Names_AreNotUnderWhatLiesOverThePicture()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(
            chromium, server, FullDisc, hasPanel: false, expected: "Multiple readback operations"); // the test reads the marks again
        await AssertFreeAsync(6);
        await viewer.Page.ClickAsync("[data-drawer=camera]");
        await AssertFreeAsync(7);

        async Task AssertFreeAsync(int boxes)
        {
            await viewer.WaitAsync($"() => ({NamesDrawn})()[0] === 0");
            int[] drawn = await viewer.Page.EvaluateAsync<int[]>(NamesDrawn);
            Assert.True(drawn[1] > 1000, "there are names");
            Assert.True(drawn[2] >= boxes, $"{drawn[2]} boxes lie over the picture");
        }
    }

    /// <summary>Pins are set where the map is when it is shown: at its first place, then at its second one.</summary>
    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task MapOfTheMoon_GivesWayToPins()
    {
        const string view = "names=false&samples=1&latitude=-20&longitude=10&altitude=500000";
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, view, hasPanel: false);
        List<(float X, float Y)> pins = [];
        foreach (string place in new[] { "below", "above" })
        {
            LocatorBoundingBoxResult box = (await viewer.Page.Locator("#overview").BoundingBoxAsync())!;
            pins.Add((box.X + 30, box.Y + 30));
            Assert.Equal(place, await viewer.Page.GetAttributeAsync("#corner", "data-place"));
            await SwitchMapAsync();
            await viewer.Page.Mouse.ClickAsync(box.X + 30, box.Y + 30);
            await viewer.WaitAsync(
                "pins => document.getElementById('readings').dataset.pins === pins", place == "below" ? "A" : "AB");
            await SwitchMapAsync();
            foreach ((float x, float y) in pins)
            {
                await viewer.WaitAsync(
                    "([x, y]) => document.elementFromPoint(x, y).id !== 'overview'", new double[] { x, y });
            }
        }

        Assert.Equal("beside", await viewer.Page.GetAttributeAsync("#corner", "data-place"));

        Task SwitchMapAsync() => viewer.Page.EvaluateAsync("document.getElementById('show-overview').click()");
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task ProfileAndLight_ComeIntoView()
    {
        const string pins = "&pins=-9%2C357.5%2C0%3B-9%2C358.5%2C0";
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, $"{Small}{pins}", hasPanel: false);
        await viewer.Page.ClickAsync("[data-drawer=reading]");
        foreach (string name in new[] { "profile", "light" })
        {
            await viewer.Page.ClickAsync($"#{name}");
            await viewer.WaitAsync(
                """
                name => {
                    const [plot, panel] = [`${name}-plot`, 'settings'].map(id => document.getElementById(id).getBoundingClientRect());
                    return plot.height > 100 && plot.top >= panel.top - 1 && plot.bottom <= panel.bottom + 1;
                }
                """,
                name);
        }
    }

    /// <summary>In Tycho before its sunrise of 2010-04-22: the offer leads to a time at which the middle is lit.</summary>
    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Night_OffersTheNextLight()
    {
        const string night = "names=false&samples=1&fit=false&width=160&height=120&latitude=-43.3&longitude=348.8&altitude=30000&mjd=55308";
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, night);
        Assert.True(await viewer.Page.IsVisibleAsync("#next-light"));
        await viewer.MoveAsync(() => viewer.Page.ClickAsync("#next-light"));

        Assert.True(await viewer.Page.IsHiddenAsync("#next-light"));
        Assert.InRange(await viewer.NumberAsync("mjd"), 55308.2, 55312.0);
        await viewer.PointAsync(80, 60);
        Assert.Equal("lit", await viewer.ReadAsync("Light"));
    }
}
