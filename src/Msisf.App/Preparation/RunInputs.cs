using Msisf.Adapters.Camera;
using Msisf.Adapters.IO;
using Msisf.Adapters.Raster.Heights;
using Msisf.App.Host;
using Msisf.Core.Metadata;

namespace Msisf.App.Preparation;

/// <summary>
/// The files that the frames of a run are made from, with their checksums. They are computed while the run goes on, because that takes
/// longer than a small image. Thread-safe.
/// </summary>
internal sealed class RunInputs : IDisposable
{
    /// <summary>Bytes: more than a second of reading.</summary>
    private const long WorthANote = 1L << 30;

    private readonly CancellationTokenSource _end;
    private readonly ILog _log;
    private readonly string? _cacheFolder;
    private Task<IReadOnlyList<InputFile>>? _model;
    private IReadOnlyList<InputFile> _maps = [];

    /// <param name="kernels">Finds the paths of the kernels, in load order.</param>
    public RunInputs(Func<IReadOnlyList<string>> kernels, ProgramHost host, CancellationToken cancellation)
    {
        _end = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        _log = host.Log;
        _cacheFolder = host.CacheFolder;
        CancellationToken end = _end.Token;
        Kernels = Task.Run<IReadOnlyList<InputFile>>(() => OfKernels(kernels(), end), end);
    }

    /// <summary>The kernels, in load order.</summary>
    public Task<IReadOnlyList<InputFile>> Kernels { get; }

    /// <param name="maps">The maps of the surface, whose checksums are known.</param>
    public void Begin(IReadOnlyList<LdemSet> models, IReadOnlyList<InputFile> maps)
    {
        _maps = maps;
        CancellationToken end = _end.Token;
        _model = Task.Run<IReadOnlyList<InputFile>>(() => [.. models.SelectMany(model => OfModel(model, end))], end);
    }

    /// <summary>
    /// All files: the elevation model, the kernels, the maps and the camera file. Waits until their checksums are known.
    /// </summary>
    /// <param name="camera">The camera file of a frame; null for none.</param>
    /// <exception cref="MsisfException">A file can't be read.</exception>
    /// <exception cref="OperationCanceledException">The run was cancelled.</exception>
    public IReadOnlyList<InputFile> All(CameraFile? camera) =>
    [
        .. _model?.GetAwaiter().GetResult() ?? throw new InvalidOperationException("no model yet"),
        .. Kernels.GetAwaiter().GetResult(),
        .. _maps,
        .. camera is null ? (InputFile[])[] : [Of(camera)],
    ];

    public static InputFile Of(CameraFile camera) =>
        new(InputKind.Camera, Path.GetFileName(camera.Path), camera.Bytes, camera.Sha256);

    /// <summary>Ends what is still going on; its result is not needed.</summary>
    public void Dispose()
    {
        _end.Cancel();
        _end.Dispose();
    }

    private static InputFile[] OfKernels(IReadOnlyList<string> paths, CancellationToken cancellation) =>
        FileErrors.ToExternalPart("a kernel can't be read", () => paths.Select(path => new InputFile(
            InputKind.Kernel, Path.GetFileName(path), new FileInfo(path).Length, FileHash.Sha256Of(path, cancellation))).ToArray());

    private IReadOnlyList<InputFile> OfModel(LdemSet model, CancellationToken cancellation)
    {
        LdemChecksums checksums = LdemChecksums.Open(model, _cacheFolder);
        if (checksums.BytesToRead > WorthANote)
        {
            _log.Note(Invariant(
                $"The checksum of {model.ProductId} is computed once, from all of its {checksums.BytesToRead / 1e9:F1} GB."));
        }

        (IReadOnlyList<InputFile> files, string? warning) = checksums.Read(cancellation);
        if (warning is not null)
        {
            _log.Warning(warning);
        }

        return files;
    }
}
