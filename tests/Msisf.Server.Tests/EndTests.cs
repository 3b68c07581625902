using System.Net;
using System.Net.Sockets;
using System.Net.WebSockets;
using System.Text;
using Msisf.App.Settings;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>The server ends when it is told to: no client that is idle, silent or slow holds it up.</summary>
public sealed class EndTests
{
    /// <summary>Takes minutes, if it is not ended.</summary>
    private const string LongFrame = """
        {"fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "width": 1024, "height": 1024, "samples": 256, "sun": "disc"}
        """;

    /// <summary>s: what ends at once; the server would wait for the time limit of a request, 600 s here.</summary>
    private const double AtOnce = 20.0;

    [RequiresFact(Part.Ldem4)]
    public async Task IdleStreamsAndSilentConnections_DoNotHoldItUp()
    {
        using RunningServer server = await StartAsync();
        Uri address = new(server.Address);
        using TcpClient silent = new(address.Host, address.Port);
        using ClientWebSocket idle = await OpenAsync(server);
        using ClientWebSocket unopened = new();
        await unopened.ConnectAsync(StreamOf(server), default);
        await server.Client.GetStringAsync("/healthz"); // its connection is kept

        await EndsAsync(server);

        WebSocketReceiveResult last = await idle.ReceiveAsync(new byte[100], default);
        Assert.Equal(WebSocketCloseStatus.EndpointUnavailable, last.CloseStatus);
    }

    [RequiresFact(Part.Ldem4)]
    public async Task RunningFrame_IsFinished()
    {
        using RunningServer server = await StartAsync();
        string frame = $"{{{RunningServer.SmallFrame.Replace("64", "512", StringComparison.Ordinal)}, \"samples\": 64}}";
        Task<HttpResponseMessage> running = server.PostAsync("/v1/render", frame);
        await server.WaitForMetricAsync("msisf_running 1");

        await Within.Seconds(600.0, "the end of the server", server.Server.RunAsync(TextReader.Null));

        using HttpResponseMessage answer = await running;
        Assert.Equal(HttpStatusCode.OK, answer.StatusCode);
        await server.DisposeAsync();
    }

    [RequiresFact(Part.Ldem4)]
    public async Task LongFrame_IsDropped_AtTheTimeLimit()
    {
        using RunningServer server = await RunningServer.StartAsync((ServeOptions.TimeLimit, "1"));
        Task<HttpResponseMessage> running = server.PostAsync("/v1/render", LongFrame);
        await server.WaitForMetricAsync("msisf_running 1");

        await EndsAsync(server);

        using HttpResponseMessage answer = await running;
        Assert.Equal(HttpStatusCode.ServiceUnavailable, answer.StatusCode);
    }

    [RequiresFact(Part.Ldem4)]
    public async Task WithoutItsClient_DropsFramesAtOnce()
    {
        using RunningServer server = await RunningServer.StartAsync(
            (ServeOptions.EndWithInput, string.Empty), (ServeOptions.TimeLimit, "600"));
        Task<HttpResponseMessage> running = server.PostAsync("/v1/render", LongFrame);
        await server.WaitForMetricAsync("msisf_running 1");

        await EndsAsync(server);

        await Assert.ThrowsAsync<HttpRequestException>(() => running);
    }

    private static Task<RunningServer> StartAsync() => RunningServer.StartAsync((ServeOptions.TimeLimit, "600"));

    private static async Task EndsAsync(RunningServer server)
    {
        await Within.Seconds(AtOnce, "the end of the server", server.Server.RunAsync(TextReader.Null));
        await Within.Seconds(AtOnce, "the end of its work", server.DisposeAsync());
    }

    private static Uri StreamOf(RunningServer server) =>
        new($"{server.Address.Replace("http", "ws", StringComparison.Ordinal)}/v1/stream");

    private static async Task<ClientWebSocket> OpenAsync(RunningServer server)
    {
        ClientWebSocket socket = new();
        await socket.ConnectAsync(StreamOf(server), default);
        await socket.SendAsync(Encoding.ASCII.GetBytes("""{"frame": {}}"""), WebSocketMessageType.Text, true, default);
        await socket.ReceiveAsync(new byte[100], default);
        return socket;
    }
}
