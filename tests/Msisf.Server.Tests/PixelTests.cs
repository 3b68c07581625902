using System.Globalization;
using System.Text.Json;
using System.Xml.Linq;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>POST /v1/pixels and /v1/points tell what the meta file of the same frame tells.</summary>
public sealed class PixelTests(RunningServer server) : IClassFixture<RunningServer>
{
    private const string Frame = """
        "position": [3, 6, 120000], "time": 55289.25, "off-nadir": [10, 30], "width": 96, "height": 64, "fov": 50, "grid": 16
        """;

    /// <summary>Degrees and m: the meta file has 15 digits, of angles that are differences of large vectors.</summary>
    private const double AsExactAsTheMetaFile = 1e-7;

    [RequiresTheory(Part.Ldem4)]
    [InlineData("\"sun\": \"point\"")]
    [InlineData("\"sun\": \"disc\"")]
    [InlineData("\"shading\": \"smooth\"")]
    public async Task Pixels_AreThose_OfTheMetaFile(string option)
    {
        XDocument meta = XDocument.Parse(System.Text.Encoding.UTF8.GetString(
            await server.RenderAsync($"{Frame}, {option}, \"surface\": \"terrain\"", "application/xml")));
        XElement[] expected = [.. meta.Descendants("Pixel")];
        string pixels = string.Join(", ", expected.Select(pixel => $"[{pixel.Attribute("h")!.Value}, {pixel.Attribute("v")!.Value}]"));

        JsonElement[] points = await AskAsync("pixels", $"{Frame}, {option}", pixels, "points");

        Assert.NotEmpty(expected);
        Assert.Equal(expected.Length, points.Length);
        for (int i = 0; i < points.Length; i++)
        {
            XElement terrain = expected[i];
            Near(Number(terrain, "lat"), points[i], "latitude");
            Near(Number(terrain, "lon"), points[i], "longitude");
        }
    }

    /// <summary>Of a few pixels only the parts of the image around them are drawn; that changes no number.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("\"width\": 480, \"height\": 320, \"fov\": 50, \"samples\": 4")]
    [InlineData(
        "\"camera\": {\"width\": 480, \"height\": 320, \"focal-length-px\": 450, \"distortion\": {\"model\": \"opencv\", \"k1\": -0.1}}")]
    public async Task PixelsOneByOne_AreThose_OfTheWholeImage(string camera)
    {
        string frame = $$"""
            "position": [-20, 42, 150000], "time": 55289.25, "off-nadir": [10, 30], "sun": "disc", "shading": "smooth", {{camera}}
            """;
        string[] pixels = [.. Enumerable.Range(0, 48).Select(
            i => FormattableString.Invariant($"[{1 + (i % 8 * 65)}, {1 + (i / 8 * 60)}]"))];

        JsonElement[] whole = await AskAsync("pixels", frame, string.Join(", ", pixels), "points");

        Assert.Contains(whole, point => point.ValueKind == JsonValueKind.Object && point.GetProperty("lit").GetString() == "penumbra");
        for (int i = 0; i < pixels.Length; i += 3)
        {
            JsonElement alone = (await AskAsync("pixels", frame, pixels[i], "points"))[0];
            Assert.Equal(whole[i].ValueKind, alone.ValueKind);
            foreach (JsonProperty number in whole[i].EnumerateObject().Where(member => member.Value.ValueKind == JsonValueKind.Number))
            {
                double other = alone.GetProperty(number.Name).GetDouble();
                double rounding = AsExactAsTheMetaFile * Math.Max(1.0, Math.Abs(other));
                Assert.True(
                    Math.Abs(number.Value.GetDouble() - other) <= rounding, $"{pixels[i]}: {number.Name} {number.Value}, alone {other}");
            }

            Assert.Equal(whole[i].GetProperty("facet").GetRawText(), alone.GetProperty("facet").GetRawText());
        }
    }

    /// <summary>A pixel that is asked for by its place is found again.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task Points_LeadBack_ToTheirPixels()
    {
        JsonElement[] points = await AskAsync("pixels", Frame, "[20.25, 30.5], [48, 32], [90, 60]", "points");
        string[] fields = ["latitude", "longitude", "height"];
        string places = string.Join(
            ", ", points.Select(point => $"[{string.Join(", ", fields.Select(field => point.GetProperty(field).GetRawText()))}]"));

        JsonElement[] pixels = await AskAsync("points", Frame, places, "pixels");

        Assert.Equal(20.25, pixels[0].GetProperty("x").GetDouble(), 6);
        Assert.Equal(30.5, pixels[0].GetProperty("y").GetDouble(), 6);
        Assert.Equal(32.0, pixels[1].GetProperty("y").GetDouble(), 6);
    }

    [RequiresFact(Part.Ldem4)]
    public async Task Points_SayWhy_TheyAreHidden()
    {
        const string looksAtNadir = """
            "position": [0, 0, 200000], "time": "2010-04-03T00:00:00Z", "width": 100, "height": 100, "fov": 60
            """;

        JsonElement[] pixels = await AskAsync("points", looksAtNadir, "[0, 0], [0, 180], [0, 90], [0, 1], [0, 5]", "pixels");

        Assert.True(pixels[0].GetProperty("visible").GetBoolean());
        Assert.Equal(JsonValueKind.Null, pixels[0].GetProperty("hidden_by").ValueKind);
        Assert.Equal(50.5, pixels[0].GetProperty("x").GetDouble(), 6);
        Assert.Equal("limb", pixels[1].GetProperty("hidden_by").GetString()); // straight below, on the far side
        Assert.Equal("outside the image", pixels[2].GetProperty("hidden_by").GetString());
        Assert.True(pixels[3].GetProperty("visible").GetBoolean());
        Assert.Equal("outside the image", pixels[4].GetProperty("hidden_by").GetString());
    }

    /// <summary>The half of the Moon that the Sun sees is lit, whatever the terrain.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task Sun_StandsHigh_WhereTheMoonIsLit()
    {
        JsonElement below = await RunningServer.JsonOf(await server.Client.GetAsync("/v1/sun?utc=2010-04-03T00:00:00Z"));
        double latitude = below.GetProperty("sub_solar_point").GetProperty("latitude").GetDouble();
        double longitude = below.GetProperty("sub_solar_point").GetProperty("longitude").GetDouble();

        JsonElement there = await RunningServer.JsonOf(await server.Client.GetAsync(FormattableString.Invariant(
            $"/v1/sun?mjd=55289&latitude={latitude}&longitude={longitude}")));
        JsonElement[] points = await AskAsync(
            "points",
            Frame,
            FormattableString.Invariant($"[{latitude:R}, {longitude:R}], [{-latitude:R}, {longitude - 180.0:R}]"),
            "pixels");

        Assert.Equal(90.0, there.GetProperty("elevation").GetDouble(), 4);
        Assert.InRange(there.GetProperty("distance").GetDouble(), 1.45e11, 1.53e11); // m: 1 au and a little
        Assert.True(points[0].GetProperty("lit").GetBoolean());
        Assert.False(points[1].GetProperty("lit").GetBoolean());
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("pixels", "[0, 1]", "outside the image of 96 x 64 px")]
    [InlineData("pixels", "[1e308, 1]", "outside the image of 96 x 64 px")]
    [InlineData("pixels", "[1]", "'pixels', entry 1: the numbers [x, y] are needed")]
    [InlineData("points", "[91, 0]", "latitude")]
    [InlineData("points", "[0, 0, 1e300]", "the height")]
    [InlineData("points", "[0, \"a\"]", "'points', entry 1")]
    public async Task WrongPoint_IsRefused(string path, string point, string words)
    {
        using HttpResponseMessage answer = await server.PostAsync($"/v1/{path}", $"{{\"frame\": {{{Frame}}}, \"{path}\": [{point}]}}");

        Assert.Equal(System.Net.HttpStatusCode.BadRequest, answer.StatusCode);
        Assert.Contains(words, (await RunningServer.JsonOf(answer)).GetProperty("detail").GetString(), StringComparison.Ordinal);
    }

    /// <summary>As for a picture: a camera without shutter or scan has no use for it.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("pixels", "[1, 1]")]
    [InlineData("points", "[0, 0]")]
    public async Task Motion_OfACameraThatTakesNoTime_IsRefused(string path, string point)
    {
        using HttpResponseMessage answer = await server.PostAsync(
            $"/v1/{path}", $"{{\"frame\": {{{Frame}, \"motion\": [1600, 0, 0, 0, 0, 0]}}, \"{path}\": [{point}]}}");

        Assert.Equal(System.Net.HttpStatusCode.BadRequest, answer.StatusCode);
        Assert.Contains("--motion", (await RunningServer.JsonOf(answer)).GetProperty("detail").GetString(), StringComparison.Ordinal);
    }

    private async Task<JsonElement[]> AskAsync(string path, string frame, string points, string result)
    {
        using HttpResponseMessage answer = await server.PostAsync($"/v1/{path}", $"{{\"frame\": {{{frame}}}, \"{path}\": [{points}]}}");
        JsonElement json = await RunningServer.JsonOf(answer);
        Assert.True(answer.IsSuccessStatusCode, json.ToString());
        return [.. json.GetProperty(result).EnumerateArray()];
    }

    private static void Near(double expected, JsonElement point, string name) =>
        Assert.Equal(expected, point.GetProperty(name).GetDouble(), AsExactAsTheMetaFile);

    private static double Number(XElement element, string name) =>
        double.Parse((element.Attribute(name) ?? element.Descendants().Attributes(name).First()).Value, CultureInfo.InvariantCulture);
}
