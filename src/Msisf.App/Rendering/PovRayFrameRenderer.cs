using Msisf.Adapters.Render;
using Msisf.Adapters.Scene;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using Msisf.Core.Render;
using Msisf.Core.Scene;

namespace Msisf.App.Rendering;

/// <summary>
/// Renders frames with POV-Ray: selects the meshes, makes their patterns and the scene, runs POV-Ray, and writes the files.
/// </summary>
/// <param name="surface">The elevation model as meshes; disposed with this object.</param>
/// <param name="povRay">Starts POV-Ray.</param>
/// <param name="albedo">The map of the surface's reflectance; null for even grey.</param>
/// <param name="processes">Maximum number of POV-Ray processes at once; the meshes of the next frame are made while they run.</param>
/// <param name="smallProcesses">The same of processes with small scenes.</param>
/// <param name="files">Writes a frame's files.</param>
internal sealed class PovRayFrameRenderer(
    RenderSettings settings, ISceneSurface surface, PovRayProcess povRay, PovAlbedo? albedo, int processes, int smallProcesses,
    FrameFiles files, RunTimes times) : IFrameRenderer
{
    /// <summary>
    /// Minimum number of triangles per strip. With fewer, a second process costs more than it saves (0.65 s of sleeping, and the parsing of
    /// shared blocks): parsing a triangle takes about 2 microseconds.
    /// </summary>
    private const long MinFacesOfStrip = 250_000;

    /// <summary>
    /// Maximum number of triangles of a scene that POV-Ray draws in so short a time that its 0.65 s of sleeping are a good part of it, with
    /// so little memory (some 0.25 GB) that there may be more processes than cores.
    /// </summary>
    private const long MaxFacesOfSmallScene = 250_000;

    private readonly ProcessSlots _processes = new(processes, smallProcesses);

    public int FramesAhead { get; } = smallProcesses - processes + 1;

    public async Task<FrameOutputs> RenderAsync(Frame frame, int threads, CancellationToken cancellation)
    {
        ISceneMeshes meshes = times.Measure(Phase.Selection, () => surface.Select(frame, threads, cancellation));
        int made = times.Measure(Phase.Patterns, () => meshes.Ensure(cancellation));
        long faces = meshes.Faces;
        IReadOnlyList<PixelRows> strips = PixelRows.Strips(
            frame.Camera.Height, settings.LevelOfDetailError is null ? 1 : StripsFor(faces, threads), PovRayProcess.BlockRows);
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
            return new FrameOutputs(files.Write(frame, rendered, cancellation), meshes.FileNames.Count, made);
        }
    }

    public void Dispose()
    {
        surface.Dispose();
        _processes.Dispose();
    }

    /// <summary>
    /// The number of strips in which an image is drawn. POV-Ray parses with one thread, so a large scene is drawn in up to one strip per
    /// thread, each with only the blocks that it needs.
    /// </summary>
    private static int StripsFor(long faces, int threads) => (int)Math.Clamp(faces / MinFacesOfStrip, 1, threads);

    /// <summary>Makes one POV-Ray job per strip.</summary>
    private PovRayJob[] Jobs(
        Frame frame, ISceneMeshes meshes, IReadOnlyList<PixelRows> strips, int threads, CancellationToken cancellation)
    {
        IReadOnlyList<string>[] ofStrips = times.Measure(
            Phase.Selection,
            () => strips.AsParallel().AsOrdered().WithCancellation(cancellation)
                .Select(rows => meshes.FileNamesFor(rows, cancellation)).ToArray());
        return [.. strips.Zip(ofStrips).Select(strip => JobOf(SceneOf(frame, meshes, strip.Second), strip.First, threads))];
    }

    private PovRayJob JobOf(RenderScene scene, PixelRows? rows, int threads) => new(
        writer => PovSceneWriter.Write(writer, scene),
        surface.Folder,
        settings.OutputFolder,
        scene.Camera.Width,
        scene.Camera.Height,
        rows,
        threads,
        settings.PovOptions,
        settings.Timeout);

    private RenderScene SceneOf(Frame frame, ISceneMeshes meshes, IReadOnlyList<string> patterns) =>
        new(frame.FrameCamera, frame.Light, surface.FolderName, patterns, albedo?.For(frame.FrameCamera)) { Axes = meshes.Axes };

    /// <returns>The whole image as PNG; its bytes do not depend on the number of strips.</returns>
    private async Task<Stream> DrawAsync(PovRayJob[] jobs, IReadOnlyList<PixelRows> strips, CancellationToken cancellation)
    {
        long start = System.Diagnostics.Stopwatch.GetTimestamp();
        PovRayImage[] images = new PovRayImage[jobs.Length];

        // If one process fails, the others are ended and its exception is thrown.
        ParallelOptions allAtOnce = new() { MaxDegreeOfParallelism = jobs.Length, CancellationToken = cancellation };
        await Parallel.ForAsync(0, jobs.Length, allAtOnce, async (strip, stop) =>
            images[strip] = await povRay.RenderAsync(jobs[strip], stop).ConfigureAwait(false)).ConfigureAwait(false);
        MemoryStream image = new();
        PngRaster.Join([.. images.Select(strip => strip.Raster)], [.. strips.Select(strip => strip.First)]).Write(image);
        image.Position = 0;
        times.Add(Phase.PovRay, System.Diagnostics.Stopwatch.GetElapsedTime(start).TotalSeconds);
        times.Add(Phase.Parse, images.Max(strip => strip.Times.ParseSeconds) ?? 0.0);
        times.Add(Phase.Trace, images.Max(strip => strip.Times.TraceSeconds) ?? 0.0);
        return image;
    }

    private TracedFrameTruth? TruthOf(Frame frame, ISceneMeshes meshes) =>
        settings.Surface == PixelSurface.Terrain ? new TracedFrameTruth(frame.Camera, frame.Light, meshes.Tracer) : null;
}

/// <summary>
/// Limits how many POV-Ray processes run at once, with a higher limit for small ones, which sleep a good part of their time. Thread-safe.
/// </summary>
/// <param name="large">Maximum number of processes if all are large, at least 1.</param>
/// <param name="small">Maximum number of processes if all are small, a multiple of that.</param>
internal sealed class ProcessSlots(int large, int small) : IDisposable
{
    private readonly SemaphoreSlim _all = new(small);
    private readonly SemaphoreSlim _taking = new(1);
    private readonly int _ofLarge = small / large;

    /// <summary>Waits until a process may run.</summary>
    /// <returns>Is disposed when the process has ended.</returns>
    public async Task<IDisposable> TakeAsync(bool isSmall, CancellationToken cancellation)
    {
        int slots = isSmall ? 1 : _ofLarge;
        int taken = 0;
        await _taking.WaitAsync(cancellation).ConfigureAwait(false); // two that have half of their slots would wait for each other
        try
        {
            for (; taken < slots; taken++)
            {
                await _all.WaitAsync(cancellation).ConfigureAwait(false);
            }

            return new Taken(_all, slots);
        }
        catch (OperationCanceledException) when (taken > 0)
        {
            _all.Release(taken);
            throw;
        }
        finally
        {
            _taking.Release();
        }
    }

    public void Dispose()
    {
        _all.Dispose();
        _taking.Dispose();
    }

    private sealed class Taken(SemaphoreSlim all, int slots) : IDisposable
    {
        public void Dispose() => all.Release(slots);
    }
}
