using Msisf.App.Preparation;

namespace Msisf.App.Rendering;

/// <summary>Makes the images of a run and writes their files. Safe for several threads.</summary>
internal interface IFrameRenderer : IDisposable
{
    /// <summary>
    /// So many frames more than are drawn at once may be begun: their preparation needs little, and drawing then waits for nothing.
    /// </summary>
    int FramesAhead { get; }

    /// <summary>Makes one frame. Its files appear when all are complete, the image last.</summary>
    /// <param name="frame">Which.</param>
    /// <param name="threads">Threads that it may use.</param>
    /// <param name="cancellation">Ends it and leaves no file.</param>
    Task<FrameOutputs> RenderAsync(Frame frame, int threads, CancellationToken cancellation);
}
