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
/// <param name="memory">Buffers of the renderers; null for those that keep the buffers of all frames.</param>
internal sealed class NativeLevels(IFrameTerrain terrain, RendererMemory? memory = null)
{
    private readonly ConditionalWeakTable<ITerrain, Lazy<NativeRenderer>> _renderers = [];
    private readonly ConditionalWeakTable<ITerrain, Lazy<TerrainTracer>> _tracers = [];
    private readonly RendererMemory _memory = memory ?? new RendererMemory();

    /// <summary>Bytes of the buffers that the renderers have replaced so far (<see cref="RendererMemory.ReplacedBytes"/>).</summary>
    public long ReplacedBytes => _memory.ReplacedBytes;

    /// <summary>The renderer for a frame.</summary>
    public NativeRenderer For(ICamera camera, int subsamplesPerAxis) => _renderers.GetValue(
        terrain.For(camera, subsamplesPerAxis), MakeRenderer).Value;

    /// <summary>The first invented part of a frame (<see cref="ITerrain.FirstInventedPart"/>).</summary>
    public int? FirstInventedPart(ICamera camera, int subsamplesPerAxis) => terrain.For(camera, subsamplesPerAxis).FirstInventedPart;

    /// <summary>Traces single rays through the surface that a frame shows.</summary>
    public ITerrainTracer TracerFor(ICamera camera, int subsamplesPerAxis) => _tracers.GetValue(
        terrain.For(camera, subsamplesPerAxis), static drawn => new Lazy<TerrainTracer>(() => new TerrainTracer(drawn))).Value;

    private Lazy<NativeRenderer> MakeRenderer(ITerrain drawn) => new(() => new NativeRenderer(drawn, _memory));
}
