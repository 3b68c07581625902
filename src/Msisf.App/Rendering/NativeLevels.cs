using System.Collections.Concurrent;
using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Mesh.Refining;
using Msisf.Core.Render;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.App.Rendering;

/// <summary>The native renderers of a run: one for the model, and one for each coarser level that a frame needs. Thread-safe.</summary>
internal sealed class NativeLevels
{
    private readonly ConcurrentDictionary<int, Lazy<NativeRenderer>> _renderers = new();
    private readonly ConcurrentDictionary<int, Lazy<TerrainTracer>> _tracers = new();
    private readonly ITerrain _grid;
    private readonly TerrainLevels? _levels;
    private readonly DetailRule? _rule;
    private readonly RefinedRenderers? _refined;

    /// <summary>Prepares the renderers of a model.</summary>
    /// <param name="grid">The model.</param>
    /// <param name="levels">Opens its coarser levels, if it has any.</param>
    /// <param name="errorPixels">
    /// px: how far coarser levels may shift a point in the image; null to draw from the full model always.
    /// </param>
    public NativeLevels(ITerrain grid, Func<TerrainLevels?> levels, double? errorPixels)
    {
        _grid = grid;
        _refined = grid is RefinedTerrain terrain ? new RefinedRenderers(terrain) : null;
        _levels = errorPixels is null ? null : levels();
        _rule = _levels is not null && errorPixels is double error ? new DetailRule(_levels, error) : null;
    }

    /// <summary>Bytes of the buffers that the renderers have replaced so far (<see cref="NativeRenderer.ReplacedBytes"/>).</summary>
    public long ReplacedBytes =>
        _refined?.ReplacedBytes
            ?? _renderers.Values.Where(renderer => renderer.IsValueCreated).Sum(renderer => renderer.Value.ReplacedBytes);

    /// <summary>The renderer for a frame.</summary>
    public NativeRenderer For(PinholeCamera camera, int subsamplesPerAxis) => _refined is not null
        ? _refined.For(camera, subsamplesPerAxis)
        : _renderers.GetOrAdd(
            LevelFor(camera, subsamplesPerAxis), level => new Lazy<NativeRenderer>(() => new NativeRenderer(GridOf(level)))).Value;

    /// <summary>Traces single rays through the surface that a frame shows.</summary>
    public ITerrainTracer TracerFor(PinholeCamera camera, int subsamplesPerAxis) => _refined is not null
        ? new TerrainTracer(_refined.For(camera, subsamplesPerAxis).Terrain)
        : _tracers.GetOrAdd(
            LevelFor(camera, subsamplesPerAxis), level => new Lazy<TerrainTracer>(() => new TerrainTracer(GridOf(level)))).Value;

    private int LevelFor(PinholeCamera camera, int subsamplesPerAxis) =>
        _rule?.LevelOfImage(camera.Footprint, subsamplesPerAxis) ?? 0;

    private ITerrain GridOf(int level) => level == 0 ? _grid : _levels!.Grid(level);
}
