using System.Collections.Concurrent;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tiles;

/// <summary>
/// Makes the meshes of a model and of its levels of detail; each level is prepared when it is first needed. Safe for several threads.
/// </summary>
public sealed class LevelMeshBuilders
{
    private readonly ConcurrentDictionary<int, Lazy<TileMeshBuilder>> _builders = new();
    private readonly IGlobalGrid _grid;
    private readonly Func<LodLevels> _levels;

    /// <summary>Takes the model.</summary>
    /// <param name="levels">Gives its levels; called when one is first needed, from any thread.</param>
    public LevelMeshBuilders(IGlobalGrid grid, Func<LodLevels> levels)
    {
        _grid = grid;
        _levels = levels;
    }

    /// <summary>PRODUCT_ID of the model.</summary>
    public string ProductId => _grid.ProductId;

    /// <summary>Samples a degree of the model itself.</summary>
    public int PixelsPerDegree => _grid.PixelsPerDegree;

    /// <summary>The builder of a level.</summary>
    /// <param name="level">0 for the model itself.</param>
    public TileMeshBuilder Of(int level) =>
        _builders.GetOrAdd(
            level, known => new Lazy<TileMeshBuilder>(() => new TileMeshBuilder(known == 0 ? _grid : _levels().Level(known)))).Value;
}
