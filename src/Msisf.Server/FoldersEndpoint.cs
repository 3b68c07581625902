using System.Text.Json.Nodes;
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

    public Task ListAsync(HttpContext context) => JsonBody.SendAsync(
        context.Response,
        new FoldersAnswer(_frames.Settings.Folders.Select(
            folder => new FolderAnswer(folder.Key, Directory.Exists(folder.Value) ? "output" : "batch"))));

    public async Task ListFramesAsync(HttpContext context)
    {
        string name = NameOf(context);
        IReadOnlyList<ServedFrame> frames = await _readers[name](context.RequestAborted).ConfigureAwait(false);
        string url = $"/v1/folders/{Uri.EscapeDataString(name)}/frames";
        FramesAnswer answer = new(frames.Select(frame => new FrameAnswer(
            frame.Number,
            frame.State.Time.Mjd,
            frame.State.Time.ToIsoUtc(),
            frame.State.ToNumbers(),
            frame.Camera is { } camera ? ModelsEndpoint.Described(camera) : null,
            frame.Options.ToDictionary(option => option.Key, option => ValueOf(option.Value)),
            UrlOf(frame, "image"),
            UrlOf(frame, "annotated"),
            UrlOf(frame, "meta"))));
        await JsonBody.SendAsync(context.Response, answer).ConfigureAwait(false);

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
            : throw NotFound($"'{name}' is not a folder of this server; GET /v1/folders lists them, and --folders names them.");
    }

    private static RefusedException NotFound(string text) => new(StatusCodes.Status404NotFound, text);

    private static string Word(HttpContext context, string name) => (string)context.Request.RouteValues[name]!;

    /// <summary>Numbers as numbers, flags as true, the rest as text.</summary>
    private static JsonValue ValueOf(string text) => text == "true"
        ? JsonValue.Create(true)
        : double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) && double.IsFinite(number)
            ? JsonValue.Create(number)
            : JsonValue.Create(text);
}

/// <summary>The folders of a server.</summary>
internal sealed record FoldersAnswer(IEnumerable<FolderAnswer> Folders);

/// <summary>A folder.</summary>
/// <param name="Kind">"output", or "batch" for a batch file.</param>
internal sealed record FolderAnswer(string Name, string Kind);

/// <summary>The frames of a folder.</summary>
internal sealed record FramesAnswer(IEnumerable<FrameAnswer> Frames);

/// <summary>A frame of a folder.</summary>
/// <param name="State">As a row of a batch file.</param>
/// <param name="Image">URL of the image; null where there is none, as for the files after it.</param>
internal sealed record FrameAnswer(
    int Number, double Mjd, string Utc, double[] State, CameraAnswer? Camera, Dictionary<string, JsonValue> Options, string? Image,
    string? Annotated, string? Meta);
