using Msisf.App.Preparation;

namespace Msisf.App.Rendering;

/// <summary>Renders the images of a run and writes their files. Thread-safe.</summary>
internal interface IFrameRenderer : IDisposable
{
    /// <summary>
    /// Number of frames that may be begun in addition to those that are drawn, so that drawing does not wait for their preparation, which
    /// needs few resources.
    /// </summary>
    int FramesAhead { get; }

    /// <summary>Makes one frame. Its files appear when all are complete, the image last.</summary>
    /// <param name="cancellation">Cancels the work; no file is left.</param>
    Task<FrameOutputs> RenderAsync(Frame frame, int threads, CancellationToken cancellation);
}

/// <summary>The renderers of a run: one for each camera.</summary>
/// <param name="cameras">Disposed with this object.</param>
internal sealed class RendererOfRun(IReadOnlyList<IFrameRenderer> cameras) : IFrameRenderer
{
    public int FramesAhead => cameras[0].FramesAhead;

    public Task<FrameOutputs> RenderAsync(Frame frame, int threads, CancellationToken cancellation) =>
        cameras[frame.CameraIndex].RenderAsync(frame, threads, cancellation);

    public void Dispose()
    {
        foreach (IFrameRenderer camera in cameras)
        {
            camera.Dispose();
        }
    }
}

/// <summary>The files of one finished frame.</summary>
/// <param name="Paths">Paths of the files, in the order in which they are shown to the user.</param>
/// <param name="TileCount">Number of patterns that the scene includes.</param>
/// <param name="PatternsMade">Number of patterns that were made for the frame.</param>
/// <param name="WasThere">Whether the frame was already complete, or another process made it.</param>
internal sealed record FrameOutputs(IReadOnlyList<string> Paths, int TileCount, int PatternsMade, bool WasThere = false);
