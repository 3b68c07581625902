using System.Net.Sockets;
using System.Text;
using System.Text.Json;
using Microsoft.AspNetCore.Connections;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>Clients that are silent, slow or send nonsense; real connections, which do it in earnest.</summary>
public sealed class ConnectionsTests(RunningServer server) : IClassFixture<RunningServer>
{
    /// <summary>As many as the server has places for.</summary>
    private const int Places = 256;

    /// <summary>s: the server gives places up that are idle; without that they would be free after 300 s.</summary>
    private const double Soon = 60.0;

    [RequiresFact(Part.Ldem4)]
    public async Task SilentConnections_AsManyAsThereAreAtAll_KeepNobodyOut()
    {
        List<TcpClient> silent = [];
        for (int i = 0; i < Places + 50; i++)
        {
            silent.Add(await ConnectAsync());
        }

        using HttpClient other = new() { BaseAddress = new Uri(server.Address) };
        Assert.Equal("ok\n", await Within.Seconds(Soon, "an answer", other.GetStringAsync("/healthz")));
        silent.ForEach(client => client.Dispose());
    }

    /// <summary>Who asks and then keeps its connection holds no place either.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task KeptConnections_AsManyAsThereAreAtAll_KeepNobodyOut()
    {
        List<TcpClient> kept = [];
        for (int i = 0; i < Places + 10; i++)
        {
            kept.Add(await ConnectAsync());
            await SendAsync(kept[^1], "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n");
            Assert.StartsWith("HTTP/1.1 200", await ReadLineAsync(kept[^1]), StringComparison.Ordinal);
        }

        kept.ForEach(client => client.Dispose());
    }

    [Fact]
    public async Task SilentConnection_IsClosed_AndOneWithARequestIsNot()
    {
        Connections connections = new(2, TimeSpan.FromSeconds(1)); // a busy machine may stop a thread for a while
        DefaultConnectionContext silent = new("silent");
        DefaultConnectionContext used = new("used");
        Task serving = connections.HandleAsync(used, async context =>
        {
            context.Features.Get<Connection>()!.RequestBegins();
            await Within.Seconds(Soon, "the end of the silent one", connections.HandleAsync(silent, UntilClosedAsync));
        });

        await serving;

        await ClosedAsync(silent);
        Assert.False(used.ConnectionClosed.IsCancellationRequested);
    }

    [Fact]
    public async Task FullOfWork_ANewConnectionIsRefused()
    {
        Connections connections = new(1, TimeSpan.FromSeconds(Soon));
        DefaultConnectionContext busy = new("busy");
        DefaultConnectionContext late = new("late");
        bool isServed = false;

        await connections.HandleAsync(busy, async context =>
        {
            context.Features.Get<Connection>()!.RequestBegins();
            await connections.HandleAsync(late, _ => Task.FromResult(isServed = true));
        });

        Assert.False(isServed);
        await ClosedAsync(late);
        Assert.False(busy.ConnectionClosed.IsCancellationRequested);
    }

    /// <summary>What Kestrel refuses itself has a problem as its body, as all errors do.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData(400, "no HTTP at all", "\r\n\r\n")]
    [InlineData(400, "GET /healthz HTTP/1.1", "\r\n\r\n")]
    [InlineData(414, "GET /healthz?", " HTTP/1.1\r\nHost: localhost\r\n\r\n")]
    [InlineData(431, "GET /healthz HTTP/1.1\r\nHost: localhost\r\nX: ", "\r\n\r\n")]
    public async Task RefusedByTheWebServer_IsAProblem(int status, string begin, string end)
    {
        using TcpClient client = await ConnectAsync();
        await SendAsync(client, begin + (status > 400 ? new string('x', 40_000) : string.Empty) + end);

        await AssertProblemAsync(client, status);
    }

    /// <summary>Takes as long as a head may.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task SlowHead_IsAProblem()
    {
        if (!TestLength.IsLong)
        {
            return;
        }

        using TcpClient client = await ConnectAsync();
        await SendAsync(client, "GET /healthz HTTP/1.1\r\nHost: local");

        await AssertProblemAsync(client, 408);
    }

    /// <summary>A refused request does not spoil the answers before it on the same connection.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task NonsenseAfterAGoodRequest_IsRefused_AfterItsAnswer()
    {
        using TcpClient client = await ConnectAsync();
        await SendAsync(client, "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\nnonsense\r\n\r\n");

        string text = await Within.Seconds(Soon, "the end of the connection", new StreamReader(client.GetStream()).ReadToEndAsync());

        Assert.StartsWith("HTTP/1.1 200 OK\r\n", text, StringComparison.Ordinal);
        Assert.Contains("ok\n", text, StringComparison.Ordinal);
        Assert.Contains("HTTP/1.1 400 Bad Request\r\nContent-Type: application/problem+json\r\n", text, StringComparison.Ordinal);
        Assert.EndsWith("}", text, StringComparison.Ordinal);
    }

    /// <summary>The stream of a client that never reads: the write is cancelled, on which the server ends the connection.</summary>
    [Fact]
    public async Task Write_OfAClientThatDoesNotRead_IsCancelled()
    {
        await using ResponseStream stream = new(new UnreadStream(), TimeSpan.FromMilliseconds(50));

        await Assert.ThrowsAnyAsync<OperationCanceledException>(
            () => Within.Seconds(Soon, "the end of the write", stream.WriteAsync(new byte[10]).AsTask()));
        Assert.ThrowsAny<OperationCanceledException>(() => stream.Write([1, 2, 3]));
    }

    private static Task ClosedAsync(ConnectionContext context) =>
        Within.Seconds(Soon, "the end of a connection", () => context.ConnectionClosed.IsCancellationRequested);

    private static async Task UntilClosedAsync(ConnectionContext context)
    {
        TaskCompletionSource end = new();
        using CancellationTokenRegistration closed = context.ConnectionClosed.Register(end.SetResult);
        await end.Task;
    }

    private static async Task AssertProblemAsync(TcpClient client, int status)
    {
        string text = await Within.Seconds(Soon, "the end of the connection", new StreamReader(client.GetStream()).ReadToEndAsync());
        string[] parts = text.Split("\r\n\r\n", 2);
        JsonElement problem = JsonDocument.Parse(parts[1]).RootElement;
        Assert.StartsWith($"HTTP/1.1 {status} ", parts[0], StringComparison.Ordinal);
        Assert.Contains("Content-Type: application/problem+json", parts[0], StringComparison.Ordinal);
        Assert.Contains(FormattableString.Invariant($"Content-Length: {parts[1].Length}"), parts[0], StringComparison.Ordinal);
        Assert.Equal(status, problem.GetProperty("status").GetInt32());
        Assert.InRange(problem.GetProperty("detail").GetString()!.Length, 10, 300);
    }

    private async Task<TcpClient> ConnectAsync()
    {
        Uri address = new(server.Address);
        TcpClient client = new();
        await client.ConnectAsync(address.Host, address.Port);
        return client;
    }

    private static async Task SendAsync(TcpClient client, string text) =>
        await client.GetStream().WriteAsync(Encoding.ASCII.GetBytes(text));

    private static async Task<string> ReadLineAsync(TcpClient client) =>
        await Within.Seconds(Soon, "an answer", new StreamReader(client.GetStream()).ReadLineAsync()) ?? string.Empty;

    private sealed class UnreadStream : MemoryStream
    {
        public override async ValueTask WriteAsync(ReadOnlyMemory<byte> buffer, CancellationToken cancellationToken = default) =>
            await Task.Delay(Timeout.Infinite, cancellationToken);
    }
}
