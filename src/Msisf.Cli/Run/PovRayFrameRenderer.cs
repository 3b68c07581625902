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
    private readonly FrameFiles _files;
    private readonly RunTimes _times;

    public PovRayFrameRenderer(
        RenderSettings settings,
        ElevationModel model,
        ScenePatterns patterns,
        PovRayProcess povRay,
        FrameFiles files,
        RunTimes times)
    {
        _settings = settings;
        _model = model;
        _patterns = patterns;
        _povRay = povRay;
        _files = files;
        _times = times;
    }

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
        IReadOnlyList<string> outputs = [];
        long start = System.Diagnostics.Stopwatch.GetTimestamp();
        PovRayTimes povRayTimes = await _povRay.RenderAsync(
            job,
            picture =>
            {
                _times.Add(Phase.PovRay, System.Diagnostics.Stopwatch.GetElapsedTime(start).TotalSeconds);
                RenderedFrame rendered = new(RendererKind.PovRay, picture, "POV-Ray's picture", WriteScene, _model.Grid.PixelsPerDegree, TruthOf(frame));
                outputs = _files.Write(frame, rendered, cancellation);
            },
            cancellation).ConfigureAwait(false);
        _times.Add(Phase.Parse, povRayTimes.ParseSeconds ?? 0.0);
        _times.Add(Phase.Trace, povRayTimes.TraceSeconds ?? 0.0);
        return new FrameOutputs(outputs, parts.Count, made);
    }

    private TracedFrameTruth? TruthOf(Frame frame) =>
        _settings.Surface == PixelSurface.Terrain ? new TracedFrameTruth(frame.Camera, frame.Light, _model.Tracer) : null;
}
