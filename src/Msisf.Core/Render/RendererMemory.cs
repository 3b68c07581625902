using System.Collections.Concurrent;
using Msisf.Core.Surface;

namespace Msisf.Core.Render;

/// <summary>
/// The buffers of frames, which several renderers may share: those of the levels of a descent, or of the places of a flight, each draw few
/// frames. Safe for several threads.
/// </summary>
public sealed class RendererMemory
{
    private readonly ConcurrentBag<FramePass> _idle = [];
    private long _replacedBytes;

    /// <summary>
    /// Bytes of the buffers that frames have replaced by smaller or larger ones so far; they are free, but no collection may have returned
    /// them to the system.
    /// </summary>
    public long ReplacedBytes => Interlocked.Read(ref _replacedBytes);

    /// <summary>Takes buffers to draw a frame of a surface.</summary>
    internal FramePass Take(SurfaceModel surface)
    {
        if (!_idle.TryTake(out FramePass? pass))
        {
            return new FramePass(surface);
        }

        if (pass.Shown != surface)
        {
            pass.Show(surface);
        }

        return pass;
    }

    /// <summary>Gives buffers back whose frame is done with.</summary>
    internal void Return(FramePass pass) => _idle.Add(pass);

    /// <summary>Counts bytes of replaced buffers.</summary>
    internal void AddReplaced(long bytes) => Interlocked.Add(ref _replacedBytes, bytes);
}
