using System.Runtime.CompilerServices;
using Msisf.Core.Camera;
using Msisf.Core.Lod;
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
    private readonly ConditionalWeakTable<ITerrain, Lazy<NativeRenderer>> _renderers = [];
    private readonly ConditionalWeakTable<ITerrain, Lazy<TerrainTracer>> _tracers = [];

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
        terrain.For(camera.Footprint, subsamplesPerAxis), static drawn => new Lazy<NativeRenderer>(() => new NativeRenderer(drawn))).Value;

    /// <summary>Traces single rays through the surface that a frame shows.</summary>
    public ITerrainTracer TracerFor(PinholeCamera camera, int subsamplesPerAxis) => _tracers.GetValue(
        terrain.For(camera.Footprint, subsamplesPerAxis), static drawn => new Lazy<TerrainTracer>(() => new TerrainTracer(drawn))).Value;
}
