using System.Collections.Concurrent;
using Msisf.Core.Camera;
using Msisf.Core.Mesh;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;

namespace Msisf.Core.Render;

/// <summary>
/// Draws images straight from an elevation model, exactly and at video rate (docs/native-renderer.md). What frames share is kept from
/// frame to frame; nothing of the model is read that no frame needs. Safe for several threads.
/// </summary>
public sealed class NativeRenderer
{
    private readonly SurfaceModel _surface;
    private readonly ConcurrentBag<FramePass> _idle = [];

    /// <summary>Takes the model; reads nothing of it yet.</summary>
    /// <param name="grid">The whole Moon.</param>
    public NativeRenderer(IElevationGrid grid) => _surface = new SurfaceModel(grid);

    /// <summary>Samples a degree of the model that is drawn.</summary>
    public int PixelsPerDegree => _surface.Grid.PixelsPerDegree;

    /// <summary>Draws a frame.</summary>
    /// <param name="camera">Above the terrain.</param>
    /// <param name="light">The Sun; or a lamp at the camera, which throws no shadow that is seen.</param>
    /// <param name="options">How.</param>
    /// <param name="threads">Threads to use, at least 1; the frame is the same whatever their number.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <returns>The frame; it holds memory that further frames use again once it is disposed.</returns>
    /// <exception cref="OperationCanceledException">It was cancelled.</exception>
    public NativeFrame Render(
        PinholeCamera camera, SceneLight light, NativeRenderOptions options, int threads, CancellationToken cancellation = default)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(threads, 1);
        if (!_idle.TryTake(out FramePass? pass))
        {
            pass = new FramePass(_surface);
        }

        pass.Draw(camera, light, options, threads, cancellation);
        return new NativeFrame(pass, _idle.Add);
    }
}
