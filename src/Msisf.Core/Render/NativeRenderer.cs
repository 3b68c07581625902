using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Parallel;
using Msisf.Core.Render.Options;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Render;

/// <summary>
/// Draws exact images directly from an elevation model at video rate (docs/native-renderer.md). Data that frames share is kept from frame
/// to frame. Only the parts of the model that a frame needs are read. Safe for several threads.
/// </summary>
public sealed class NativeRenderer
{
    private readonly SurfaceModel _surface;
    private readonly RendererMemory _memory;

    /// <summary>Makes a renderer; nothing of the model is read yet.</summary>
    /// <param name="terrain">The elevation model, or several.</param>
    /// <param name="memory">Buffers that other renderers use too; null for own ones.</param>
    public NativeRenderer(ITerrain terrain, RendererMemory? memory = null)
    {
        _surface = SurfaceModel.Of(terrain);
        _memory = memory ?? new RendererMemory();
        Terrain = terrain;
        Resolution = terrain.Resolution;
        PartResolutions = terrain.DrawnResolutions;
    }

    /// <summary>The elevation model, or several.</summary>
    public ITerrain Terrain { get; }

    /// <summary>Resolution of the model that is drawn, of several that of the finest that is there.</summary>
    public GridResolution Resolution { get; }

    /// <summary>
    /// Resolution at which each of several models is drawn; null for one that is left out. Empty for one model.
    /// With invented detail it has entries for any number of models, and for the windows.
    /// </summary>
    public IReadOnlyList<GridResolution?> PartResolutions { get; }

    /// <summary>Bytes of the buffers that frames have replaced so far (<see cref="RendererMemory.ReplacedBytes"/>).</summary>
    public long ReplacedBytes => _memory.ReplacedBytes;

    /// <summary>Draws a frame.</summary>
    /// <param name="camera">The camera, which must be above the terrain.</param>
    /// <param name="light">The Sun, or a lamp at the camera, whose shadows are never visible.</param>
    /// <param name="options">The settings of the renderer.</param>
    /// <param name="threads">Number of threads, at least 1; the frame does not depend on it.</param>
    /// <returns>The frame. Dispose it so that later frames can use its memory.</returns>
    /// <exception cref="OperationCanceledException">It was cancelled.</exception>
    public NativeFrame Render(
        ICamera camera, SceneLight light, NativeRenderOptions options, int threads, CancellationToken cancellation = default)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(threads, 1);
        return camera.Bands is [CameraBand only]
            ? Render(only.Camera, light, options, threads, cancellation)
            : RenderBands(camera, light, options, threads, cancellation);
    }

    /// <summary>The corners of a facet, m, body-fixed.</summary>
    internal (Vector3D A, Vector3D B, Vector3D C) CornersOf(FacetId facet) => _surface.CornersOf(facet);

    private NativeFrame Render(
        FrameCamera camera, SceneLight light, NativeRenderOptions options, int threads, CancellationToken cancellation)
    {
        NativeFrame frame = RenderIn(light, camera, options, threads, cancellation);
        if (options.Second is not { } second)
        {
            return frame;
        }

        try
        {
            // The factors of a frame count in its own light, sunlight at the body.
            double sun = light.PositionBodyFixed.Length / AstronomicalConstants.AstronomicalUnit;
            NativeRenderOptions ofSecond = options with { KeepGroundTruth = false, Indirect = null, Progress = null };
            using NativeFrame other = RenderIn(second.Light, camera, ofSecond, threads, cancellation);
            frame.AddLight(other, second.OverSunlight * sun * sun);
            return frame;
        }
        catch
        {
            frame.Dispose();
            throw;
        }
    }

    private NativeFrame RenderIn(
        SceneLight light, FrameCamera camera, NativeRenderOptions options, int threads, CancellationToken cancellation)
    {
        FramePass pass = _memory.Take(_surface, (long)camera.Width * camera.Height);
        long before = pass.ReplacedBytes;
        pass.Draw(camera, light, options, threads, cancellation);
        _memory.AddReplaced(pass.ReplacedBytes - before);
        return new NativeFrame(pass, () => _memory.Return(pass));
    }

    /// <summary>Draws some rows of an image, in memory of their own.</summary>
    /// <param name="options">The settings of the renderer.</param>
    /// <param name="threads">Number of threads, at least 1; the rows do not depend on it.</param>
    public NativeFrame RenderRows(
        ICamera camera, SceneLight light, PixelRows rows, NativeRenderOptions options, int threads, CancellationToken cancellation) =>
        RenderBands(
            camera.Window(0, rows.First, camera.Width, rows.End - rows.First), light.At(camera, rows.First + 1), options, threads,
            cancellation);

    private NativeFrame RenderBands(
        ICamera camera, SceneLight light, NativeRenderOptions options, int threads, CancellationToken cancellation)
    {
        DrawnBands drawn = new(camera, light);
        int atOnce = Math.Min(threads, camera.Bands.Count);
        WorkerTeam.Run(
            atOnce,
            camera.Bands.Count,
            (_, index) =>
            {
                (PixelRows rows, FrameCamera band) = camera.Bands[index];
                using NativeFrame frame = Render(band, light.Of(band.State), options, threads / atOnce, cancellation);
                drawn.Take(frame, rows.First, options.KeepGroundTruth);
            },
            cancellation);
        return new NativeFrame(drawn, static () => { });
    }
}

/// <summary>The renderer that makes an image.</summary>
public enum RendererKind
{
    /// <summary>POV-Ray, which draws the pattern files.</summary>
    PovRay,

    /// <summary>The program's own renderer, which draws the elevation model.</summary>
    Native,
}
