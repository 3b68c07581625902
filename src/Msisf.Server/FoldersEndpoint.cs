using Msisf.App.Host;
using Msisf.App.Serving;
using Msisf.Core.Time;

namespace Msisf.Server;

/// <summary>GET /v1/folders: the output folders and batch files of <c>--folders</c>, their frames, and the files of these.</summary>
internal sealed class FoldersEndpoint
{
    private static readonly Dictionary<string, string> ContentTypes = new()
    {
        ["image"] = "image/png",
        ["annotated"] = "image/png",
        ["meta"] = "application/xml",
    };

    private readonly FrameService _frames;
    private readonly ProgramHost _host;
    private readonly Dictionary<string, Func<CancellationToken, Task<IReadOnlyList<ServedFrame>>>> _readers = new(StringComparer.Ordinal);

    public FoldersEndpoint(FrameService frames, ProgramHost host)
    {
        (_frames, _host) = (frames, host);
        foreach ((string name, string path) in frames.Settings.Folders)
        {
            ServedFolder folder = new(path, frames.Names, frames.TimeScale, host.Log);
            _readers[name] = Directory.Exists(path)
                ? _ => Task.FromResult(folder.Frames())
                : cancellation => ReadBatchAsync(path, cancellation);
        }
    }

    public Task ListAsync(HttpContext context) => JsonBody.SendAsync(context.Response, new
    {
        Folders = _frames.Settings.Folders.Select(folder => new
        {
            Name = folder.Key,
            Kind = Directory.Exists(folder.Value) ? "output" : "batch",
        }),
    });

    public async Task ListFramesAsync(HttpContext context)
    {
        string name = NameOf(context);
        IReadOnlyList<ServedFrame> frames = await _readers[name](context.RequestAborted).ConfigureAwait(false);
        string url = $"/v1/folders/{Uri.EscapeDataString(name)}/frames";
        await JsonBody.SendAsync(context.Response, new
        {
            Frames = frames.Select(frame => new
            {
                frame.Number,
                Mjd = frame.State.Time.Mjd,
                Utc = frame.State.Time.ToIsoUtc(),
                State = frame.State.ToNumbers(),
                Camera = frame.Camera is { } camera ? ModelsEndpoint.Described(camera) : null,
                Options = frame.Options.ToDictionary(option => option.Key, option => JsonValue(option.Value)),
                Image = UrlOf(frame, "image"),
                Annotated = UrlOf(frame, "annotated"),
                Meta = UrlOf(frame, "meta"),
            }),
        }).ConfigureAwait(false);

        string? UrlOf(ServedFrame frame, string kind) => frame.Files.ContainsKey(kind)
            ? Invariant($"{url}/{frame.Number}/{kind}")
            : null;
    }

    /// <summary>Sends a file of a frame.</summary>
    public async Task SendFileAsync(HttpContext context)
    {
        IReadOnlyList<ServedFrame> frames = await _readers[NameOf(context)](context.RequestAborted).ConfigureAwait(false);
        string kind = Word(context, "kind");
        string? path = int.TryParse(Word(context, "number"), NumberStyles.None, CultureInfo.InvariantCulture, out int number)
            ? frames.FirstOrDefault(frame => frame.Number == number)?.Files.GetValueOrDefault(kind)
            : null;
        if (path is null || !File.Exists(path))
        {
            throw NotFound($"{context.Request.Path}: the folder has no such frame, or the frame no such file.");
        }

        context.Response.ContentType = ContentTypes[kind];
        await context.Response.SendFileAsync(path, context.RequestAborted).ConfigureAwait(false);
    }

    private Task<IReadOnlyList<ServedFrame>> ReadBatchAsync(string path, CancellationToken cancellation)
    {
        RequestedFrame requested = _frames.ReadDefault();
        return _frames.RunAsync(
            requested,
            (_, _, end) => ServedBatch.Frames(path, requested, _frames.Sessions.Ephemeris, _host, end),
            cancellation);
    }

    private string NameOf(HttpContext context)
    {
        string name = Word(context, "name");
        return _readers.ContainsKey(name)
            ? name
            : throw NotFound($"'{name}' is no folder of this server; GET /v1/folders lists them, and --folders names them.");
    }

    private static RefusedException NotFound(string text) => new(StatusCodes.Status404NotFound, text);

    private static string Word(HttpContext context, string name) => (string)context.Request.RouteValues[name]!;

    /// <summary>Numbers as numbers, flags as true, all else as text.</summary>
    private static object JsonValue(string text) => text == "true"
        ? true
        : double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) && double.IsFinite(number)
            ? number
            : text;
}
