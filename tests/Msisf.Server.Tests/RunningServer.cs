using System.Text;
using System.Text.Json;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>A server in this process, at a free port of loopback, with the real model of 4 px/deg.</summary>
public sealed class RunningServer : IAsyncLifetime, IDisposable
{
    /// <summary>A frame that is drawn within some ms.</summary>
    public const string SmallFrame = """
        "fixed-state": [55289, 1.9e6, 0, 0, 0, 0, 0, 1], "width": 64, "height": 48
        """;

    private readonly StringWriter _log = new();
    private HttpServer? _server;

    /// <summary>Its address.</summary>
    public string Address => _server!.Address;

    /// <summary>Sends requests to it.</summary>
    public HttpClient Client { get; } = new();

    internal HttpServer Server => _server!;

    /// <summary>What it logged.</summary>
    internal string Log => _log.ToString();

    /// <summary>Starts a server.</summary>
    internal static async Task<RunningServer> StartAsync(params (OptionSpec Option, string Value)[] options)
    {
        RunningServer running = new();
        (OptionSpec Option, string Value)[] defaults =
            [(ServeOptions.Listen, "127.0.0.1:0"), (SurfaceOptions.Ldem, Path.GetDirectoryName(TestParts.Ldem4Label) ?? string.Empty)];
        OptionValues values = new(
            options.Concat(defaults.Where(given => options.All(option => option.Option != given.Option)))
                .GroupBy(pair => pair.Option.Name, pair => pair.Value)
                .Select(option => KeyValuePair.Create(option.Key, new OptionValue([.. option]))));
        ProgramHost host = ServerHost.Create(
            TextWriter.Null, new ConsoleLog(running._log), TimeProvider.System, Environment.GetEnvironmentVariable);
        running._server = await HttpServer.StartAsync(ServeOptions.Read(values), host);
        running.Client.BaseAddress = running.Address.StartsWith("http", StringComparison.Ordinal) ? new Uri(running.Address) : null;
        return running;
    }

    public async Task InitializeAsync()
    {
        if (TestParts.Ldem4Label is not null)
        {
            RunningServer running = await StartAsync();
            (_server, Client.BaseAddress) = (running._server, running.Client.BaseAddress);
        }
    }

    public async Task DisposeAsync()
    {
        if (_server is not null)
        {
            await _server.DisposeAsync();
        }
    }

    public void Dispose()
    {
        Client.Dispose();
        _log.Dispose();
    }

    /// <summary>Posts JSON.</summary>
    public async Task<HttpResponseMessage> PostAsync(
        string path, string json, string? accept = null, CancellationToken cancellation = default)
    {
        using HttpRequestMessage request = new(HttpMethod.Post, path)
        {
            Content = new StringContent(json, Encoding.UTF8, "application/json"),
        };
        if (accept is not null)
        {
            request.Headers.Accept.ParseAdd(accept);
        }

        return await Client.SendAsync(request, cancellation);
    }

    /// <summary>Posts JSON to /v1/render and returns the answer's bytes.</summary>
    public async Task<byte[]> RenderAsync(string options, string? accept = null)
    {
        using HttpResponseMessage answer = await PostAsync("/v1/render", $"{{{options}}}", accept);
        byte[] bytes = await answer.Content.ReadAsByteArrayAsync();
        Assert.True(answer.IsSuccessStatusCode, Encoding.UTF8.GetString(bytes));
        return bytes;
    }

    /// <summary>Waits for a line of /metrics.</summary>
    public Task WaitForMetricAsync(string line) => Within.Seconds(
        60.0,
        $"the line '{line}' of /metrics",
        () => Client.GetStringAsync("/metrics").GetAwaiter().GetResult().Contains($"\n{line}\n", StringComparison.Ordinal));

    /// <summary>The answer's JSON.</summary>
    public static async Task<JsonElement> JsonOf(HttpResponseMessage answer) =>
        JsonDocument.Parse(await answer.Content.ReadAsByteArrayAsync()).RootElement;
}
