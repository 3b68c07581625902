using Msisf.Adapters.Render;
using Msisf.Adapters.Scene;
using Msisf.Cli.Options;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Tiles;

namespace Msisf.Cli.Run;

/// <summary>POV-Ray's way: selection, patterns, scene, POV-Ray itself, files.</summary>
internal sealed class PovRayFrameRenderer : IFrameRenderer
{
    private readonly RenderSettings _settings;
    private readonly ElevationModel _model;
    private readonly ScenePatterns _patterns;
    private readonly PovRayProcess _povRay;
    private readonly SemaphoreSlim _processes;
    private readonly FrameFiles _files;
    private readonly RunTimes _times;

    /// <param name="settings">Of the run.</param>
    /// <param name="model">The elevation model.</param>
    /// <param name="patterns">The scenes' meshes.</param>
    /// <param name="povRay">Starts POV-Ray.</param>
    /// <param name="processes">So many POV-Rays run at once; the next frame's meshes are made meanwhile.</param>
    /// <param name="files">Writes a frame's files.</param>
    /// <param name="times">Of the run's parts.</param>
    public PovRayFrameRenderer(
        RenderSettings settings,
        ElevationModel model,
        ScenePatterns patterns,
        PovRayProcess povRay,
        int processes,
        FrameFiles files,
        RunTimes times)
    {
        _settings = settings;
        _model = model;
        _patterns = patterns;
        _povRay = povRay;
        _processes = new SemaphoreSlim(processes);
        _files = files;
        _times = times;
    }

    /// <inheritdoc/>
    public int FramesAhead => 1;

    /// <inheritdoc/>
    public async Task<FrameOutputs> RenderAsync(Frame frame, int threads, CancellationToken cancellation)
    {
        IReadOnlyList<SurfacePart> parts = _times.Measure(Phase.Selection, () => _model.SelectParts(frame, _settings.LevelOfDetailError));
        int made = _times.Measure(Phase.Patterns, () => _patterns.Ensure(parts, cancellation));
        RenderScene scene = new(frame.Camera, frame.Light, _model.Grid.PixelsPerDegree, parts);
        void WriteScene(TextWriter writer) => PovSceneWriter.Write(writer, scene, _patterns.FileNameOf);

        PovRayJob job = new(
            WriteScene,
            _patterns.Folder,
            _settings.OutputFolder,
            frame.Camera.Width,
            frame.Camera.Height,
            threads,
            _settings.PovOptions,
            _settings.Timeout);
        await _processes.WaitAsync(cancellation).ConfigureAwait(false);
        try
        {
            return new FrameOutputs(await DrawAsync(frame, job, WriteScene, cancellation).ConfigureAwait(false), parts.Count, made);
        }
        finally
        {
            _processes.Release();
        }
    }

    /// <inheritdoc/>
    public void Dispose() => _processes.Dispose();

    /// <returns>The paths of the frame's files.</returns>
    private async Task<IReadOnlyList<string>> DrawAsync(Frame frame, PovRayJob job, Action<TextWriter> writeScene, CancellationToken cancellation)
    {
        IReadOnlyList<string> outputs = [];
        long start = System.Diagnostics.Stopwatch.GetTimestamp();
        PovRayTimes povRayTimes = await _povRay.RenderAsync(
            job,
            picture =>
            {
                _times.Add(Phase.PovRay, System.Diagnostics.Stopwatch.GetElapsedTime(start).TotalSeconds);
                RenderedFrame rendered = new(RendererKind.PovRay, picture, "POV-Ray's picture", writeScene, _model.Grid.PixelsPerDegree, TruthOf(frame));
                outputs = _files.Write(frame, rendered, cancellation);
            },
            cancellation).ConfigureAwait(false);
        _times.Add(Phase.Parse, povRayTimes.ParseSeconds ?? 0.0);
        _times.Add(Phase.Trace, povRayTimes.TraceSeconds ?? 0.0);
        return outputs;
    }

    private TracedFrameTruth? TruthOf(Frame frame) =>
        _settings.Surface == PixelSurface.Terrain ? new TracedFrameTruth(frame.Camera, frame.Light, _model.Tracer) : null;
}
