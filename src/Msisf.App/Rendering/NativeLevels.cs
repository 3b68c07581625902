using System.Collections.Concurrent;
using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Render;
using Msisf.Core.Terrain;

namespace Msisf.App.Rendering;

/// <summary>The native renderers of a run: one for the model, and one for each coarser level that a frame needs. Thread-safe.</summary>
internal sealed class NativeLevels
{
    private readonly ConcurrentDictionary<int, Lazy<NativeRenderer>> _renderers = new();
    private readonly ITerrainGrid _grid;
    private readonly LodLevels? _levels;
    private readonly DetailRule? _rule;

    /// <summary>Prepares the renderers of a model.</summary>
    /// <param name="grid">The model.</param>
    /// <param name="levels">Opens its coarser levels.</param>
    /// <param name="errorPixels">
    /// px: how far coarser levels may shift a point in the image; null to draw from the full model always.
    /// </param>
    public NativeLevels(ITerrainGrid grid, Func<LodLevels> levels, double? errorPixels)
    {
        _grid = grid;
        _levels = errorPixels is null ? null : levels();
        _rule = errorPixels is double error ? new DetailRule(_levels!, error) : null;
    }

    /// <summary>The renderer for a frame.</summary>
    public NativeRenderer For(PinholeCamera camera, int subsamplesPerAxis)
    {
        int level = _rule?.LevelOfImage(camera.Footprint, subsamplesPerAxis) ?? 0;
        return _renderers.GetOrAdd(level, Create).Value;
    }

    private Lazy<NativeRenderer> Create(int level) => new(() => new NativeRenderer(level == 0 ? _grid : _levels!.Level(level)));
}
