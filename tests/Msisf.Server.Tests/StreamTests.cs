using System.Buffers.Binary;
using System.Net.WebSockets;
using System.Text;
using System.Text.Json;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>GET /v1/stream: states in, images out.</summary>
public sealed class StreamTests(RunningServer server) : IClassFixture<RunningServer>
{
    private static readonly double[] State = [55289, 1.9e6, 0, 0, 0, 0, 0, 1];

    [RequiresFact(Part.Ldem4)]
    public async Task LockStep_GivesTheImagesOf_Render()
    {
        using ClientWebSocket socket = await OpenAsync("""{"frame": {"width": 64, "height": 48}, "mode": "lock-step", "format": "u8"}""");
        byte[] expected = await server.RenderAsync(RunningServer.SmallFrame, "application/octet-stream");

        for (uint number = 1; number <= 3; number++)
        {
            await SendAsync(socket, State);
            (WebSocketMessageType type, byte[] answer) = await ReceiveAsync(socket);

            Assert.Equal(WebSocketMessageType.Binary, type);
            Assert.Equal("MSIF", Encoding.ASCII.GetString(answer, 0, 4));
            Assert.Equal(number, BinaryPrimitives.ReadUInt32LittleEndian(answer.AsSpan(4)));
            Assert.Equal(64u, BinaryPrimitives.ReadUInt32LittleEndian(answer.AsSpan(8)));
            Assert.Equal(48u, BinaryPrimitives.ReadUInt32LittleEndian(answer.AsSpan(12)));
            Assert.Equal(expected, answer[16..]);
        }
    }

    [RequiresFact(Part.Ldem4)]
    public async Task Changes_ReplaceOptions_OfTheFirstMessage()
    {
        using ClientWebSocket socket = await OpenAsync($"{{\"frame\": {{{RunningServer.SmallFrame}}}, \"format\": \"png\"}}");

        await SendAsync(socket, """{"number": 17, "position": [0, 0, 500000], "time": 55289, "fov": 20}""");
        (_, byte[] answer) = await ReceiveAsync(socket);

        Assert.Equal(17u, BinaryPrimitives.ReadUInt32LittleEndian(answer.AsSpan(4)));
        Assert.Equal(
            await server.RenderAsync("\"position\": [0, 0, 500000], \"time\": 55289, \"fov\": 20, \"width\": 64, \"height\": 48"),
            answer[16..]);
    }

    /// <summary>A stream's images have the sky that its first message asks for, until a later one turns it off.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task Sky_IsInTheImages()
    {
        const string Place = "\"position\": [5, 125, 400000], \"look-at\": \"horizon:274\", \"time\": 55292.85";
        using ClientWebSocket socket = await OpenAsync("""{"frame": {"width": 64, "height": 48, "fov": 20, "earth": true}}""");

        await SendAsync(socket, $"{{{Place}}}");
        (_, byte[] with) = await ReceiveAsync(socket);
        await SendAsync(socket, $"{{{Place}, \"earth\": false}}");
        (_, byte[] without) = await ReceiveAsync(socket);

        string size = $"{Place}, \"width\": 64, \"height\": 48, \"fov\": 20";
        Assert.Equal(await server.RenderAsync($"{size}, \"earth\": true", "application/octet-stream"), with[16..]);
        Assert.Equal(await server.RenderAsync(size, "application/octet-stream"), without[16..]);
        Assert.NotEqual(with[16..], without[16..]);
    }

    /// <summary>With a trajectory in the first message, a time is all that the others need.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task States_OfTheFirstMessage_AreFollowedByTimes()
    {
        const string Frame =
            "\"states\": [[55289, 2e6, 0, 0, 0, 100, 0], [55289.01, 2e6, 86400, 0, 0, 100, 0]], \"width\": 64, \"height\": 48, \"time\": ";
        using ClientWebSocket socket = await OpenAsync($"{{\"frame\": {{{Frame}55289}}}}");

        await SendAsync(socket, """{"number": 3, "time": 55289.005}""");

        Assert.Equal(
            await server.RenderAsync($"{Frame}55289.005", "application/octet-stream"), (await ReceiveAsync(socket)).Bytes[16..]);
    }

    /// <summary>Each state has an image of each camera, in their order, by states of numbers and of options.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task Cameras_HaveAnImageEach_OfEveryState()
    {
        using ClientWebSocket socket = await OpenAsync(
            """{"frame": {"width": 64, "height": 48}, "cameras": [{}, {"fov": 5, "width": 30}, {"bit-depth": 16, "height": 20}]}""");
        string[] cameras = ["\"width\": 64, \"height\": 48", "\"width\": 30, \"height\": 48, \"fov\": 5",
            "\"width\": 64, \"height\": 20, \"bit-depth\": 16"];
        await SendAsync(socket, State);
        await SendAsync(socket, """{"number": 9, "position": [0, 0, 300000], "time": 55289}""");
        await SendAsync(socket, [55289, 1e6, 0, 0, 0, 0, 0, 1]); // inside the Moon: one error for the state
        await SendAsync(socket, State);

        foreach ((uint number, string place) in ((uint, string)[])[
            (1, "\"fixed-state\": [55289, 1.9e6, 0, 0, 0, 0, 0, 1]"), (9, "\"position\": [0, 0, 300000], \"time\": 55289"), (10, ""),
            (11, "\"fixed-state\": [55289, 1.9e6, 0, 0, 0, 0, 0, 1]")])
        {
            if (place.Length == 0)
            {
                (WebSocketMessageType type, byte[] error) = await ReceiveAsync(socket);
                Assert.Equal(WebSocketMessageType.Text, type);
                Assert.Contains("\"number\":10,", Encoding.UTF8.GetString(error), StringComparison.Ordinal);
                continue;
            }

            foreach (string camera in cameras)
            {
                byte[] answer = (await ReceiveAsync(socket)).Bytes;
                Assert.Equal(number, BinaryPrimitives.ReadUInt32LittleEndian(answer.AsSpan(4)));
                Assert.Equal(await server.RenderAsync($"{place}, {camera}", "application/octet-stream"), answer[16..]);
            }
        }
    }

    /// <summary>The number of a state is its step: the noise of a run with the same seed, whatever the form of the messages.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task NoiseSeed_OfTheFirstMessage_CountsTheStates()
    {
        const string Camera = """
            "camera": {"width": 40, "height": 30, "focal-length": 5, "pixel-pitch": 0.1, "detector": {"f-number": 4, "exposure-time": 1e-5,
            "band": [500, 650], "quantum-efficiency": 0.45, "gain": 1, "adc-bits": 16, "fits": "no"}}
            """;
        const string Place = "\"fixed-state\": [55289, 1.9e6, 0, 0, 0, 0, 0, 1]";
        using ClientWebSocket socket = await OpenAsync($"{{\"frame\": {{{Camera}, \"noise-seed\": 7}}}}");
        await SendAsync(socket, State);
        await SendAsync(socket, State);
        await SendAsync(socket, $"{{{Place}}}");
        await SendAsync(socket, $"{{{Place}, \"noise-seed\": 9}}");

        foreach (string seed in (string[])["7:1", "7:2", "7:3", "9:1"])
        {
            byte[] expected = await server.RenderAsync($"{Place}, {Camera}, \"noise-seed\": \"{seed}\"", "application/octet-stream");
            Assert.Equal(expected, (await ReceiveAsync(socket)).Bytes[16..]);
        }
    }

    /// <summary>With "timing" the times of an image come before it.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task Timing_TellsOfEachImage_WhatItTook()
    {
        using ClientWebSocket socket = await OpenAsync($"{{\"frame\": {{{RunningServer.SmallFrame}}}, \"timing\": true}}");

        for (int number = 1; number <= 2; number++)
        {
            await SendAsync(socket, State);
            JsonElement times = JsonDocument.Parse((await ReceiveAsync(socket)).Bytes).RootElement;
            Assert.Equal(number, times.GetProperty("number").GetInt32());
            Assert.True(times.GetProperty("draw").GetDouble() > 0.0);
            Assert.Equal(WebSocketMessageType.Binary, (await ReceiveAsync(socket)).Type);
        }
    }

    /// <summary>A request that fails leaves the session usable.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("{\"fov\": 500, \"number\": 3}", "--fov is 500", 3u)]
    [InlineData("{\"number\": -1}", "'number' is the frame's number", 1u)]
    [InlineData("{", "is not JSON", 1u)]
    [InlineData("{\"fov\": 1, \"fov\": 2}", "given twice", 1u)]
    public async Task WrongMessage_IsAnswered_AndTheNextOneWorks(string message, string words, uint number)
    {
        using ClientWebSocket socket = await OpenAsync($"{{\"frame\": {{{RunningServer.SmallFrame}}}}}");

        await SendAsync(socket, message);
        (WebSocketMessageType type, byte[] answer) = await ReceiveAsync(socket);

        JsonElement problem = JsonDocument.Parse(answer).RootElement;
        Assert.Equal(WebSocketMessageType.Text, type);
        Assert.Contains(words, problem.GetProperty("error").GetString(), StringComparison.Ordinal);
        Assert.Equal(number, problem.GetProperty("number").GetUInt32());
        await SendAsync(socket, State);
        Assert.Equal(WebSocketMessageType.Binary, (await ReceiveAsync(socket)).Type);
    }

    [RequiresFact(Part.Ldem4)]
    public async Task StateOfAnotherLength_IsAnError()
    {
        using ClientWebSocket socket = await OpenAsync($"{{\"frame\": {{{RunningServer.SmallFrame}}}}}");

        await SendAsync(socket, State[..7]);

        Assert.Contains("56 bytes; 64 are needed", Encoding.UTF8.GetString((await ReceiveAsync(socket)).Bytes), StringComparison.Ordinal);
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("{\"frame\": {\"fov\": 500}}", "--fov is 500")]
    [InlineData("{\"mode\": \"lock-step\"}", "no 'frame'")]
    [InlineData("{\"frame\": {}, \"mode\": \"slow\"}", "one of lock-step, newest-only")]
    [InlineData("{\"frames\": {}}", "'frames' is not known here")]
    public async Task WrongFirstMessage_ClosesTheStream(string message, string words)
    {
        using ClientWebSocket socket = await ConnectAsync();
        await SendAsync(socket, message);

        Assert.Contains(words, Encoding.UTF8.GetString((await ReceiveAsync(socket)).Bytes), StringComparison.Ordinal);
        Assert.Equal(WebSocketMessageType.Close, (await ReceiveAsync(socket)).Type);
    }

    /// <summary>Of many states that come while one is drawn, the last is drawn; each answer says which it is.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task NewestOnly_LeavesStatesOut_ButNotTheLast()
    {
        using ClientWebSocket socket = await OpenAsync(
            """{"frame": {"width": 256, "height": 256, "samples": 9}, "mode": "newest-only"}""");
        for (int i = 1; i <= 50; i++)
        {
            await SendAsync(socket, State);
        }

        List<uint> numbers = [];
        while (numbers.LastOrDefault() != 50)
        {
            numbers.Add(BinaryPrimitives.ReadUInt32LittleEndian((await ReceiveAsync(socket)).Bytes.AsSpan(4)));
        }

        Assert.True(numbers.Count < 50, $"{numbers.Count} of 50 were drawn");
        Assert.Equal(numbers.Order(), numbers);
    }

    /// <summary>When the first of four has its last image, the others have most of theirs.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task FourClients_AreServedAlike()
    {
        const int images = 80; // so many that a client that a busy machine lets wait at the start catches up
        const int fewest = images / 4; // one after another, the others would have none; on a busy machine the clients run unevenly
        int[] counts = new int[4];
        int[]? whenFirstEnded = null;
        ClientWebSocket[] sockets = new ClientWebSocket[counts.Length];
        for (int client = 0; client < sockets.Length; client++) // all before the first image
        {
            sockets[client] = await OpenAsync("""{"frame": {"width": 128, "height": 128}}""");
        }

        await Task.WhenAll(sockets.Select((socket, client) => Task.Run(async () =>
        {
            for (int i = 0; i < images; i++)
            {
                await SendAsync(socket, State);
                await ReceiveAsync(socket);
                counts[client]++;
            }

            Interlocked.CompareExchange(ref whenFirstEnded, [.. counts], null);
        })));
        Array.ForEach(sockets, socket => socket.Dispose());

        Assert.All(whenFirstEnded!, count => Assert.True(count >= fewest, $"{string.Join(", ", whenFirstEnded!)} of {images}"));
    }

    private async Task<ClientWebSocket> OpenAsync(string message)
    {
        ClientWebSocket socket = await ConnectAsync();
        await SendAsync(socket, message);
        string ready = Encoding.UTF8.GetString((await ReceiveAsync(socket)).Bytes);
        Assert.StartsWith("{\"ready\":true,\"width\":", ready, StringComparison.Ordinal);
        return socket;
    }

    private async Task<ClientWebSocket> ConnectAsync()
    {
        ClientWebSocket socket = new();
        await socket.ConnectAsync(new Uri($"{server.Address.Replace("http", "ws", StringComparison.Ordinal)}/v1/stream"), default);
        return socket;
    }

    private static Task SendAsync(ClientWebSocket socket, string json) =>
        socket.SendAsync(Encoding.UTF8.GetBytes(json), WebSocketMessageType.Text, true, default);

    private static Task SendAsync(ClientWebSocket socket, double[] state)
    {
        byte[] bytes = new byte[8 * state.Length];
        for (int i = 0; i < state.Length; i++)
        {
            BinaryPrimitives.WriteDoubleLittleEndian(bytes.AsSpan(8 * i), state[i]);
        }

        return socket.SendAsync(bytes, WebSocketMessageType.Binary, true, default);
    }

    private static Task<(WebSocketMessageType Type, byte[] Bytes)> ReceiveAsync(ClientWebSocket socket) =>
        Within.Seconds(60.0, "an answer of the stream", ReadAsync(socket));

    private static async Task<(WebSocketMessageType Type, byte[] Bytes)> ReadAsync(ClientWebSocket socket)
    {
        using MemoryStream message = new();
        byte[] buffer = new byte[1 << 16];
        while (true)
        {
            WebSocketReceiveResult part = await socket.ReceiveAsync(buffer, default);
            message.Write(buffer, 0, part.Count);
            if (part.EndOfMessage)
            {
                return (part.MessageType, message.ToArray());
            }
        }
    }
}
