using Msisf.Adapters.Render;
using Msisf.Adapters.Scene;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Scene;

namespace Msisf.App.Rendering;

/// <summary>
/// Renders frames with POV-Ray: selects the meshes, makes their patterns and the scene, runs POV-Ray, and writes the files.
/// </summary>
internal sealed class PovRayFrameRenderer : IFrameRenderer
{
    /// <summary>
    /// Minimum number of triangles per strip. With fewer, a second process costs more (0.65 s of sleeping, and the parsing of shared parts)
    /// than it saves: parsing a triangle takes about 2 microseconds.
    /// </summary>
    private const long MinFacesOfStrip = 250_000;

    /// <summary>
    /// Maximum number of triangles of a scene that POV-Ray draws in so short a time that its 0.65 s of sleeping are a good part of it, with
    /// so little memory (some 0.25 GB) that there may be more processes than cores.
    /// </summary>
    private const long MaxFacesOfSmallScene = 250_000;

    private readonly RenderSettings _settings;
    private readonly ISceneSurface _surface;
    private readonly PovRayProcess _povRay;
    private readonly PovAlbedo? _albedo;
    private readonly ProcessSlots _processes;
    private readonly FrameFiles _files;
    private readonly RunTimes _times;

    /// <param name="settings">Settings of the run.</param>
    /// <param name="surface">The elevation model as meshes; disposed with this object.</param>
    /// <param name="povRay">Starts POV-Ray.</param>
    /// <param name="albedo">The map of the surface's reflectance; null for even grey.</param>
    /// <param name="processes">Maximum number of POV-Ray processes at once; the meshes of the next frame are made while they run.</param>
    /// <param name="smallProcesses">The same of processes with small scenes.</param>
    /// <param name="files">Writes a frame's files.</param>
    /// <param name="times">Times of the parts of the run.</param>
    public PovRayFrameRenderer(
        RenderSettings settings,
        ISceneSurface surface,
        PovRayProcess povRay,
        PovAlbedo? albedo,
        int processes,
        int smallProcesses,
        FrameFiles files,
        RunTimes times)
    {
        _settings = settings;
        _surface = surface;
        _povRay = povRay;
        _albedo = albedo;
        _processes = new ProcessSlots(processes, smallProcesses);
        FramesAhead = smallProcesses - processes + 1;
        _files = files;
        _times = times;
    }

    public int FramesAhead { get; }

    public async Task<FrameOutputs> RenderAsync(Frame frame, int threads, CancellationToken cancellation)
    {
        ISceneMeshes meshes = _times.Measure(Phase.Selection, () => _surface.Select(frame, threads, cancellation));
        int made = _times.Measure(Phase.Patterns, () => meshes.Ensure(cancellation));
        long faces = meshes.Faces;
        IReadOnlyList<PixelRows> strips = PixelRows.Strips(
            frame.Camera.Height, _settings.LevelOfDetailError is null ? 1 : StripsFor(faces, threads), PovRayProcess.BlockRows);
        PovRayJob[] jobs = strips.Count == 1
            ? [JobOf(SceneOf(frame, meshes, meshes.FileNames), null, threads)]
            : Jobs(frame, meshes, strips, threads / strips.Count, cancellation);

        // Waits for another frame's POV-Ray, which has --timeout as its limit.
        using (await _processes.TakeAsync(faces <= MaxFacesOfSmallScene, cancellation).ConfigureAwait(false))
        {
            using Stream image = await DrawAsync(jobs, strips, cancellation).ConfigureAwait(false);
            void WriteScene(TextWriter writer) => PovSceneWriter.Write(writer, SceneOf(frame, meshes, meshes.FileNames));
            RenderedFrame rendered = new(
                RendererKind.PovRay, image, "POV-Ray's image", WriteScene, meshes.TracedResolution, meshes.Levels,
                TruthOf(frame, meshes))
            {
                PartResolutions = meshes.PartResolutions,
            };
            return new FrameOutputs(_files.Write(frame, rendered, cancellation), meshes.FileNames.Count, made);
        }
    }

    public void Dispose()
    {
        _surface.Dispose();
        _processes.Dispose();
    }

    /// <summary>
    /// The number of strips in which an image is drawn. POV-Ray parses with one thread, so a large scene is drawn in up to one strip per
    /// thread, each with only the parts that it needs.
    /// </summary>
    private static int StripsFor(long faces, int threads) => (int)Math.Clamp(faces / MinFacesOfStrip, 1, threads);

    /// <summary>Makes one POV-Ray job per strip.</summary>
    private PovRayJob[] Jobs(
        Frame frame, ISceneMeshes meshes, IReadOnlyList<PixelRows> strips, int threads, CancellationToken cancellation)
    {
        IReadOnlyList<string>[] ofStrips = _times.Measure(
            Phase.Selection,
            () => strips.AsParallel().AsOrdered().WithCancellation(cancellation)
                .Select(rows => meshes.FileNamesFor(rows, cancellation)).ToArray());
        return [.. strips.Zip(ofStrips).Select(strip => JobOf(SceneOf(frame, meshes, strip.Second), strip.First, threads))];
    }

    private PovRayJob JobOf(RenderScene scene, PixelRows? rows, int threads) => new(
        writer => PovSceneWriter.Write(writer, scene),
        _surface.Folder,
        _settings.OutputFolder,
        scene.Camera.Width,
        scene.Camera.Height,
        rows,
        threads,
        _settings.PovOptions,
        _settings.Timeout);

    private RenderScene SceneOf(Frame frame, ISceneMeshes meshes, IReadOnlyList<string> patterns) =>
        new(frame.FrameCamera, frame.Light, _surface.FolderName, patterns, _albedo?.For(frame.FrameCamera)) { Axes = meshes.Axes };

    /// <returns>The whole image as PNG; its bytes do not depend on the number of strips.</returns>
    private async Task<Stream> DrawAsync(PovRayJob[] jobs, IReadOnlyList<PixelRows> strips, CancellationToken cancellation)
    {
        long start = System.Diagnostics.Stopwatch.GetTimestamp();
        PovRayImage[] images = new PovRayImage[jobs.Length];

        // If one process fails, the others are ended and its exception is thrown.
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

    private TracedFrameTruth? TruthOf(Frame frame, ISceneMeshes meshes) =>
        _settings.Surface == PixelSurface.Terrain ? new TracedFrameTruth(frame.Camera, frame.Light, meshes.Tracer) : null;
}
