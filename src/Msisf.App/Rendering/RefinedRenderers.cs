using Msisf.Core.Camera;
using Msisf.Core.Mesh.Refining;
using Msisf.Core.Render;

namespace Msisf.App.Rendering;

/// <summary>The native renderers of a terrain with invented detail: one for each surface that frames see. Thread-safe.</summary>
/// <param name="terrain">The terrain.</param>
internal sealed class RefinedRenderers(RefinedTerrain terrain)
{
    /// <summary>Renderers that are kept, with the memory of their frames; frames drawn at one time may need some each.</summary>
    private const int Kept = 2;

    private readonly Lock _gate = new();
    private readonly LinkedList<(RefinedView View, Lazy<NativeRenderer> Renderer)> _renderers = [];
    private long _droppedBytes;
    private int _dropped;

    /// <summary>Bytes of the buffers that the renderers have replaced so far, dropped ones included.</summary>
    public long ReplacedBytes
    {
        get
        {
            lock (_gate)
            {
                return _droppedBytes
                    + _renderers.Where(known => known.Renderer.IsValueCreated).Sum(known => known.Renderer.Value.ReplacedBytes);
            }
        }
    }

    /// <summary>The renderer for a frame.</summary>
    public NativeRenderer For(PinholeCamera camera, int subsamplesPerAxis)
    {
        RefinedView view = terrain.For(camera, subsamplesPerAxis);
        return Known(view).Value; // made outside of the lock: joining the windows takes time
    }

    private Lazy<NativeRenderer> Known(RefinedView view)
    {
        lock (_gate)
        {
            var known = _renderers.FirstOrDefault(renderer => renderer.View == view);
            if (known.View is not null)
            {
                _renderers.Remove(known);
            }
            else
            {
                known = (view, new Lazy<NativeRenderer>(() => new NativeRenderer(view)));
            }

            _renderers.AddFirst(known);
            if (_renderers.Count > Kept)
            {
                Lazy<NativeRenderer> dropped = _renderers.Last!.Value.Renderer;
                _droppedBytes += dropped.IsValueCreated ? dropped.Value.ReplacedBytes : 0;
                _renderers.RemoveLast();
                if (++_dropped % Kept == 0)
                {
                    // Large buffers wait long for a collection of their own: a flight would have a gigabyte of them.
                    GC.Collect(GC.MaxGeneration, GCCollectionMode.Forced, blocking: true);
                }
            }

            return known.Renderer;
        }
    }
}
