using System.Collections.Concurrent;
using Msisf.Core.Terrain.Lod;

namespace Msisf.Core.Tiles;

/// <summary>Makes the meshes of a model and of its levels of detail; each level is prepared when it is first needed. Safe for several threads.</summary>
public sealed class LevelMeshBuilders
{
    private readonly ConcurrentDictionary<int, Lazy<TileMeshBuilder>> _builders = new();
    private readonly LodLevels _levels;

    /// <summary>Takes the levels.</summary>
    public LevelMeshBuilders(LodLevels levels) => _levels = levels;

    /// <summary>PRODUCT_ID of the model.</summary>
    public string ProductId => _levels.Level(0).ProductId;

    /// <summary>Samples a degree of the model itself.</summary>
    public int PixelsPerDegree => _levels.Level(0).PixelsPerDegree;

    /// <summary>The builder of a level.</summary>
    /// <param name="level">0 for the model itself.</param>
    public TileMeshBuilder Of(int level) =>
        _builders.GetOrAdd(level, known => new Lazy<TileMeshBuilder>(() => new TileMeshBuilder(_levels.Level(known)))).Value;
}
