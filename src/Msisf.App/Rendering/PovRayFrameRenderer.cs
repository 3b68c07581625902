using Msisf.Adapters.Render;
using Msisf.Adapters.Scene;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Tiles;

namespace Msisf.App.Rendering;

/// <summary>POV-Ray's way: selection, patterns, scene, POV-Ray itself, files.</summary>
internal sealed class PovRayFrameRenderer : IFrameRenderer
{
    /// <summary>
    /// Below this a second process would cost more (0.65 s of sleeping, and what both parse) than it saves: a triangle takes some 2
    /// microseconds.
    /// </summary>
    private const long MinFacesOfStrip = 250_000;

    private readonly RenderSettings _settings;
    private readonly ElevationModel _model;
    private readonly ScenePatterns _patterns;
    private readonly PovRayProcess _povRay;
    private readonly SemaphoreSlim _processes;
    private readonly FrameFiles _files;
    private readonly RunTimes _times;

    /// <param name="settings">Of the run.</param>
    /// <param name="model">The elevation model.</param>
    /// <param name="patterns">The scenes' meshes; disposed with this.</param>
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
        double? error = _settings.LevelOfDetailError;
        IReadOnlyList<SurfacePart> parts = _times.Measure(Phase.Selection, () => _model.SelectParts(frame, error));
        int made = _times.Measure(Phase.Patterns, () => _patterns.Ensure(parts, cancellation));
        IReadOnlyList<PixelRows> strips = PixelRows.Strips(
            frame.Camera.Height, error is null ? 1 : StripsFor(parts, threads), PovRayProcess.BlockRows);
        PovRayJob[] jobs = strips.Count == 1
            ? [JobOf(frame, parts, null, threads)]
            : Jobs(frame, parts, strips, threads / strips.Count, cancellation);
        await _processes.WaitAsync(cancellation).ConfigureAwait(false); // for another frame's POV-Ray, which has --timeout as its limit
        try
        {
            using Stream image = await DrawAsync(jobs, strips, cancellation).ConfigureAwait(false);
            void WriteScene(TextWriter writer) => PovSceneWriter.Write(writer, SceneOf(frame, parts), _patterns.FileNameOf);
            RenderedFrame rendered = new(
                RendererKind.PovRay, image, "POV-Ray's image", WriteScene, _model.Grid.PixelsPerDegree, TruthOf(frame));
            return new FrameOutputs(_files.Write(frame, rendered, cancellation), parts.Count, made);
        }
        finally
        {
            _processes.Release();
        }
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        _patterns.Dispose();
        _processes.Dispose();
    }

    /// <summary>
    /// POV-Ray parses with one thread: a scene that takes long is drawn in strips, one a core, each with the parts that it needs.
    /// </summary>
    private int StripsFor(IReadOnlyList<SurfacePart> parts, int threads) =>
        (int)Math.Clamp(_patterns.CountFaces(parts) / MinFacesOfStrip, 1, threads);

    /// <summary>
    /// Each strip takes its parts from those of the whole image: by itself it could do with coarser levels where shadows fall beyond its
    /// rows, and the pixels would depend on how many strips there are.
    /// </summary>
    private PovRayJob[] Jobs(
        Frame frame, IReadOnlyList<SurfacePart> parts, IReadOnlyList<PixelRows> strips, int threads, CancellationToken cancellation)
    {
        IReadOnlyList<SurfacePart>[] ofStrips = _times.Measure(
            Phase.Selection,
            () => strips.AsParallel().AsOrdered().WithCancellation(cancellation).Select(rows =>
            {
                PartArea area = new(_model.SelectParts(frame, _settings.LevelOfDetailError, rows));
                return (IReadOnlyList<SurfacePart>)[.. parts.Where(area.Overlaps)];
            }).ToArray());
        return [.. strips.Zip(ofStrips).Select(strip => JobOf(frame, strip.Second, strip.First, threads))];
    }

    private PovRayJob JobOf(Frame frame, IReadOnlyList<SurfacePart> parts, PixelRows? rows, int threads) => new(
        writer => PovSceneWriter.Write(writer, SceneOf(frame, parts), _patterns.FileNameOf),
        _patterns.Folder,
        _settings.OutputFolder,
        frame.Camera.Width,
        frame.Camera.Height,
        rows,
        threads,
        _settings.PovOptions,
        _settings.Timeout);

    private RenderScene SceneOf(Frame frame, IReadOnlyList<SurfacePart> parts) =>
        new(frame.Camera, frame.Light, _model.Grid.PixelsPerDegree, parts);

    /// <returns>The whole image as PNG; the same bytes however many strips it was drawn in.</returns>
    private async Task<Stream> DrawAsync(PovRayJob[] jobs, IReadOnlyList<PixelRows> strips, CancellationToken cancellation)
    {
        long start = System.Diagnostics.Stopwatch.GetTimestamp();
        PovRayImage[] images = new PovRayImage[jobs.Length];

        // When one run fails, the others are ended, and its own error is thrown.
        ParallelOptions allAtOnce = new() { MaxDegreeOfParallelism = jobs.Length, CancellationToken = cancellation };
        await Parallel.ForAsync(0, jobs.Length, allAtOnce, async (strip, stop) =>
            images[strip] = await _povRay.RenderAsync(jobs[strip], stop).ConfigureAwait(false)).ConfigureAwait(false);
        MemoryStream image = new();
        PngRaster.Join([.. images.Select(strip => strip.Raster)], [.. strips.Select(strip => strip.First)]).Write(image);
        image.Position = 0;
        _times.Add(Phase.PovRay, System.Diagnostics.Stopwatch.GetElapsedTime(start).TotalSeconds);
        _times.Add(Phase.Parse, images.Max(strip => strip.Times.ParseSeconds) ?? 0.0);
        _times.Add(Phase.Trace, images.Max(strip => strip.Times.TraceSeconds) ?? 0.0);
        return image;
    }

    private TracedFrameTruth? TruthOf(Frame frame) =>
        _settings.Surface == PixelSurface.Terrain ? new TracedFrameTruth(frame.Camera, frame.Light, _model.Tracer) : null;
}
