using System.Globalization;
using System.Net;
using System.Net.WebSockets;
using System.Text;
using System.Text.Json;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>What the viewer asks beside images: heights of the ground, light over time, trajectories, images with depth.</summary>
public sealed class ViewerAnswerTests(RunningServer server) : IClassFixture<RunningServer>
{
    private const double Radius = 1_737_400.0;

    /// <summary>Low Sun: parts of it are in shadow.</summary>
    private const string Frame = """
        "position": [3, 6, 120000], "time": 55289.25, "off-nadir": [10, 30], "width": 96, "height": 64, "fov": 50
        """;

    [RequiresFact(Part.Ldem4)]
    public async Task Ground_IsAsHigh_AsThePixelsThatShowIt()
    {
        JsonElement[] pixels = [.. (await AskAsync("pixels", $"{{\"frame\": {{{Frame}}}, \"pixels\": [[10, 10], [48, 32], [90, 60]]}}"))
            .GetProperty("points").EnumerateArray()];
        string places = string.Join(", ", pixels.Select(pixel => $"[{Text(pixel, "latitude")}, {Text(pixel, "longitude")}]"));

        JsonElement[] heights = [.. (await AskAsync("ground", $"{{\"frame\": {{{Frame}}}, \"points\": [{places}]}}"))
            .GetProperty("heights").EnumerateArray()];

        Assert.Equal(3, heights.Length);
        // m: latitude and longitude have few digits
        Assert.All(pixels.Zip(heights), pair => Assert.Equal(Of(pair.First, "height"), pair.Second.GetDouble(), 1e-3));
    }

    /// <summary>What is named as standing before the Sun is ground: the ray has its height there.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("facet")]
    [InlineData("smooth")]
    public async Task ShadedAt_OfAPixelInShadow_IsWhereTheRayToTheSunMeetsGround(string shading)
    {
        const string low = """
            "position": [-43, 348.6, 200000], "time": 55309.2, "off-nadir": [0, 0], "width": 64, "height": 48, "fov": 60
            """;
        string pixels = string.Join(", ", Enumerable.Range(0, 48 * 16).Select(i => $"[{1 + (i % 16 * 4)}, {1 + (i / 16)}]"));
        JsonElement[] all = [.. (await AskAsync("pixels", $"{{\"frame\": {{{low}, \"shading\": \"{shading}\"}}, \"pixels\": [{pixels}]}}"))
            .GetProperty("points").EnumerateArray()];
        JsonElement[] shaded = [.. all.Where(point => point.GetProperty("shaded_at") is { ValueKind: JsonValueKind.Number } at
            && at.GetDouble() > 0.0)];
        Vector3D sun = await SunAsync(55309.2);

        Assert.Contains(all, point => point.GetProperty("lit").GetString() == "lit");
        Assert.All(all, point => Assert.True(
            point.GetProperty("lit").GetString() == "shadow" || point.GetProperty("shaded_at").ValueKind == JsonValueKind.Null));
        Assert.True(shaded.Length > 10, $"{shaded.Length} of {all.Length} are in a shadow");
        foreach (JsonElement point in shaded.Take(40))
        {
            double[] position = [.. point.GetProperty("position").EnumerateArray().Select(number => number.GetDouble())];
            Vector3D start = new(position[0], position[1], position[2]);
            Vector3D stands = start + (Of(point, "shaded_at") * (sun - start).Normalized());
            double latitude = double.RadiansToDegrees(Math.Atan2(stands.Z, double.Hypot(stands.X, stands.Y)));
            double longitude = double.RadiansToDegrees(Math.Atan2(stands.Y, stands.X));
            JsonElement there = await AskAsync("ground", string.Create(
                CultureInfo.InvariantCulture, $"{{\"frame\": {{{low}}}, \"points\": [[{latitude:R}, {longitude:R}]]}}"));
            Assert.Equal(stands.Length - Radius, there.GetProperty("heights")[0].GetDouble(), 0.5);
        }
    }

    [RequiresFact(Part.Ldem4)]
    public async Task SunPath_HasTheSunOfEachTime()
    {
        JsonElement path = JsonDocument.Parse(
            await server.Client.GetStringAsync("/v1/sun/path?from=55300&to=55302&count=5")).RootElement;

        Assert.Equal(0.5, Of(path, "step"));
        foreach ((int index, JsonElement position) in path.GetProperty("positions").EnumerateArray().Index())
        {
            Vector3D expected = await SunAsync(55300.0 + (0.5 * index));
            Assert.Equal(expected.X, position[0].GetDouble(), 1.0);
            Assert.Equal(expected.Y, position[1].GetDouble(), 1.0);
            Assert.Equal(expected.Z, position[2].GetDouble(), 1.0);
        }
    }

    /// <summary>The hours with all or none of the Sun are those in which /v1/points says that light reaches the place.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task MonthOfLight_AgreesWithSingleRays()
    {
        const string place = "[-58.6, 345.3]";
        JsonElement month = await AskAsync("light", $"{{\"frame\": {{{Frame}}}, \"points\": [{place}]}}");
        double from = Of(month, "from");
        double[] parts = [.. month.GetProperty("places")[0].GetProperty("parts").EnumerateArray().Select(part => part.GetDouble())];

        Assert.Equal(721, parts.Length);
        Assert.Equal(55289.25 - 15.0, from, Rounding.OfPlaces);
        Assert.InRange(Of(month.GetProperty("places")[0], "lit"), 0.3, 0.7);
        for (int hour = 0; hour < parts.Length; hour += 24)
        {
            string time = (from + (hour / 24.0)).ToString("R", CultureInfo.InvariantCulture);
            string then = Frame.Replace("55289.25", time, StringComparison.Ordinal);
            JsonElement point = (await AskAsync("points", $"{{\"frame\": {{{then}}}, \"points\": [{place}]}}")).GetProperty("pixels")[0];
            Assert.True(parts[hour] is > 0.0 and < 1.0 || point.GetProperty("lit").GetBoolean() == parts[hour] > 0.5, $"hour {hour}");
        }
    }

    [RequiresFact(Part.Ldem4)]
    public async Task Trajectory_OfTextAndOfAnOrbit_HasItsStates()
    {
        JsonElement text = await AskAsync(
            "trajectory", """{"name": "a.tab", "text": "55289 2e6 0 0 0 0 0 1\n55290 2.1e6 0 0 0 0 0 1\n"}""");
        JsonElement orbit = await AskAsync(
            "trajectory", """{"frame": {"kepler-set": [2e6, 0.1, 0, 0, 0, 0], "epoch": 55289}, "times": [55289, 55289.05]}""");
        double[] first = [.. orbit.GetProperty("states")[0].EnumerateArray().Select(number => number.GetDouble())];

        Assert.Equal("[[55289,2000000,0,0,0,0,0,1],[55290,2100000,0,0,0,0,0,1]]", text.GetProperty("states").GetRawText());
        Assert.Equal(2, orbit.GetProperty("states").GetArrayLength());
        Assert.Equal(2e6 * 0.9, Math.Sqrt((first[1] * first[1]) + (first[2] * first[2]) + (first[3] * first[3])), 1e-3); // the periapsis
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("trajectory", """{"name": "own.tab", "text": "55289 2e6\n"}""", "own.tab, line 1: ")]
    [InlineData("trajectory", """{"text": "55289"}""", "'name' and 'text'")]
    [InlineData("trajectory", """{"frame": {}, "times": []}""", "'times' is a list of 1 to 1001")]
    [InlineData("light", """{"frame": {"position": [0, 0, 1e5], "time": 55289}, "points": []}""", "'points' has 0 places")]
    [InlineData("light", """{"frame": {"position": [0, 0, 1e5], "time": 55289, "refine": 1}, "points": [[0, 0]]}""", "'refine' is for")]
    [InlineData("ground", """{"frame": {"position": [0, 0, 1e5], "time": 55289}, "points": [[91, 0]]}""", "91")]
    public async Task WrongRequest_IsRefusedInWords(string path, string request, string words)
    {
        using HttpResponseMessage answer = await server.PostAsync($"/v1/{path}", request);
        string text = await answer.Content.ReadAsStringAsync();

        Assert.Equal(HttpStatusCode.BadRequest, answer.StatusCode);
        Assert.Contains(words, text, StringComparison.Ordinal);
        Assert.DoesNotContain("/tmp", text, StringComparison.Ordinal);
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("from=55300&to=55299&count=5")]
    [InlineData("from=55300&to=55302&count=2.5")]
    [InlineData("from=now&to=55302&count=5")]
    public async Task WrongSunPath_IsRefused(string query)
    {
        using HttpResponseMessage answer = await server.Client.GetAsync($"/v1/sun/path?{query}");

        Assert.Equal(HttpStatusCode.BadRequest, answer.StatusCode);
    }

    [RequiresFact(Part.Ldem4)]
    public async Task Names_AreThere_TheLargestFirst()
    {
        JsonElement[] names = [.. JsonDocument.Parse(await server.Client.GetStringAsync("/v1/names")).RootElement
            .GetProperty("names").EnumerateArray()];

        Assert.True(names.Length > 9000);
        Assert.Equal("Oceanus Procellarum", names[0].GetProperty("name").GetString());
        Assert.Equal(names.OrderByDescending(name => Of(name, "diameter")), names);
        Assert.Contains(names, name => name.GetProperty("name").GetString() == "Tycho");
        Assert.Contains(names, name => name.GetProperty("name").GetString() == "Apollo 11");
    }

    /// <summary>A message of a stream with layers is the image and, behind it, the layer, as both are asked for alone.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task StreamWithLayers_SendsTheImageAndItsDepth()
    {
        const string camera = "\"width\": 61, \"height\": 47, \"fov\": 40";
        const string depth = "\"layers\": [\"depth\"], \"layers-precision\": \"single\"";
        const string state = "\"fixed-state\": [55289, 1.9e6, 0, 0, 0, 0, 0, 1]";
        using ClientWebSocket socket = new();
        await socket.ConnectAsync(new Uri($"ws{server.Address[4..]}/v1/stream"), default);
        await SendAsync($"{{\"frame\": {{{camera}, {depth}}}, \"format\": \"u8+layers\"}}");
        await ReceiveAsync();
        await SendAsync($"{{\"number\": 7, {state}}}");
        byte[] message = await ReceiveAsync();

        byte[] image = await server.RenderAsync($"{state}, {camera}", "application/octet-stream");
        byte[] layer = await server.RenderAsync($"{state}, {camera}, {depth}", "application/octet-stream");
        Assert.Equal(61 * 47, image.Length);
        Assert.Equal(4 * 61 * 47, layer.Length);
        Assert.Equal([.. image, .. layer], message[16..]);
        Assert.Equal([7, 0, 0, 0, 61, 0, 0, 0, 47, 0, 0, 0], message[4..16]);

        Task SendAsync(string json) => socket.SendAsync(Encoding.UTF8.GetBytes(json), WebSocketMessageType.Text, true, default);

        async Task<byte[]> ReceiveAsync()
        {
            using MemoryStream all = new();
            byte[] buffer = new byte[65536];
            ValueWebSocketReceiveResult received;
            do
            {
                received = await socket.ReceiveAsync(buffer.AsMemory(), default);
                all.Write(buffer.AsSpan(0, received.Count));
            }
            while (!received.EndOfMessage);
            return all.ToArray();
        }
    }

    private async Task<JsonElement> AskAsync(string path, string request)
    {
        using HttpResponseMessage answer = await server.PostAsync($"/v1/{path}", request);
        Assert.True(answer.IsSuccessStatusCode, await answer.Content.ReadAsStringAsync());
        return await RunningServer.JsonOf(answer);
    }

    private async Task<Vector3D> SunAsync(double mjd)
    {
        JsonElement sun = JsonDocument.Parse(await server.Client.GetStringAsync(
            string.Create(CultureInfo.InvariantCulture, $"/v1/sun?mjd={mjd:R}"))).RootElement;
        double[] direction = [.. sun.GetProperty("direction").EnumerateArray().Select(number => number.GetDouble())];
        return Of(sun, "distance") * new Vector3D(direction[0], direction[1], direction[2]);
    }

    private static double Of(JsonElement element, string name) => element.GetProperty(name).GetDouble();

    private static string Text(JsonElement element, string name) => Of(element, name).ToString("R", CultureInfo.InvariantCulture);
}
