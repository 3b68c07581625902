using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Microsoft.Playwright;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>A person's way through the viewer: fly, point, read, compare with the meta file, take it along, come back.</summary>
[Collection(Chromium.Collection)]
public class WayTests(Chromium chromium, ViewerServer server)
{
    private const string OverClavius = "samples=1&latitude=-50&longitude=345&altitude=900000";
    private const string Small = "samples=4&fit=false&width=160&height=120&latitude=-58&longitude=346&altitude=300000&tilt=20&heading=30";

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task FlyPointAndRead_NumbersAreThoseOfTheMetaFile_AlsoAfterAReload()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, OverClavius);
        LocatorBoundingBoxResult box = (await viewer.Page.Locator("#picture").BoundingBoxAsync())!;
        (float x, float y) = (box.X + (box.Width / 2), box.Y + (box.Height / 2));
        await viewer.MoveAsync(async () =>
        {
            await viewer.Page.Mouse.MoveAsync(x, y);
            await viewer.Page.Mouse.DownAsync();
            await viewer.Page.Mouse.MoveAsync(x + 60, y + 40, new MouseMoveOptions { Steps = 4 });
            await viewer.Page.Mouse.UpAsync();
        });
        Assert.InRange(await viewer.NumberAsync("latitude"), -49.9, -40.0); // the ground follows the mouse down, the camera goes north
        Assert.InRange(await viewer.NumberAsync("longitude"), 335.0, 344.9);
        await viewer.MoveAsync(() => viewer.Page.Mouse.WheelAsync(0, -300));
        Assert.Equal(900.0 / Math.Pow(1.15, 3), await viewer.NumberAsync("altitude"), 5.0);
        double before = await viewer.NumberAsync("latitude");
        await viewer.MoveAsync(() => viewer.Page.Keyboard.PressAsync("KeyW"));
        Assert.True(await viewer.NumberAsync("latitude") > before);

        await viewer.PointAsync(150, 200);
        XElement pixel = PixelOf(await viewer.SavedAsync("save-meta"), 150, 200);
        await viewer.PointAsync(150, 200); // the mouse was on the button
        await AssertReadAsync(viewer, pixel);
        string[] texts = await TextsAsync(viewer);

        await viewer.Page.ReloadAsync();
        await viewer.AtRestAsync();
        await viewer.PointAsync(150, 200);
        Assert.Equal(texts, await TextsAsync(viewer));
        Assert.True(viewer.Images >= 3, $"{viewer.Images} images came by the stream");
    }

    /// <summary>
    /// The rate that a person sees while the mouse turns the Moon; in the long form the one that is promised (docs/viewer.md).
    /// </summary>
    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Drag_512x512_ShowsEnoughPicturesASecond()
    {
        (int leastSteps, int mostSteps) = TestLength.IsLong ? (600, 600) : (30, 3000); // a busy machine takes longer to show any
        await using ViewerPage viewer = await ViewerPage.OpenAsync(
            chromium, server, $"{OverClavius}&fit=false&width=512&height=512", 1100, 700);
        LocatorBoundingBoxResult box = (await viewer.Page.Locator("#picture").BoundingBoxAsync())!;
        (float x, float y) = (box.X + (box.Width / 2), box.Y + (box.Height / 2));
        List<int> rates = [];
        string last = string.Empty;
        await viewer.MoveAsync(async () =>
        {
            await viewer.Page.Mouse.MoveAsync(x, y);
            await viewer.Page.Mouse.DownAsync();
            for (int step = 0; step < leastSteps || (rates.Count < 4 && step < mostSteps); step++)
            {
                await viewer.Page.Mouse.MoveAsync(x + (100.0F * float.Sin(0.1F * step)), y + (100.0F * float.Cos(0.07F * step)));
                await Task.Delay(TimeSpan.FromMilliseconds(16));
                string text = await viewer.Page.Locator("#status").InnerTextAsync();
                Match status = Regex.Match(text, "^Moving: 512 × 512, ([0-9]+) pictures? in the last second");
                if (status.Success)
                {
                    rates.Add(int.Parse(status.Groups[1].Value, CultureInfo.InvariantCulture));
                    last = text;
                }
            }

            await viewer.Page.Mouse.UpAsync();
        });

        int least = TestLength.IsLong ? 15 : 1;
        int[] warm = [.. rates.Skip(rates.Count / 2).Order()]; // before, the server's code is compiled
        int median = warm[warm.Length / 2];
        Assert.True(median >= least, $"{median} pictures a second, {least} are promised; the last: {last}");
    }

    [RequiresFact(Part.Chromium, Part.Ldem4, Part.Numpy)]
    public async Task CommandBatchLineAndPython_AllMakeTheSavedImage()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small);
        byte[] image = await viewer.SavedAsync("save-image");
        string command = await viewer.CopiedAsync("copy-command");
        string batch = Path.Combine(server.Folder, "copied.tab");
        await File.WriteAllTextAsync(batch, await viewer.CopiedAsync("copy-batch"));
        string python = await viewer.CopiedAsync("copy-python");

        string[] words = command["msis ".Length..].Split(' ');
        int state = Array.IndexOf(words, "--fixed-state");
        words[state + 1] = words[state + 1].Trim('\'');
        Assert.Equal(image, Drawn("command", words));
        Assert.Equal(image, Drawn("batch", [.. words[..state], .. words[(state + 2)..], "--batch-file", batch]));
        ChildRun.Of(TestParts.Python!, ["-"], server.Folder, python, new Dictionary<string, string>
        {
            ["PYTHONPATH"] = Path.Combine(TestParts.RepositoryRoot, "clients", "python"),
            ["PYTHONDONTWRITEBYTECODE"] = "1",
        }).Succeeded();
        Assert.Equal(
            PngPixels.Read(new MemoryStream(image)).ChannelParts(0),
            PngPixels.Read(Path.Combine(server.Folder, "moon.png")).ChannelParts(0));
        Assert.Equal(await viewer.Page.EvaluateAsync<string>("navigator.clipboard.readText()"), python);
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task KeyboardAlone_ReadsPinsMeasuresAndSwitches()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, $"{Small}&mjd=55292.85", 360, 700);
        await viewer.Page.Keyboard.PressAsync("Tab"); // the picture is first
        await viewer.Page.Keyboard.PressAsync("c");
        await viewer.Page.Keyboard.PressAsync("Shift+ArrowLeft");
        await viewer.Page.Keyboard.PressAsync("ArrowDown");
        await WaitForPixelAsync(viewer, "60, 61");
        await viewer.Page.Keyboard.PressAsync("p");
        await viewer.Page.Keyboard.PressAsync("Shift+ArrowRight");
        await WaitForPixelAsync(viewer, "80, 61");
        await viewer.Page.Keyboard.PressAsync("p");

        Assert.Equal("60, 61", await viewer.ReadAsync("Pixel", "A"));
        Assert.Equal("80, 61", await viewer.ReadAsync("Pixel", "B"));
        double rise = Number(await viewer.ReadAsync("Height", "B")) - Number(await viewer.ReadAsync("Height", "A"));
        string between = (await viewer.Page.TextContentAsync("#between"))!;
        Assert.Contains(rise.ToString("+0.00;−0.00", CultureInfo.InvariantCulture), between, StringComparison.Ordinal);
        // km: written with two decimals, of places with six
        Assert.Equal(GroundKilometres(await PlaceAsync(viewer, "A"), await PlaceAsync(viewer, "B")), Number(between.Split(' ')[4]), 0.002);

        Assert.Equal(
            await viewer.Page.EvaluateAsync<int>("() => document.getElementById('drawer-reading').clientWidth"),
            await viewer.Page.EvaluateAsync<int>("() => document.getElementById('drawer-reading').scrollWidth"));

        foreach ((string key, string field) in new[] { ("g", "show-grid"), ("t", "show-terminator") })
        {
            string before = await viewer.Page.EvaluateAsync<string>("document.getElementById('overlay').toDataURL()");
            await viewer.Page.Keyboard.PressAsync(key);
            Assert.True(await viewer.Page.IsCheckedAsync($"#{field}"));
            Assert.NotEqual(before, await viewer.Page.EvaluateAsync<string>("document.getElementById('overlay').toDataURL()"));
        }

        await viewer.Page.Keyboard.PressAsync("?");
        Assert.True(await viewer.Page.IsVisibleAsync("#help"));
        await viewer.Page.Keyboard.PressAsync("Escape");
        await viewer.MoveAsync(() => viewer.Page.Keyboard.PressAsync("."));
        Assert.Equal(55292.85 + (1.0 / 24.0), await viewer.NumberAsync("mjd"), 1e-7); // days: 9 ms
        await viewer.Page.Keyboard.PressAsync("u");
        Assert.Equal("–", await viewer.ReadAsync("Pixel", "A"));
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task CameraInTheGround_SaysItInTheWordsOfTheCommandLine_AndComesOut()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small, expected: "400 (Bad Request)");

        await viewer.Page.FillAsync("#altitude", "-8.9");
        await viewer.Page.Keyboard.PressAsync("Enter");
        await viewer.Page.Locator("#notice").WaitForAsync();
        string words = (await viewer.Page.TextContentAsync("#notice"))!;
        CommandLineRun run = CommandLineRun.Of(
            ["--renderer", "native", "--position", "-58,346,-8900", "--time", "55308", "--batch", "--output-dir", server.Folder]);
        await viewer.MoveAsync(async () =>
        {
            await viewer.Page.FillAsync("#altitude", "200");
            await viewer.Page.Keyboard.PressAsync("Enter");
        });

        Assert.Contains(words.Split(':')[0], run.Error, StringComparison.Ordinal);
        Assert.StartsWith("the camera is inside the Moon", words, StringComparison.Ordinal);
        Assert.False(await viewer.Page.IsVisibleAsync("#notice"));
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task SunOverTheCentre_IsThatOfTheServer()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(
            chromium, server, "samples=1&fit=false&width=64&height=64&latitude=-20&longitude=30&altitude=200000");
        await viewer.WaitAsync("() => document.getElementById('sun-elevation').textContent !== '–'");
        using HttpClient client = new();
        string sun = await client.GetStringAsync(new Uri($"{server.Address}/v1/sun?mjd=55308&latitude=-20&longitude=30"));
        using System.Text.Json.JsonDocument json = System.Text.Json.JsonDocument.Parse(sun);

        foreach (string angle in new[] { "elevation", "azimuth" })
        {
            Assert.Equal(
                json.RootElement.GetProperty(angle).GetDouble(),
                Number((await viewer.Page.TextContentAsync($"#sun-{angle}"))!), 0.0006);
        }
    }

    private static async Task AssertReadAsync(ViewerPage viewer, XElement pixel)
    {
        // Each bound is a little more than half of the last digit that the page shows.
        XElement place = pixel.Element("SelenographicCoordinates")!;
        string latitude = await viewer.ReadAsync("Latitude");
        Assert.Equal(Math.Abs(Value(place.Attribute("lat")!.Value)), Number(latitude), 0.6e-6);
        Assert.EndsWith(Value(place.Attribute("lat")!.Value) < 0.0 ? "S" : "N", latitude, StringComparison.Ordinal);
        Assert.Equal(Value(place.Attribute("lon")!.Value), Number(await viewer.ReadAsync("Longitude E")), 0.6e-6);
        Assert.Equal(Of("Height"), Number(await viewer.ReadAsync("Height")), 0.006);
        Assert.Equal(Of("IncidenceAngle"), Number(await viewer.ReadAsync("Incidence")), 0.6e-4);
        Assert.Equal(Of("EmissionAngle"), Number(await viewer.ReadAsync("Emission")), 0.6e-4);
        Assert.Equal(Of("PhaseAngle"), Number(await viewer.ReadAsync("Phase")), 0.6e-4);
        Assert.Equal(Of("IlluminationDirection"), Number(await viewer.ReadAsync("Light from")), 0.6e-3);
        Assert.Equal(Of("Range") / 1000.0, Number(await viewer.ReadAsync("Distance")), 0.6e-3);
        Assert.Equal(pixel.Element("Illumination")!.Attribute("state")!.Value, await viewer.ReadAsync("Light"));
        XElement facet = pixel.Element("Facet")!;
        Assert.Equal(
            $"{facet.Attribute("line")!.Value}, {facet.Attribute("sample")!.Value} {facet.Attribute("half")!.Value}",
            await viewer.ReadAsync("Facet"));

        double Of(string name) => Value(pixel.Element(name)!.Value);
    }

    private static async Task<string[]> TextsAsync(ViewerPage viewer) =>
        [.. await viewer.Page.Locator("#readings td[data-column=here]").AllTextContentsAsync()];

    private static async Task WaitForPixelAsync(ViewerPage viewer, string pixel) => await viewer.WaitAsync(
        "text => document.querySelector('[data-row=Pixel][data-column=here]').textContent === text", pixel);

    private static async Task<(double Latitude, double Longitude)> PlaceAsync(ViewerPage viewer, string pin) =>
        (-Number(await viewer.ReadAsync("Latitude", pin)), Number(await viewer.ReadAsync("Longitude E", pin)));

    /// <summary>By the haversine, on the reference sphere.</summary>
    private static double GroundKilometres((double Latitude, double Longitude) a, (double Latitude, double Longitude) b)
    {
        double Half(double degrees) => Math.Pow(Math.Sin(double.DegreesToRadians(degrees) / 2.0), 2);
        double h = Half(b.Latitude - a.Latitude) + (Math.Cos(double.DegreesToRadians(a.Latitude))
            * Math.Cos(double.DegreesToRadians(b.Latitude)) * Half(b.Longitude - a.Longitude));
        return 2.0 * 1737.4 * Math.Atan2(Math.Sqrt(h), Math.Sqrt(1.0 - h));
    }

    private byte[] Drawn(string name, IReadOnlyList<string> words)
    {
        CommandLineRun run = CommandLineRun.Of(
            [.. words, "--batch", "--output-dir", Path.Combine(server.Folder, name), "--output-name", name]);
        Assert.True(run.ExitCode == 0, run.Error);
        return File.ReadAllBytes(Path.Combine(server.Folder, name, $"{name}.png"));
    }

    private static XElement PixelOf(byte[] meta, int h, int v)
    {
        using StringReader text = new(Encoding.UTF8.GetString(meta));
        using System.Xml.XmlReader reader = System.Xml.XmlReader.Create(
            text, new System.Xml.XmlReaderSettings { DtdProcessing = System.Xml.DtdProcessing.Ignore, XmlResolver = null });
        return XDocument.Load(reader).Descendants("Pixel").Single(
            pixel => (int)pixel.Attribute("h")! == h && (int)pixel.Attribute("v")! == v);
    }

    private static double Value(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    /// <summary>The number at the start of a text of the page, which has true minus signs.</summary>
    private static double Number(string text) =>
        Value(new string([.. text.Replace('−', '-').TakeWhile(letter => letter is '-' or '.' || char.IsAsciiDigit(letter))]));
}
