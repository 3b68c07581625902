using System.Collections.Concurrent;
using System.Diagnostics;
using System.Net.Sockets;
using System.Net.WebSockets;
using System.Text;
using Msisf.App.Settings;
using Msisf.TestSupport;
using Xunit;
using Xunit.Abstractions;

namespace Msisf.Server.Tests;

/// <summary>Requests that are torn, twisted or huge are refused, and the server goes on.</summary>
public sealed class MalformedRequestTests(RunningServer server, ITestOutputHelper output) : IClassFixture<RunningServer>
{
    /// <summary>Clients that send malformed requests at once.</summary>
    private const int Fuzzers = 4;

    private static readonly string[] Sources =
    [
        """{"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "width": 8, "height": 6, "fov": 40, "model": "LDEM_4"}""",
        """{"position": [10, 20, 1e5], "time": "2010-04-03T00:00:00Z", "look-at": "nadir", "width": 8, "height": 8, "layers": ["depth"]}""",
        """{"kepler-set": [1.9e6, 0.05, 0.7, 1.1, 0.9, 2.0], "epoch": 55289, "time": 55289.1, "width": 4, "height": 4, "samples": 4}""",
        """{"frame": {"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "width": 8, "height": 8}, "pixels": [[1, 1], [8, 8]]}""",
        """{"frame": {"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "width": 8, "height": 8}, "points": [[0, 0], [10, 5, 100]]}""",
        """{"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "camera": {"width": 8, "height": 8, "field-of-view": 40}, "albedo": 0.5}""",
    ];

    private static readonly string[] Values =
    [
        "1e308", "-1e308", "1e-320", "1e999", "-0", "99999999999999999999", "null", "true", "[]", "{}", "\"\"",
        "\"\\ud800\"", "\"\\u0000\"",
        "\"NaN\"", "\"/etc/passwd\"", "[[[[]]]]", "[1,2,3]", "0", "-1", "16385", "\"../x\"", "\"hapke:w=9\"", "\"all\"", "3.5",
    ];

    private static readonly string[] Paths = ["/v1/render", "/v1/pixels", "/v1/points"];

    private static readonly string[] Accepts =
    [
        "image/png", "application/octet-stream", "application/x-npy", "application/json", "application/xml", "multipart/mixed", "text/html",
        "*/*",
    ];

    /// <summary>
    /// Each answer is the request's own fault or the image; none is the server's. Another client meanwhile gets all its images.
    /// </summary>
    [RequiresFact(Part.Ldem4)]
    public async Task TwistedJson_IsNeverAnErrorOfTheServer_AndKeepsNobodyWaiting()
    {
        int requests = TestLength.Of(everyDay: 400, longForm: 100_000);
        ConcurrentDictionary<int, int> statuses = [];
        using CancellationTokenSource end = new();
        Task<List<double>> other = DrawUntilAsync(end.Token);
        await Task.WhenAll(Enumerable.Range(0, Fuzzers).Select(async fuzzer =>
        {
            Random random = new(20261122 + fuzzer);
            for (int i = 0; i < requests / Fuzzers; i++)
            {
                string source = Sources[random.Next(Sources.Length)];
                string json = random.Next(4) == 0 ? source : Twist(source, random);
                using HttpResponseMessage answer = await Within.Seconds(
                    60.0, json, server.PostAsync(Paths[random.Next(Paths.Length)], json, Accepts[random.Next(Accepts.Length)]));
                int status = (int)answer.StatusCode;
                statuses.AddOrUpdate(status, 1, (_, count) => count + 1);
                Assert.True(status is 200 or 400 or 406 or 413 or 422, $"{status} for {json}: {await answer.Content.ReadAsStringAsync()}");
            }
        }));
        await end.CancelAsync();
        double[] times = [.. (await other).Order()];

        Assert.True(statuses.GetValueOrDefault(400) > requests / 10, "hardly a request was wrong");
        Assert.True(statuses.GetValueOrDefault(200) > requests / 20, "hardly a request was right");
        Assert.DoesNotContain("a bug in msis", server.Log, StringComparison.Ordinal);
        output.WriteLine(string.Join(", ", statuses.OrderBy(pair => pair.Key).Select(pair => $"{pair.Value} x {pair.Key}")));
        output.WriteLine(FormattableString.Invariant(
            $"{times.Length} images meanwhile: median {times[times.Length / 2]:F1} ms, slowest {times[^1]:F1} ms"));
    }

    /// <summary>Bytes that are no UTF-8, wherever they stand, also where the request's text is handed on as it is.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("{\"camera\": {\"width\": 8, \"description\": \"?\"}}")]
    [InlineData("{\"model\": \"?\"}")]
    [InlineData("{\"?\": 1}")]
    public async Task BadUtf8_IsARequestsFault(string json)
    {
        byte[] bytes = Encoding.Latin1.GetBytes(json.Replace('?', '\u00ff'));
        using ByteArrayContent content = new(bytes);
        content.Headers.ContentType = new("application/json");

        using HttpResponseMessage answer = await server.Client.PostAsync("/v1/render", content);

        Assert.Equal(System.Net.HttpStatusCode.BadRequest, answer.StatusCode);
        Assert.Contains("not UTF-8", await answer.Content.ReadAsStringAsync(), StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4)]
    public async Task CompressedBody_IsRefused()
    {
        using StringContent content = new(Sources[0], Encoding.UTF8, "application/json");
        content.Headers.ContentEncoding.Add("gzip");

        using HttpResponseMessage answer = await server.Client.PostAsync("/v1/render", content);

        Assert.Equal(System.Net.HttpStatusCode.UnsupportedMediaType, answer.StatusCode);
        Assert.Contains("send the request without compression", await answer.Content.ReadAsStringAsync(), StringComparison.Ordinal);
    }

    /// <summary>Every option, as a text that is much too long: no answer repeats more than 200 characters of it.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("x", 5000)]
    [InlineData("x y ", 5000)]
    [InlineData("x'", 5000)]
    [InlineData("1,", 5000)]
    [InlineData("{[", 5000)]
    [InlineData("x y ", 60)]
    [InlineData("x'", 150)]
    [InlineData("x' 'y ", 70)]
    public async Task LongValue_IsNotRepeated_AsAWhole(string piece, int pieces)
    {
        string value = string.Concat(Enumerable.Repeat(piece, pieces));
        foreach (string option in (string[])[.. CommandTable.OptionsOfRequest.Select(option => option.Key), "model", value])
        {
            foreach (string json in (string[])[$"\"{value}\"", $"{{\"width\": 8, \"{value}\": 1}}", $"[\"{value}\"]"])
            {
                using HttpResponseMessage answer = await server.PostAsync(
                    "/v1/render", $"{{\"position\": [0, 0, 1e5], \"time\": 55289, \"{option}\": {json}}}");
                string text = (await RunningServer.JsonOf(answer)).GetProperty("detail").GetString()!;
                Assert.DoesNotContain(value[..202], text, StringComparison.Ordinal);
            }
        }
    }

    /// <summary>Twisted messages of a stream are answered, or end it; the server goes on.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task TwistedMessages_AreAnswered_OrEndTheStream()
    {
        Random random = new(20261124);
        int streams = TestLength.Of(everyDay: 40, longForm: 10_000);
        string first = $"{{\"frame\": {Sources[0]}, \"mode\": \"lock-step\", \"format\": \"u8\"}}";
        int answers = 0;
        for (int i = 0; i < streams; i++)
        {
            using ClientWebSocket socket = new();
            await socket.ConnectAsync(new Uri($"{server.Address.Replace("http", "ws", StringComparison.Ordinal)}/v1/stream"), default);
            await SendAsync(socket, random.Next(2) == 0 ? Twist(first, random) : first);
            for (int message = 0; message < 4 && await AnswersAsync(socket); message++)
            {
                answers++;
                byte[] state = new byte[random.Next(3) == 0 ? random.Next(200) : 64];
                random.NextBytes(state);
                await (random.Next(2) == 0
                    ? socket.SendAsync(state, WebSocketMessageType.Binary, true, default)
                    : SendAsync(socket, Twist(Sources[random.Next(3)], random)));
            }
        }

        Assert.True(answers > streams, $"{answers} answers of {streams} streams");
        using HttpResponseMessage answer = await Within.Seconds(60.0, "an answer", server.PostAsync("/v1/render", Sources[0]));
        Assert.True(answer.IsSuccessStatusCode);
        Assert.DoesNotContain("a bug in msis", server.Log, StringComparison.Ordinal);
    }

    /// <summary>Bytes that are no HTTP, heads without end, bodies that are cut off.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task TornRequests_DoNotStopTheServer()
    {
        Random random = new(20261123);
        const string start = "POST /v1/render HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n";
        string head = $"{start}Content-Length: {Sources[0].Length}";
        string whole = $"{head}\r\n\r\n{Sources[0]}";
        Uri address = new(server.Address);
        int requests = TestLength.Of(everyDay: 100, longForm: 10_000);
        for (int i = 0; i < requests; i++)
        {
            byte[] bytes = Encoding.Latin1.GetBytes(whole)[..random.Next(whole.Length)];
            for (int twist = random.Next(3); twist > 0 && bytes.Length > 0; twist--)
            {
                bytes[random.Next(bytes.Length)] = (byte)random.Next(256);
            }

            using TcpClient client = new();
            await client.ConnectAsync(address.Host, address.Port);
            await client.GetStream().WriteAsync(bytes);
        }

        using HttpResponseMessage answer = await Within.Seconds(60.0, "an answer", server.PostAsync("/v1/render", Sources[0]));
        Assert.True(answer.IsSuccessStatusCode);
        Assert.DoesNotContain("a bug in msis", server.Log, StringComparison.Ordinal);
    }

    /// <summary>Clients that send a byte now and then hold no place in the queue.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task SlowClients_DoNotSlowOthers()
    {
        Uri address = new(server.Address);
        List<TcpClient> slow = [];
        for (int i = 0; i < 100; i++)
        {
            TcpClient client = new();
            await client.ConnectAsync(address.Host, address.Port);
            await client.GetStream().WriteAsync(Encoding.ASCII.GetBytes(
                "POST /v1/render HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: 1000\r\n\r\n{"));
            slow.Add(client);
        }

        using HttpResponseMessage answer = await Within.Seconds(30.0, "an answer", server.PostAsync("/v1/render", Sources[0]));

        Assert.True(answer.IsSuccessStatusCode);
        slow.ForEach(client => client.Dispose());
    }

    /// <summary>ms of each image of a client that does nothing wrong.</summary>
    private async Task<List<double>> DrawUntilAsync(CancellationToken end)
    {
        List<double> times = [];
        do
        {
            long start = Stopwatch.GetTimestamp();
            await server.RenderAsync(RunningServer.SmallFrame);
            times.Add(Stopwatch.GetElapsedTime(start).TotalMilliseconds);
        }
        while (!end.IsCancellationRequested);

        return times;
    }

    private static Task SendAsync(ClientWebSocket socket, string json) =>
        socket.SendAsync(Encoding.UTF8.GetBytes(json), WebSocketMessageType.Text, true, default);

    /// <summary>Reads an answer; false if the server ends the stream.</summary>
    private static async Task<bool> AnswersAsync(ClientWebSocket socket)
    {
        byte[] buffer = new byte[1 << 16];
        WebSocketReceiveResult part;
        do
        {
            part = await Within.Seconds(60.0, "an answer of the stream", socket.ReceiveAsync(buffer, default));
        }
        while (!part.EndOfMessage);

        return part.MessageType != WebSocketMessageType.Close;
    }

    /// <summary>Cuts, doubles or replaces parts of a request.</summary>
    private static string Twist(string json, Random random)
    {
        for (int count = random.Next(1, 4); count > 0; count--)
        {
            int at = random.Next(json.Length);
            int length = random.Next(Math.Min(12, json.Length - at));
            string more = random.Next(3) switch
            {
                0 => Values[random.Next(Values.Length)],
                1 => json[at..(at + length)],
                _ => ((char)random.Next(32, 127)).ToString(),
            };
            (int from, int to) = random.Next(4) switch
            {
                0 => (at, at + length),
                1 => (at, at),
                2 when json.IndexOf(':', at) is > 0 and int colon && json.IndexOfAny([',', '}'], colon) is > 0 and int end =>
                    (colon + 1, end),
                _ => (at, json.Length),
            };
            json = string.Concat(json.AsSpan(0, from), more, json.AsSpan(to));
            if (json.Length < 2)
            {
                break;
            }
        }

        return json.Length == 0 ? " " : json;
    }
}
