using System.Net.Sockets;
using System.Text;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>Requests that are torn, twisted or huge are refused, and the server goes on.</summary>
public sealed class MalformedRequestTests(RunningServer server) : IClassFixture<RunningServer>
{
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
        "1e308", "-1e308", "1e-320", "1e999", "-0", "99999999999999999999", "null", "true", "[]", "{}", "\"\"", "\"\\ud800\"", "\"\\u0000\"",
        "\"NaN\"", "\"/etc/passwd\"", "[[[[]]]]", "[1,2,3]", "0", "-1", "16385", "\"../x\"", "\"hapke:w=9\"", "\"all\"", "3.5",
    ];

    private static readonly string[] Paths = ["/v1/render", "/v1/pixels", "/v1/points"];

    private static readonly string[] Accepts =
        ["image/png", "application/octet-stream", "application/x-npy", "application/json", "application/xml", "multipart/mixed", "text/html", "*/*"];

    /// <summary>Each answer is the request's own fault or the image; none is the server's.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task TwistedJson_IsNeverAnErrorOfTheServer()
    {
        Random random = new(20261122);
        int requests = TestLength.Of(everyDay: 1_000, longForm: 100_000);
        Dictionary<int, int> statuses = [];
        for (int i = 0; i < requests; i++)
        {
            string source = Sources[random.Next(Sources.Length)];
            string json = random.Next(4) == 0 ? source : Twist(source, random);
            using HttpResponseMessage answer = await Within.Seconds(
                60.0, json, server.PostAsync(Paths[random.Next(Paths.Length)], json, Accepts[random.Next(Accepts.Length)]));
            int status = (int)answer.StatusCode;
            statuses[status] = statuses.GetValueOrDefault(status) + 1;
            Assert.True(status is 200 or 400 or 406 or 413 or 422, $"{status} for {json}: {await answer.Content.ReadAsStringAsync()}");
        }

        Assert.True(statuses.GetValueOrDefault(400) > requests / 10, "hardly a request was wrong");
        Assert.True(statuses.GetValueOrDefault(200) > requests / 20, "hardly a request was right");
        Assert.DoesNotContain("a bug in msis", server.Log, StringComparison.Ordinal);
    }

    /// <summary>Bytes that are no HTTP, heads without end, bodies that are cut off.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task TornRequests_DoNotStopTheServer()
    {
        Random random = new(20261123);
        string whole = $"POST /v1/render HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: {Sources[0].Length}\r\n\r\n{Sources[0]}";
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
                2 when json.IndexOf(':', at) is > 0 and int colon && json.IndexOfAny([',', '}'], colon) is > 0 and int end => (colon + 1, end),
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
