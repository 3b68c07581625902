using System.Text.Json;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests.Modules;

/// <summary>wwwroot/js/time.js, text.js, batch.js, commands.js, layers.js, meta.js: values counted by hand.</summary>
[Collection(Chromium.Collection)]
public class TextTests(ModulePage page) : IClassFixture<ModulePage>
{
    private static readonly object Frame = new Dictionary<string, object>
    {
        ["fixed-state"] = new[] { 55289, 2e6, 0, 0, 0, 0, 0, 1 },
        ["fov"] = 40,
        ["width"] = 640,
        ["model"] = "LDEM_64",
        ["reflectance"] = "hapke:w=0.3,b0=1.2",
    };

    [RequiresTheory(Part.Chromium)]
    [InlineData("2010-04-03T00:00:00", 55289.0)]
    [InlineData("2010-04-03", 55289.0)]
    [InlineData("2000-01-01T12:00:00Z", 51544.5)] // J2000
    [InlineData("1858-11-17T00:00", 0.0)] // the zero of the MJD
    public async Task MjdOf_KnownDays_IsTheirNumber(string calendar, double mjd) =>
        Assert.Equal(mjd, (await page.CallAsync("time", "mjdOf", calendar)).GetDouble());

    [RequiresTheory(Part.Chromium)]
    [InlineData("2010-02-30T00:00:00")]
    [InlineData("2010-04")]
    [InlineData("2010-04-03T24:00:00")]
    public async Task MjdOf_NoTimeOfTheCalendar_IsNone(string calendar) =>
        Assert.Equal(JsonValueKind.Null, (await page.CallAsync("time", "mjdOf", calendar)).ValueKind);

    [RequiresFact(Part.Chromium)]
    public async Task CalendarOf_TimeOfTheReadme_IsItsDate() =>
        Assert.Equal("2010-04-06T20:24:00", (await page.CallAsync("time", "calendarOf", 55292.85)).GetString());

    [RequiresTheory(Part.Chromium)]
    [InlineData(-0.0004, "0.000 m")]
    [InlineData(-12.34, "−12.3 m")]
    [InlineData(3956123.4, "3956.1 km")]
    public async Task LengthText_AnySize_HasTheDigitsThatMatter(double metres, string text) =>
        Assert.Equal(text, (await page.CallAsync("text", "lengthText", metres)).GetString());

    [RequiresTheory(Part.Chromium)]
    [InlineData(0, "0 pictures")]
    [InlineData(1, "1 picture")]
    [InlineData(2, "2 pictures")]
    public async Task PicturesText_AnyNumber_IsInItsNumber(int count, string text) =>
        Assert.Equal(text, (await page.CallAsync("text", "picturesText", count)).GetString());

    [RequiresTheory(Part.Chromium)]
    [InlineData(1, "1 sample a pixel")]
    [InlineData(4, "4 samples a pixel")]
    [InlineData("auto", "samples as needed")]
    public async Task SamplesText_AnyNumber_IsInItsNumber(object count, string text) =>
        Assert.Equal(text, (await page.CallAsync("text", "samplesText", count)).GetString());

    [RequiresTheory(Part.Chromium)]
    [InlineData(1234.4, "1234 m²")]
    [InlineData(26781234.0, "26.78 km²")]
    [InlineData(3.793e13, "37930000 km²")]
    public async Task AreaText_AnySize_HasTheDigitsThatMatter(double squareMetres, string text) =>
        Assert.Equal(text, (await page.CallAsync("text", "areaText", squareMetres)).GetString());

    [RequiresFact(Part.Chromium)]
    public async Task ReadBatch_CommentsAndColumns_GivesStatesInTheOrderOfALine()
    {
        JsonElement plain = await page.CallAsync("batch", "readBatch", "# a comment\n55289 1 2 3 0 0 0 1 # over the origin\r\n\n");
        JsonElement named = await page.CallAsync(
            "batch", "readBatch", "qw,qx,qy,qz,time,x,y,z\n1,0,0,0,2010-04-03T12:00:00Z,1e6,2,-3\n");

        Assert.Equal("[[55289,1,2,3,0,0,0,1]]", plain.GetRawText());
        Assert.Equal("[[55289.5,1000000,2,-3,0,0,0,1]]", named.GetRawText());
    }

    [RequiresTheory(Part.Chromium)]
    [InlineData("55289 1 2 3 0 0 0 1\n55289 1 2 3 0 0 0\n", "line 2: a state is eight numbers")]
    [InlineData("time,lat,lon,height\n", "line 1: the page reads columns for time, x, y, z")]
    [InlineData("# nothing\n", "there is no state in the file")]
    public async Task ReadBatch_WrongFile_SaysWhichLine(string text, string beginning) =>
        Assert.StartsWith(beginning, await page.ErrorOfAsync("batch", "readBatch", text), StringComparison.Ordinal);

    [RequiresFact(Part.Chromium)]
    public async Task CommandLine_OptionsWithSpecialLetters_AreQuotedAndTheModelIsItsResolution()
    {
        JsonElement text = await page.CallAsync(
            "commands", "commandLine", Frame, new[] { new { name = "LDEM_64", pixels_per_degree = 64 } });

        Assert.Equal(
            "msis --renderer native --fixed-state '{55289,2000000,0,0,0,0,0,1}' --fov 40 --width 640 --reflectance 'hapke:w=0.3,b0=1.2' "
                + "--res 64",
            text.GetString());
    }

    [RequiresTheory(Part.Chromium)]
    [InlineData(null, "--ldem 'my models/LDEM_4.LBL' --res 4")] // the server draws the coarsest model of the whole Moon
    [InlineData("LDEM_64", "--res 64")] // one that msis finds by itself
    [InlineData("LDEM_80S_80M+LDEM_64", "--ldem LDEM_80S_80M.LBL --ldem input/LDEM_64.LBL")]
    public async Task CommandLine_ModelsOfTheServer_AreNamedWhereMsisNeedsIt(string? model, string ending)
    {
        object[] models =
        [
            new { name = "LDEM_80S_80M", whole_moon = false, path = "LDEM_80S_80M.LBL", ldem = "LDEM_80S_80M.LBL" },
            new { name = "LDEM_4", whole_moon = true, pixels_per_degree = 4, path = "my models/LDEM_4.LBL", ldem = "my models/LDEM_4.LBL" },
            new { name = "LDEM_64", whole_moon = true, pixels_per_degree = 64, path = "input/LDEM_64.LBL", ldem = (string?)null },
        ];
        Dictionary<string, object> frame = new() { ["fixed-state"] = new[] { 1, 2, 3, 0, 0, 0, 0, 1 } };
        if (model is not null)
        {
            frame["model"] = model;
        }

        JsonElement text = await page.CallAsync("commands", "commandLine", frame, models);

        string words = text.GetString()!;
        Assert.Equal(ending, words[(words.IndexOf("}'", StringComparison.Ordinal) + 3)..]);
    }

    [RequiresFact(Part.Chromium)]
    public async Task ColourOf_EndsOfTheScale_AreThoseOfViridis()
    {
        Assert.Equal("[68,1,84]", (await page.CallAsync("layers", "colourOf", 0)).GetRawText());
        Assert.Equal("[253,231,37]", (await page.CallAsync("layers", "colourOf", 1.5)).GetRawText());
    }

    [RequiresFact(Part.Chromium)]
    public async Task MetaRows_NumbersOfAMetaFile_AreInTheirShortestForm()
    {
        const string xml = """
            <MSISRendering><GeneralInformation>
            <SimulationTime><MJD>+5.528900000000000E+004</MJD><UTC>2010-04-03T00:00:00Z</UTC></SimulationTime>
            <CameraPosition unit="m">
            <Vector3D x="+2.000000000000000E+006" y="-1.500000000000000E+000" z="+0.000000000000000E+000"/></CameraPosition>
            <FOV unit="deg">40</FOV></GeneralInformation><PixelInformation><Pixel/><Pixel/></PixelInformation></MSISRendering>
            """;

        JsonElement rows = await page.CallAsync("meta", "metaRows", xml);

        Assert.Equal(
            """[["Time","55289, 2010-04-03T00:00:00Z"],["Camera position","x 2000000, y -1.5, z 0 m"],"""
                + """["Field of view","40 deg"],["Pixels in the meta file","2"]]""",
            rows.GetRawText());
    }
}
