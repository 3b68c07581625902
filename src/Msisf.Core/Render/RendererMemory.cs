using System.Collections.Concurrent;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;

namespace Msisf.Core.Render;

/// <summary>
/// The buffers of frames, which several renderers may share: those of the levels of a descent, or of the places of a flight, each draw few
/// frames. Safe for several threads.
/// </summary>
public sealed class RendererMemory
{
    private readonly ConcurrentBag<FramePass> _idle = [];
    private readonly ConcurrentBag<WeakReference<FramePass>> _large = [];
    private readonly LensCache _lenses = new();
    private long _replacedBytes;

    /// <summary>
    /// Bytes of the buffers that frames have replaced by smaller or larger ones so far; they are free, but no collection may have returned
    /// them to the system.
    /// </summary>
    public long ReplacedBytes => Interlocked.Read(ref _replacedBytes);

    /// <summary>
    /// px: buffers of larger frames are kept until the next garbage collection only. By default all are kept, as is good for a series of
    /// like frames.
    /// </summary>
    public long LargestKept { get; init; } = long.MaxValue;

    /// <summary>Takes buffers to draw a frame of a surface.</summary>
    /// <param name="pixels">Number of the frame's pixels.</param>
    internal FramePass Take(SurfaceModel surface, long pixels)
    {
        if (TakeIdle(isLarge: pixels > LargestKept) is not { } pass)
        {
            return new FramePass(surface, _lenses);
        }

        if (pass.Shown != surface)
        {
            pass.Show(surface);
        }

        return pass;
    }

    /// <summary>Gives buffers back whose frame is done with.</summary>
    internal void Return(FramePass pass)
    {
        if (pass.Capacity > LargestKept)
        {
            _large.Add(new WeakReference<FramePass>(pass));
        }
        else
        {
            _idle.Add(pass);
        }
    }

    /// <summary>Counts bytes of replaced buffers.</summary>
    internal void AddReplaced(long bytes) => Interlocked.Add(ref _replacedBytes, bytes);

    private FramePass? TakeIdle(bool isLarge)
    {
        FramePass? pass = null;
        if (!isLarge)
        {
            return _idle.TryTake(out pass) ? pass : null;
        }

        while (pass is null && _large.TryTake(out WeakReference<FramePass>? large))
        {
            large.TryGetTarget(out pass);
        }

        return pass;
    }
}
