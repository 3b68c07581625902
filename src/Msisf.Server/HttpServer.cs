using System.Diagnostics;
using System.Net.Sockets;
using System.Security.Cryptography.X509Certificates;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Hosting.Server;
using Microsoft.AspNetCore.Hosting.Server.Features;
using Microsoft.AspNetCore.Http.Features;
using Microsoft.AspNetCore.Server.Kestrel.Core;
using Microsoft.AspNetCore.Routing;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.FileProviders;
using Microsoft.Extensions.Hosting;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.Server;

/// <summary>The server: listens, and leads each request to what answers it.</summary>
internal sealed class HttpServer : IAsyncDisposable
{
    private const int MaxConnections = 256;

    /// <summary>bytes: an image that fits goes to the system at once, and need not wait for the client piece by piece.</summary>
    private const int ResponseBuffer = 2 << 20;

    /// <summary>From a head's first byte to its last. A client that is so slow hears why; one that says nothing is cut off.</summary>
    private static readonly TimeSpan HeadersTimeout = TimeSpan.FromSeconds(8);
    private static readonly TimeSpan LongestSilence = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan KeepAlive = TimeSpan.FromMinutes(5);

    /// <summary>A server that ends with its client lets frames end that are all but finished.</summary>
    private static readonly TimeSpan TimeWithoutClient = TimeSpan.FromMilliseconds(200);

    private readonly WebApplication _web;
    private readonly FrameService _frames;
    private readonly ServeSettings _settings;
    private readonly SocketFile? _socket;
    private IDisposable? _refused;

    private HttpServer(WebApplication web, FrameService frames, ServeSettings settings, SocketFile? socket) =>
        (_web, _frames, _settings, _socket) = (web, frames, settings, socket);

    /// <summary>Where clients find the server: a URL, or the path of its Unix socket.</summary>
    public string Address => _settings.Listen.SocketPath
        ?? _web.Services.GetRequiredService<IServer>().Features.GetRequiredFeature<IServerAddressesFeature>().Addresses.First();

    /// <summary>The paths that the server answers, each with its method: "GET /healthz".</summary>
    internal IEnumerable<string> Routes => _web.Services.GetRequiredService<EndpointDataSource>().Endpoints.OfType<RouteEndpoint>().Select(
        route => $"{route.Metadata.GetRequiredMetadata<HttpMethodMetadata>().HttpMethods[0]} {route.RoutePattern.RawText}");

    /// <exception cref="MsisfException">There is no elevation model, or the address can't be listened on.</exception>
    public static async Task<HttpServer> StartAsync(ServeSettings settings, ProgramHost host)
    {
        ServerThreads.Reserve();
        SocketFile? socket = settings.Listen.SocketPath is { } path ? new SocketFile(path) : null;
        socket?.RequireShortPath();
        FrameService frames = new(settings, host);
        WebApplicationBuilder builder = WebApplication.CreateEmptyBuilder(
            new WebApplicationOptions { ContentRootPath = AppContext.BaseDirectory });
        builder.WebHost.UseKestrel(options => Configure(options, settings, socket));
        builder.Services.AddRouting();
        OpenApiEndpoint.AddServices(builder.Services, host.Version);
        builder.Services.Configure<HostOptions>(options => options.ShutdownTimeout = Timeout.InfiniteTimeSpan);
        WebApplication web = builder.Build();
        HttpServer server = new(web, frames, settings, socket);
        server.AddRoutes(host);
        try
        {
            server._refused = new RefusedRequests(frames.Metrics).Subscribe(web.Services.GetRequiredService<DiagnosticListener>());
            await web.StartAsync().ConfigureAwait(false);
            socket?.Publish();
        }
        catch (Exception exception) when (exception.IsFileError() || exception is SocketException)
        {
            await server.DisposeAsync().ConfigureAwait(false);
            throw new ExternalPartException(
                $"--listen {settings.Listen}: can't be listened on: {exception.Message.TrimEnd('.')}. Choose another one.", exception);
        }
        catch
        {
            await server.DisposeAsync().ConfigureAwait(false);
            throw;
        }

        host.Log.Note($"Listening on {server.Address} until {(settings.EndsWithInput ? "its client" : "a signal")} ends it.");
        return server;
    }

    /// <summary>
    /// Serves until the input ends, or the program gets a signal. Requests that are running are finished; those are dropped that take
    /// longer than a request may, or until a second signal. Without its client the server drops them at once.
    /// </summary>
    /// <param name="input">Its end ends the server.</param>
    public async Task RunAsync(TextReader input)
    {
        using CancellationTokenSource drop = new();
        using EndOfServer end = new(drop.Cancel);
        await end.WaitAsync(input).ConfigureAwait(false);
        drop.CancelAfter(_settings.EndsWithInput ? TimeWithoutClient : _settings.TimeLimit + FrameService.TimeToStop);
        await _web.StopAsync(drop.Token).ConfigureAwait(false);
    }

    public async ValueTask DisposeAsync()
    {
        await _web.DisposeAsync().ConfigureAwait(false);
        _refused?.Dispose();
        _socket?.Dispose();
        await _frames.DisposeAsync().ConfigureAwait(false);
    }

    private static void Configure(KestrelServerOptions options, ServeSettings settings, SocketFile? socket)
    {
        Connections connections = new(MaxConnections, LongestSilence);
        options.AddServerHeader = false;
        options.Limits.MaxRequestBodySize = JsonBody.LargestRequest;
        options.Limits.MaxConcurrentUpgradedConnections = MaxConnections;
        options.Limits.MaxResponseBufferSize = ResponseBuffer;
        options.Limits.RequestHeadersTimeout = HeadersTimeout;
        options.Limits.KeepAliveTimeout = KeepAlive;
        if (socket is not null)
        {
            options.ListenUnixSocket(socket.BoundPath, Serve);
            return;
        }

        options.Listen(settings.Listen.EndPoint!, Serve);

        void Serve(ListenOptions listen)
        {
            listen.Use(next => context => connections.HandleAsync(context, next));
            if (settings.Certificate is (string certificate, string key))
            {
                listen.UseHttps(ReadCertificate(certificate, key));
            }

            listen.Use(next => context => RefusedRequests.HandleAsync(context, next));
        }
    }

    private static X509Certificate2 ReadCertificate(string certificate, string key)
    {
        try
        {
            return X509Certificate2.CreateFromPemFile(certificate, key);
        }
        catch (Exception exception) when (exception.IsFileError() || exception is System.Security.Cryptography.CryptographicException)
        {
            throw new BadInputException(
                $"--tls-certificate {certificate}: it and its key {key} can't be read as PEM: {exception.Message}", exception)
                .About(ServeOptions.Certificate, ServeOptions.CertificateKey);
        }
    }

    private void AddRoutes(ProgramHost host)
    {
        RequestGuard guard = new(_settings);
        _web.Use((context, next) => RequestErrors.HandleAsync(context, next, guard, _frames.Metrics, host.Log));
        _web.Use(AskingClient.NoteAsync);
        _web.UseWebSockets(new WebSocketOptions { KeepAliveInterval = TimeSpan.FromSeconds(30) });
        AddFiles();
        _web.UseRouting();
        Get(RequestGuard.HealthPath, context => context.Response.WriteAsync("ok\n"), new("Says that the server is there.", "text/plain"));
        Get(
            "/metrics",
            context =>
            {
                context.Response.ContentType = PrometheusText.ContentType;
                return context.Response.WriteAsync(_frames.Metrics.Text());
            },
            new("Counts of what the server did, as Prometheus reads them.", "text/plain"));
        Get("/openapi.json", new OpenApiEndpoint().AnswerAsync, new("This document.", AnswerForm.Json));
        Get("/v1/models", new ModelsEndpoint(_frames).AnswerAsync, new("Lists the names that requests may use.", AnswerForm.Json));
        CraterEndpoints craters = new(_settings.Catalogues);
        Get(
            "/v1/catalogues/{name}", craters.AnswerCatalogueAsync,
            new("Lists the craters of a catalogue, the largest first.", AnswerForm.Json));
        FoldersEndpoint folders = new(_frames, host);
        Get("/v1/folders", folders.ListAsync, new("Lists the output folders and batch files of --folders.", AnswerForm.Json));
        Get("/v1/folders/{name}", folders.ListFramesAsync, new("Lists the frames of one.", AnswerForm.Json));
        Get(
            "/v1/folders/{name}/frames/{number}/{kind}", folders.SendFileAsync,
            new("Sends a file of a frame: image, annotated or meta.", AnswerForm.Png));
        Get("/v1/names", CraterEndpoints.AnswerNamesAsync, new("Lists the Moon's named places.", AnswerForm.Json));
        SunEndpoints sun = new(_frames);
        Get("/v1/sun", sun.AnswerAsync, SunEndpoints.About);
        Get("/v1/sun/path", sun.AnswerPathAsync, SunEndpoints.AboutPath);
        PointsEndpoints points = new(_frames);
        Post("/v1/ground", points.GroundAsync, PointsEndpoints.AboutGround);
        Post("/v1/light", points.LightAsync, PointsEndpoints.AboutLight);
        Post(
            "/v1/trajectory", new TrajectoryEndpoint(_frames, host).AnswerAsync,
            new("Reads the states of a trajectory.", AnswerForm.Json));
        Post("/v1/pixels", points.PixelsAsync, PointsEndpoints.AboutPixels);
        Post("/v1/points", points.PointsAsync, PointsEndpoints.AboutPoints);
        Post("/v1/render", new RenderEndpoint(_frames).AnswerAsync, RenderEndpoint.About);
        Get(
            "/v1/stream", context => StreamSession.AnswerAsync(context, _frames, _web.Lifetime.ApplicationStopping),
            new("A WebSocket on which states go in and images come out.", AnswerForm.Json));

        void Get(string path, RequestDelegate answer, RouteText text) => _web.MapGet(path, answer).WithMetadata(answer.Method, text);
        void Post(string path, RequestDelegate answer, RouteText text) => _web.MapPost(path, answer).WithMetadata(answer.Method, text);
    }

    private void AddFiles()
    {
        string folder = Path.Combine(AppContext.BaseDirectory, "wwwroot");
        if (!Directory.Exists(folder))
        {
            return;
        }

        PhysicalFileProvider files = new(folder);
        _web.UseDefaultFiles(new DefaultFilesOptions { FileProvider = files });
        _web.UseStaticFiles(new StaticFileOptions { FileProvider = files });
    }
}
