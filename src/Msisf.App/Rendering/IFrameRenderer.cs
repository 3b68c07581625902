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
    /// <param name="frame">The frame.</param>
    /// <param name="threads">Number of threads that it may use.</param>
    /// <param name="cancellation">Cancels the work; no file is left.</param>
    Task<FrameOutputs> RenderAsync(Frame frame, int threads, CancellationToken cancellation);
}
