using System.Runtime.CompilerServices;
using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Mesh.Refining;
using Msisf.Core.Render;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.App.Rendering;

/// <summary>
/// The native renderers of a run: one for each terrain that a frame needs, as long as that is kept. Thread-safe.
/// </summary>
/// <param name="terrain">Chooses the terrain of a frame.</param>
internal sealed class NativeLevels(IFrameTerrain terrain)
{
    /// <summary>A collection takes some 20 ms, a view with new windows a second.</summary>
    private const int ViewsBetweenCollections = 2;

    private readonly ConditionalWeakTable<ITerrain, Lazy<NativeRenderer>> _renderers = [];
    private readonly ConditionalWeakTable<ITerrain, Lazy<TerrainTracer>> _tracers = [];
    private int _views;

    /// <summary>Bytes of the buffers that the renderers have replaced so far (<see cref="NativeRenderer.ReplacedBytes"/>).</summary>
    public long ReplacedBytes =>
        _renderers.Where(pair => pair.Value.IsValueCreated).Sum(pair => pair.Value.Value.ReplacedBytes);

    /// <summary>Releases the memory of renderers that have drawn nothing for some calls: a descent leaves its levels behind.</summary>
    /// <returns>Whether any was released.</returns>
    public bool ReleaseUnused()
    {
        bool isAny = false;
        foreach ((_, Lazy<NativeRenderer> renderer) in _renderers)
        {
            isAny |= renderer.IsValueCreated && renderer.Value.ReleaseIfUnused();
        }

        return isAny;
    }

    /// <summary>The renderer for a frame.</summary>
    public NativeRenderer For(PinholeCamera camera, int subsamplesPerAxis) => _renderers.GetValue(
        terrain.For(camera, subsamplesPerAxis), MakeRenderer).Value;

    /// <summary>Traces single rays through the surface that a frame shows.</summary>
    public ITerrainTracer TracerFor(PinholeCamera camera, int subsamplesPerAxis) => _tracers.GetValue(
        terrain.For(camera, subsamplesPerAxis), static drawn => new Lazy<TerrainTracer>(() => new TerrainTracer(drawn))).Value;

    private Lazy<NativeRenderer> MakeRenderer(ITerrain drawn)
    {
        if (drawn is RefinedView && Interlocked.Increment(ref _views) % ViewsBetweenCollections == 0)
        {
            // The large buffers of views that are no longer kept wait long for a collection of their own: a flight would have gigabytes.
            GC.Collect(GC.MaxGeneration, GCCollectionMode.Forced, blocking: true);
        }

        return new Lazy<NativeRenderer>(() => new NativeRenderer(drawn));
    }
}
