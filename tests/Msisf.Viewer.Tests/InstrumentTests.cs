using System.Globalization;
using System.Text;
using System.Text.Json;
using Microsoft.Playwright;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>What planners ask for: search, profile, month of light, contour lines, two times, trajectories, undo, deep links.</summary>
[Collection(Chromium.Collection)]
public class InstrumentTests(Chromium chromium, ViewerServer server)
{
    private const string Small = "names=false&samples=1&fit=false&width=160&height=120&latitude=-9&longitude=358&altitude=400000&mjd=55307";

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Search_ByNameAndByNumbers_GoesThere_AndUndoComesBack()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small);
        await viewer.Page.FocusAsync("#stage");
        await viewer.Page.Keyboard.PressAsync("/");
        await viewer.Page.Keyboard.TypeAsync("mare cris");
        await viewer.WaitAsync(
            "() => document.querySelector('#search-found [aria-selected=true]')?.textContent.startsWith('Mare Crisium')");
        await viewer.MoveAsync(() => viewer.Page.Keyboard.PressAsync("Enter"));
        Assert.Equal(16.2, await viewer.NumberAsync("latitude"), 1.0); // the IAU's Mare Crisium: 16.18 N, 59.1 E
        Assert.Equal(59.1, await viewer.NumberAsync("longitude"), 1.0);

        await viewer.Page.FillAsync("#search-text", "43.3 S, 11.2 W");
        await viewer.MoveAsync(() => viewer.Page.Keyboard.PressAsync("Enter"));
        Assert.Equal(-43.3, await viewer.NumberAsync("latitude"), 1e-6);
        Assert.Equal(348.8, await viewer.NumberAsync("longitude"), 1e-6);
        await viewer.MoveAsync(() => viewer.Page.Keyboard.PressAsync("Control+z"));
        Assert.Equal(59.1, await viewer.NumberAsync("longitude"), 1.0);
        await viewer.MoveAsync(() => viewer.Page.ClickAsync("#undo"));
        Assert.Equal(358.0, await viewer.NumberAsync("longitude"), 1e-6);

        await viewer.Page.FillAsync("#search-text", "apollo11");
        await viewer.MoveAsync(() => viewer.Page.Keyboard.PressAsync("Enter"));
        Assert.Equal(0.67416, await viewer.NumberAsync("latitude"), 1e-4);
        Assert.Equal(23.47314, await viewer.NumberAsync("longitude"), 1e-4);
        await viewer.Page.FillAsync("#search-text", "Tycho");
        await viewer.MoveAsync(() => viewer.Page.Keyboard.PressAsync("Enter"));
        Assert.Equal(-43.2958, await viewer.NumberAsync("latitude"), 1e-4);
        Assert.Equal(348.785, await viewer.NumberAsync("longitude"), 1e-4);

        await viewer.Page.FillAsync("#search-text", "nowhere at all");
        Assert.Contains("Nothing among", await viewer.Page.GetAttributeAsync("#search-text", "title"), StringComparison.Ordinal);
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Pins_GiveAProfileAndAMonthOfLight_AlsoFromALink()
    {
        const string pins = "&pins=-9%2C357.5%2C0%3B-9%2C358.5%2C0";
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, $"{Small}{pins}");
        Assert.Equal("9.000000° S", await viewer.ReadAsync("Latitude", "A"));
        Assert.Equal("–", await viewer.ReadAsync("Incidence", "B"));

        Assert.Matches("^From A to B: 29[.0-9]+ km great-circle distance, ", await viewer.Page.TextContentAsync("#between"));

        await viewer.Page.ClickAsync("#profile");
        await viewer.Page.Locator("#profile-save:enabled").WaitForAsync();
        string[] rows = Encoding.UTF8.GetString(await viewer.SavedAsync("profile-save")).Trim().Split('\n');
        await viewer.Page.ClickAsync("#light");
        await viewer.Page.Locator("#light-plot").WaitForAsync();

        Assert.Equal("distance_m,latitude_deg,longitude_deg,height_m", rows[0]);
        Assert.Equal(402, rows.Length);
        double[] last = [.. rows[^1].Split(',').Select(text => double.Parse(text, CultureInfo.InvariantCulture))];
        Assert.Equal(29_950.0, last[0], 10.0); // one degree of 1737.4 km times the cosine of 9 degrees
        using HttpClient client = new();
        using StringContent request = new(
            """{"frame": {"position": [0, 0, 1e5], "time": 55307}, "points": [[-9, 358.5]]}""", Encoding.UTF8, "application/json");
        using HttpResponseMessage answer = await client.PostAsync(new Uri($"{server.Address}/v1/ground"), request);
        using JsonDocument ground = JsonDocument.Parse(await answer.Content.ReadAsStringAsync());
        Assert.Equal(ground.RootElement.GetProperty("heights")[0].GetDouble(), last[3], 0.01);
        Assert.Matches("in view for [45][0-9].[0-9] % of 30 days", await viewer.Page.TextContentAsync("#light-plot figcaption"));
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task ContoursAndASecondTime_LieOverThePicture_AndComeBackByTheAddress()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(
            chromium, server, $"{Small}&arrow=false&contours=true&second=2010-04-28T00%3A00%3A00Z");
        await viewer.Page.Locator("#other").WaitForAsync();
        await viewer.WaitAsync(
            """
            () => {
                const canvas = document.getElementById('overlay');
                const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
                return data.some((value, index) => index % 4 === 3 && value > 0);
            }
            """);

        Assert.NotEqual(
            await viewer.Page.EvaluateAsync<string>("document.getElementById('image').toDataURL()"),
            await viewer.Page.EvaluateAsync<string>("document.getElementById('other').toDataURL()"));
        Assert.Equal("Left of the line: 2010-04-28T00:00:00Z", await viewer.Page.TextContentAsync("#compare-name"));
        await viewer.Page.ClickAsync("#compare-clear");
        Assert.True(await viewer.Page.IsHiddenAsync("#other"));
    }

    /// <summary>Files that are dropped on the window, and an orbit that is typed.</summary>
    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Trajectories_DroppedOrTyped_AreOnTheTimeLineAndDrawn()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small);
        string oem = await File.ReadAllTextAsync(Path.Combine(server.Folder, "orbit.oem"));
        await viewer.MoveAsync(() => DropAsync(viewer, "mine.oem", oem));
        Assert.StartsWith("1 of 101, 2024-01-19 12:00:00", await viewer.Page.TextContentAsync("#frame-label"), StringComparison.Ordinal);
        Assert.Equal(262.6, await viewer.NumberAsync("altitude"), 1e-3);

        await viewer.MoveAsync(async () =>
        {
            await viewer.Page.FillAsync("#kepler", "{2e6, 0.1, 0, 0, 1.5, 0}");
            await viewer.Page.Keyboard.PressAsync("Enter");
        });
        Assert.StartsWith("1 of 181, ", await viewer.Page.TextContentAsync("#frame-label"), StringComparison.Ordinal);
        Assert.Equal(1800.0 - 1737.4, await viewer.NumberAsync("altitude"), 1e-3); // the periapsis, a (1 - e)
        string before = await viewer.Page.EvaluateAsync<string>("document.getElementById('overlay').toDataURL()");
        await viewer.Page.UncheckAsync("#show-trajectory");
        Assert.NotEqual(before, await viewer.Page.EvaluateAsync<string>("document.getElementById('overlay').toDataURL()"));

        await DropAsync(viewer, "wrong.tab", "55289 2e6\n");
        await viewer.WaitAsync("() => document.getElementById('notice').textContent.startsWith('wrong.tab, line 1: ')");
        await viewer.Page.FillAsync("#kepler", "{1, 2}");
        await viewer.Page.Keyboard.PressAsync("Enter");
        await viewer.WaitAsync("() => document.getElementById('notice').textContent.startsWith('An orbit is six numbers')");
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task SavedImages_AreOfSixteenBitsAndFits()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small);

        byte[] png = await viewer.SavedAsync("save-deep");
        byte[] fits = await viewer.SavedAsync("save-fits");

        Assert.Equal(16, png[24]); // the bit depth of a PNG's head
        Assert.Equal("SIMPLE  =                    T", Encoding.ASCII.GetString(fits[..30]));
        Assert.Contains("RADIANCE-FACTOR", Encoding.ASCII.GetString(fits), StringComparison.OrdinalIgnoreCase);
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Time_PlaysAtItsRate_AndIsWrittenAsIso()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small);
        Assert.Equal("2010-04-21T00:00:00Z", await viewer.Page.InputValueAsync("#calendar"));
        await viewer.MoveAsync(async () =>
        {
            await viewer.Page.FillAsync("#calendar", "2010-04-22 06:00:00");
            await viewer.Page.Keyboard.PressAsync("Enter");
        });
        Assert.Equal(55308.25, await viewer.NumberAsync("mjd"), 1e-8); // days: a millisecond
        Assert.Matches("^Sun [0-9.]+° [NESW]+ at the centre$", await viewer.Page.TextContentAsync("#sun-said"));

        await viewer.Page.SelectOptionAsync("#time-rate", "86400");
        await viewer.Page.ClickAsync("#time-play");
        await viewer.WaitAsync("() => Number(document.getElementById('mjd').value) > 55308.5");
        await viewer.MoveAsync(() => viewer.Page.ClickAsync("#time-play"));
        Assert.Equal("false", await viewer.Page.GetAttributeAsync("#time-play", "aria-pressed"));
    }

    /// <summary>The kernels of the repository cover 1900 to 2050: the picture, its time and the field stay those of before.</summary>
    [RequiresTheory(Part.Chromium, Part.Ldem4)]
    [InlineData("2060-01-01T00:00:00Z")]
    [InlineData("1850-06-01T00:00:00Z")]
    [InlineData("0060-01-01T00:00:00Z")]
    [InlineData("9999-12-31T00:00:00Z")]
    public async Task Time_OutsideTheKernels_IsRefusedWithTheYearsThatTheyCover(string time)
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(
            chromium, server, Small, expected: "the server responded with a status of 4");
        await viewer.Page.FillAsync("#calendar", time);
        await viewer.Page.Keyboard.PressAsync("Enter");

        await viewer.WaitAsync(
            "time => document.getElementById('notice').textContent.includes(`${time} `) && !document.getElementById('notice').hidden",
            time);
        await viewer.AtRestAsync();
        Assert.Matches(
            "the kernels cover 1899-12-31T23:59:19Z to 2050-12-31T[0-9:]*Z", await viewer.Page.TextContentAsync("#notice"));
        Assert.Equal("2010-04-21T00:00:00Z", await viewer.Page.InputValueAsync("#calendar"));
        Assert.Equal(55307.0, await viewer.NumberAsync("mjd"), 1e-8);

        await viewer.MoveAsync(async () =>
        {
            await viewer.Page.FillAsync("#calendar", "2050-06-01T00:00:00Z"); // in their last year
            await viewer.Page.Keyboard.PressAsync("Enter");
        });
        Assert.Equal(69958.0, await viewer.NumberAsync("mjd"), 1e-8); // days from 1858-11-17, by Python's datetime
        Assert.Equal("2050-06-01T00:00:00Z", await viewer.Page.InputValueAsync("#calendar"));
        Assert.True(await viewer.Page.IsHiddenAsync("#notice"));
    }

    /// <summary>What is shown before the first picture, in a wide window, with a server that does not draw.</summary>
    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task FirstSphere_InAWideWindow_IsRound()
    {
        IBrowserContext window = await chromium.WindowAsync(1500, 500, hasTouch: false);
        await using (window)
        {
            IPage page = await window.NewPageAsync();
            await page.AddInitScriptAsync(
                """
                WebSocket.prototype.send = () => { };
                const ask = window.fetch;
                window.fetch = (path, options) => {
                    window.isAsked ||= String(path).includes('/v1/render');
                    return String(path).includes('/v1/render') ? new Promise(() => { }) : ask(path, options);
                };
                """);
            await page.GotoAsync(server.Address);
            await page.WaitForFunctionAsync("() => window.isAsked");

            double[] size = await page.EvaluateAsync<double[]>(
                """
                () => {
                    const image = document.getElementById('image');
                    const pixels = image.getContext('2d').getImageData(0, 0, image.width, image.height).data;
                    const [xs, ys] = [new Set(), new Set()];
                    for (let i = 0; i < pixels.length / 4; i++) {
                        if (pixels[4 * i] > 20) {
                            xs.add(i % image.width);
                            ys.add(Math.floor(i / image.width));
                        }
                    }
                    const box = image.getBoundingClientRect();
                    return [xs.size / image.width * box.width, ys.size / image.height * box.height];
                }
                """);

            Assert.InRange(size[1], 200.0, 500.0);
            Assert.Equal(1.0, size[0] / size[1], 0.03); // a pixel of the small picture to its 200
        }
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Reading_FollowsThePointer_InFiveLines()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, $"{Small}&longitudes=180", hasPanel: false);
        await viewer.PointAsync(40, 30);
        await viewer.Page.Locator("#hover").WaitForAsync();
        string[] lines = [.. await viewer.Page.Locator("#hover p").AllTextContentsAsync()];
        LocatorBoundingBoxResult first = (await viewer.Page.Locator("#hover").BoundingBoxAsync())!;
        await viewer.PointAsync(80, 60);
        LocatorBoundingBoxResult second = (await viewer.Page.Locator("#hover").BoundingBoxAsync())!;

        Assert.Equal(5, lines.Length);
        Assert.Matches(@"^[0-9.]+° S  [0-9.]+° [EW]$", lines[0]);
        Assert.Matches(@"^Height [−0-9]+ m, slope ", lines[1]);
        Assert.Matches(@"^Sun [0-9.]+° (high|below the horizon), azimuth ", lines[2]);
        Assert.Matches(@"^(Lit, incidence|In (the )?shadow|Penumbra|Night)", lines[3]);
        Assert.Matches(@"^Pixel [0-9.]+ k?m, [0-9.]+ km away$", lines[4]);
        Assert.True(second.X > first.X && second.Y > first.Y);
    }

    private static async Task DropAsync(ViewerPage viewer, string name, string text) => await viewer.Page.EvaluateAsync(
        """
        ([name, text]) => {
            const dataTransfer = new DataTransfer();
            dataTransfer.items.add(new File([text], name, { type: 'text/plain' }));
            window.dispatchEvent(new DragEvent('drop', { dataTransfer, cancelable: true }));
        }
        """,
        new[] { name, text });
}
