using System.Buffers.Binary;
using System.Net;
using System.Net.WebSockets;
using System.Text;
using System.Text.Json;
using System.Xml.Linq;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>Requests that name several models get what msis draws of these models as one surface.</summary>
public sealed class SeveralModelsTests(ServerOfSeveral server) : IClassFixture<ServerOfSeveral>
{
    private const string State = "51544.5,0,0,-2.4E6,0,0.7071067811865476,0,0.7071067811865476";

    private const string Frame = "\"fixed-state\": [" + State + """
        ], "ignore-sun": true, "width": 40, "height": 40, "fov": 60, "grid": 2, "reflectance": "lambert", "surface": "terrain"
        """;

    private const string Models = "\"model\": [\"LDEM_2_SYNTHETIC\", \"LDEM_80S_10000M_SYNTHETIC\"]";

    [Theory]
    [InlineData("\"lod\": \"auto\"", "png", "image/png")]
    [InlineData("\"lod\": \"off\"", "png", "image/png")]
    [InlineData("\"lod\": \"off\"", "xml", "application/xml")]
    public async Task Answer_HasTheBytesOf_MsisWithTheseModels(string option, string extension, string accept)
    {
        using TemporaryFolder folder = new();
        CommandLineRun run = CommandLineRun.Of(
            ["--fixed-state", $"{{{State}}}", "--ignore-sun", "--batch", "--width", "40", "--height", "40", "--fov", "60", "--grid", "2",
             "--reflectance", "lambert", "--surface", "terrain", "--renderer", "native", "--ldem", server.Map, "--ldem", server.Moon,
             "--lod", option.Contains("off", StringComparison.Ordinal) ? "off" : "auto", "--output-dir", folder.Path]);
        Assert.True(run.ExitCode == 0, run.Error);
        byte[] expected = File.ReadAllBytes(Assert.Single(Directory.GetFiles(folder.Path, $"*_00001.{extension}")));

        Assert.Equal(expected, await server.Running.RenderAsync($"{Frame}, {Models}, {option}", accept));
    }

    /// <summary>The order of the names, and how they are written, is no part of the image.</summary>
    [Fact]
    public async Task Models_InAnotherForm_AreTheSame()
    {
        byte[] expected = await server.Running.RenderAsync($"{Frame}, {Models}");

        Assert.Equal(expected, await server.Running.RenderAsync(
            $"{Frame}, \"model\": [\"ldem_80s_10000m_synthetic\", \"LDEM_2_SYNTHETIC\"]"));
        Assert.Equal(expected, await server.Running.RenderAsync(
            $"{Frame}, \"model\": \"LDEM_2_SYNTHETIC+LDEM_80S_10000M_SYNTHETIC\""));
        Assert.NotEqual(expected, await server.Running.RenderAsync(Frame)); // the model of the whole Moon alone
        Assert.Equal(
            await server.Running.RenderAsync(Frame), await server.Running.RenderAsync($"{Frame}, \"model\": [\"LDEM_2_SYNTHETIC\"]"));
    }

    [Fact]
    public async Task Pixels_OfBothModelsAndTheSeam_AreThoseOfTheMetaFile()
    {
        XDocument meta = XDocument.Parse(
            Encoding.UTF8.GetString(await server.Running.RenderAsync($"{Frame}, {Models}", "application/xml")));
        (XElement Pixel, XElement Facet)[] expected = [.. meta.Descendants("Pixel").Select(
            pixel => (pixel, pixel.Descendants("Facet").Single()))];
        string pixels = string.Join(
            ", ", expected.Select(pair => $"[{pair.Pixel.Attribute("h")!.Value}, {pair.Pixel.Attribute("v")!.Value}]"));

        JsonElement[] points = await AskAsync("pixels", pixels, "points");

        Assert.Equal(["0", "1", "2"], expected.Select(pair => pair.Facet.Attribute("part")!.Value).Distinct().Order());
        foreach (((_, XElement facet), JsonElement point) in expected.Zip(points))
        {
            JsonElement read = point.GetProperty("facet");
            Assert.Equal(
                ((int)facet.Attribute("part")!, (int)facet.Attribute("line")!, (int)facet.Attribute("sample")!),
                (read.GetProperty("part").GetInt32(), read.GetProperty("line").GetInt32(), read.GetProperty("sample").GetInt32()));
        }
    }

    [Fact]
    public async Task Points_OnTheMap_LeadBackToTheirPixels()
    {
        JsonElement place = (await AskAsync("pixels", "[20.25, 21.5]", "points"))[0];
        string[] fields = ["latitude", "longitude", "height"];
        string text = string.Join(", ", fields.Select(field => place.GetProperty(field).GetRawText()));

        JsonElement[] pixels = await AskAsync("points", $"[{text}], [-89, 0], [0, 0]", "pixels");

        Assert.Equal(20.25, pixels[0].GetProperty("x").GetDouble(), 6);
        Assert.Equal(21.5, pixels[0].GetProperty("y").GetDouble(), 6);
        Assert.Equal("outside the image", pixels[2].GetProperty("hidden_by").GetString());
    }

    [Fact]
    public async Task Stream_DrawsTheImagesOf_Render()
    {
        using ClientWebSocket socket = new();
        await socket.ConnectAsync(
            new Uri(server.Running.Address.Replace("http", "ws", StringComparison.Ordinal) + "/v1/stream"), CancellationToken.None);
        await SendAsync(socket, $$"""
            {"frame": {{{Models}}, "ignore-sun": true, "width": 40, "height": 40, "fov": 60, "reflectance": "lambert"}, "format": "u8"}
            """);
        _ = await ReceiveAsync(socket);
        byte[] state = new byte[64];
        double[] numbers = [.. State.Split(',').Select(number => double.Parse(number, System.Globalization.CultureInfo.InvariantCulture))];
        for (int i = 0; i < 8; i++)
        {
            BinaryPrimitives.WriteDoubleLittleEndian(state.AsSpan(8 * i), numbers[i]);
        }

        await socket.SendAsync(state, WebSocketMessageType.Binary, endOfMessage: true, CancellationToken.None);

        byte[] answer = await ReceiveAsync(socket);
        Assert.Equal(await server.Running.RenderAsync($"{Frame}, {Models}", "application/octet-stream"), answer[16..]);
    }

    [Fact]
    public async Task ModelsEndpoint_TellsWhatMakesOneSurface()
    {
        JsonElement models = await RunningServer.JsonOf(await server.Running.Client.GetAsync("/v1/models"));

        Assert.Equal(
            [("LDEM_2_SYNTHETIC", true), ("LDEM_80S_10000M_SYNTHETIC", false)],
            models.GetProperty("models").EnumerateArray().Select(
                model => (model.GetProperty("name").GetString(), model.GetProperty("whole_moon").GetBoolean())));
        foreach (string key in new[] { "path", "ldem" }) // both were given by --ldem
        {
            Assert.Equal(
                [server.Moon, server.Map],
                models.GetProperty("models").EnumerateArray().Select(model => model.GetProperty(key).GetString()));
        }

        Assert.Equal(
            ["LDEM_2_SYNTHETIC", "LDEM_80S_10000M_SYNTHETIC"],
            models.GetProperty("one_surface").EnumerateArray().Select(name => name.GetString()));
    }

    [Theory]
    [InlineData("\"model\": \"LDEM_80S_10000M_SYNTHETIC\"", "a map of a part of the Moon. Name a model of the whole Moon with it")]
    [InlineData("\"model\": [\"LDEM_2_SYNTHETIC\", \"LDEM_2_SYNTHETIC\"]", "'model' has LDEM_2_SYNTHETIC twice")]
    [InlineData("\"model\": [\"LDEM_2_SYNTHETIC\", \"LDEM_5\"]", "'model' is 'LDEM_5', which the server does not have")]
    [InlineData("\"model\": []", "'model' is an empty list")]
    [InlineData("\"model\": [[]]", "'model' is a list; a text or a number is needed")]
    [InlineData(Models + ", \"res\": 2", "--res has no meaning with several models")]
    [InlineData("\"res\": 5", "--res is 5; the server has 2 (/v1/models)")]
    public async Task WrongModels_AreRefused(string options, string words)
    {
        using HttpResponseMessage answer = await server.Running.PostAsync("/v1/render", $"{{{Frame}, {options}}}");

        Assert.Equal(HttpStatusCode.BadRequest, answer.StatusCode);
        Assert.Contains(
            words, (await RunningServer.JsonOf(answer)).GetProperty("detail").GetString(), StringComparison.Ordinal);
    }

    private async Task<JsonElement[]> AskAsync(string what, string list, string member)
    {
        using HttpResponseMessage answer = await server.Running.PostAsync(
            $"/v1/{what}", $"{{\"frame\": {{{Frame}, {Models}}}, \"{what}\": [{list}]}}");
        JsonElement json = await RunningServer.JsonOf(answer);
        Assert.True(answer.IsSuccessStatusCode, json.GetRawText());
        return [.. json.GetProperty(member).EnumerateArray()];
    }

    private static Task SendAsync(ClientWebSocket socket, string text) =>
        socket.SendAsync(Encoding.UTF8.GetBytes(text), WebSocketMessageType.Text, endOfMessage: true, CancellationToken.None);

    private static async Task<byte[]> ReceiveAsync(ClientWebSocket socket)
    {
        using MemoryStream whole = new();
        byte[] buffer = new byte[4096];
        WebSocketReceiveResult part;
        do
        {
            part = await socket.ReceiveAsync(buffer, CancellationToken.None);
            whole.Write(buffer, 0, part.Count);
        }
        while (!part.EndOfMessage);
        return whole.ToArray();
    }
}
