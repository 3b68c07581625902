using System.Buffers.Binary;
using System.Globalization;
using System.Net;
using System.Net.WebSockets;
using System.Text;
using System.Text.Json;
using System.Xml.Linq;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>Requests with invented detail get what msis draws with the same seed.</summary>
public sealed class InventedDetailTests(ServerOfSeveral server) : IClassFixture<ServerOfSeveral>
{
    /// <summary>60 km over the sphere at (0, 0), looking down, so that cells of 15 km are too wide.</summary>
    private const string Near = "51544.5,1797400,0,0,0,0,0,1";

    private const string Far = "51544.5,9E6,0,0,0,0,0,1";

    private const string Detail = "\"refine\": 7, \"refine-cell\": 256";

    private static string FrameAt(string state) => "\"fixed-state\": [" + state + """
        ], "ignore-sun": true, "width": 40, "height": 40, "fov": 60, "grid": 4, "reflectance": "lambert", "surface": "terrain"
        """;

    [Theory]
    [InlineData(false, "png", "image/png")]
    [InlineData(false, "xml", "application/xml")]
    [InlineData(true, "png", "image/png")]
    public async Task Answer_HasTheBytesOf_MsisWithTheSeed(bool isSeveral, string extension, string accept)
    {
        using TemporaryFolder folder = new();
        string[] models = isSeveral ? ["--ldem", server.Moon, "--ldem", server.Map] : ["--ldem", server.Moon, "--res", "2"];
        CommandLineRun run = CommandLineRun.Of(
            ["--fixed-state", $"{{{Near}}}", "--ignore-sun", "--batch", "--width", "40", "--height", "40", "--fov", "60", "--grid", "4",
             "--reflectance", "lambert", "--surface", "terrain", "--renderer", "native", "--refine", "7", "--refine-cell", "256",
             .. models, "--output-dir", folder.Path]);
        Assert.True(run.ExitCode == 0, run.Error);
        byte[] expected = File.ReadAllBytes(Assert.Single(Directory.GetFiles(folder.Path, $"*_00001.{extension}")));
        string named = isSeveral ? ", \"model\": [\"LDEM_2_SYNTHETIC\", \"LDEM_80S_10000M_SYNTHETIC\"]" : string.Empty;

        byte[] answer = await server.Running.RenderAsync($"{FrameAt(Near)}{named}, {Detail}", accept);

        Assert.Equal(expected, answer);
        Assert.NotEqual(answer, await server.Running.RenderAsync($"{FrameAt(Near)}{named}", accept));
    }

    [Fact]
    public async Task MoreSeedsThanAreKept_GiveTheSameImagesAgain()
    {
        List<byte[]> images = [];
        for (int seed = 1; seed <= 6; seed++)
        {
            images.Add(await server.Running.RenderAsync($"{FrameAt(Near)}, \"refine\": {seed}, \"refine-cell\": 256"));
        }

        Assert.Equal(6, images.Select(Convert.ToBase64String).Distinct().Count());
        Assert.Equal(images[0], await server.Running.RenderAsync($"{FrameAt(Near)}, \"refine\": 1, \"refine-cell\": 256"));
    }

    [Theory]
    [InlineData("\"sun\": \"point\"")]
    [InlineData("\"shading\": \"smooth\"")] // such pixels are drawn, not traced
    public async Task Pixels_SayWhatIsInvented(string option)
    {
        JsonElement[] near = await PixelsAsync($"{FrameAt(Near)}, {option}, {Detail}");
        JsonElement[] far = await PixelsAsync($"{FrameAt(Far)}, {option}, {Detail}");
        JsonElement[] without = await PixelsAsync($"{FrameAt(Near)}, {option}");

        Assert.All(near, point => Assert.True(point.GetProperty("facet").GetProperty("invented").GetBoolean()));
        Assert.All(far, point => Assert.False(point.GetProperty("facet").GetProperty("invented").GetBoolean()));
        Assert.All(without, point => Assert.False(point.GetProperty("facet").TryGetProperty("invented", out _)));
    }

    [Fact]
    public async Task Pixels_AreThoseOfTheMetaFile()
    {
        XDocument meta = XDocument.Parse(
            Encoding.UTF8.GetString(await server.Running.RenderAsync($"{FrameAt(Near)}, {Detail}", "application/xml")));
        XElement pixel = meta.Descendants("Pixel").First();
        XElement facet = pixel.Descendants("Facet").Single();

        JsonElement[] points = await PixelsAsync(
            $"{FrameAt(Near)}, {Detail}", $"[{pixel.Attribute("h")!.Value}, {pixel.Attribute("v")!.Value}]");

        JsonElement read = points[0].GetProperty("facet");
        Assert.Equal(
            ((int)facet.Attribute("part")!, (int)facet.Attribute("line")!, (int)facet.Attribute("sample")!),
            (read.GetProperty("part").GetInt32(), read.GetProperty("line").GetInt32(), read.GetProperty("sample").GetInt32()));
    }

    [Fact]
    public async Task Stream_DrawsTheImagesOf_Render()
    {
        using ClientWebSocket socket = new();
        await socket.ConnectAsync(
            new Uri(server.Running.Address.Replace("http", "ws", StringComparison.Ordinal) + "/v1/stream"), CancellationToken.None);
        await socket.SendAsync(
            Encoding.UTF8.GetBytes($$"""
                {"frame": {{{Detail}}, "ignore-sun": true, "width": 40, "height": 40, "fov": 60, "reflectance": "lambert"}, "format": "u8"}
                """),
            WebSocketMessageType.Text, endOfMessage: true, CancellationToken.None);
        _ = await ReceiveAsync(socket);
        byte[] state = new byte[64];
        double[] numbers = [.. Near.Split(',').Select(number => double.Parse(number, CultureInfo.InvariantCulture))];
        for (int i = 0; i < 8; i++)
        {
            BinaryPrimitives.WriteDoubleLittleEndian(state.AsSpan(8 * i), numbers[i]);
        }

        await socket.SendAsync(state, WebSocketMessageType.Binary, endOfMessage: true, CancellationToken.None);

        byte[] answer = await ReceiveAsync(socket);
        Assert.Equal(await server.Running.RenderAsync($"{FrameAt(Near)}, {Detail}", "application/octet-stream"), answer[16..]);
    }

    [Theory]
    [InlineData("\"refine\": -1", "--refine is '-1'; a whole number from 0 to 18446744073709551615")]
    [InlineData("\"refine\": true", "--refine is true")]
    [InlineData("\"refine-cell\": 1", "--refine-cell is given, but no --refine.")]
    [InlineData("\"refine\": 1, \"lod-error\": 2", "--lod-error is for levels of detail of one model")]
    public async Task WrongDetail_IsRefused(string options, string words)
    {
        using HttpResponseMessage answer = await server.Running.PostAsync("/v1/render", $"{{{FrameAt(Near)}, {options}}}");

        Assert.Equal(HttpStatusCode.BadRequest, answer.StatusCode);
        Assert.Contains(
            words, (await RunningServer.JsonOf(answer)).GetProperty("detail").GetString(), StringComparison.Ordinal);
    }

    private async Task<JsonElement[]> PixelsAsync(string frame, string pixels = "[20, 20], [22, 17]")
    {
        using HttpResponseMessage answer = await server.Running.PostAsync(
            "/v1/pixels", $"{{\"frame\": {{{frame}}}, \"pixels\": [{pixels}]}}");
        JsonElement json = await RunningServer.JsonOf(answer);
        Assert.True(answer.IsSuccessStatusCode, json.GetRawText());
        return [.. json.GetProperty("points").EnumerateArray()];
    }

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
