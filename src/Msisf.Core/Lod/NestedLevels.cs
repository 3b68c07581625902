using System.Collections.Concurrent;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>
/// Several models at levels of detail, joined to one surface for each combination of levels that is needed. The surfaces that were
/// used last are kept. Safe for several threads.
/// </summary>
public sealed class NestedLevels
{
    /// <summary>Surfaces that are kept beside that of the models themselves; each has buffers as large as an image.</summary>
    private const int MaxSurfaces = 4;

    private readonly Lock _gate = new();
    private readonly List<(string Key, NestedTerrain Terrain)> _kept = [];
    private readonly ConcurrentDictionary<(int Coarser, int Finer), bool> _covers = new();

    /// <summary>Takes the models.</summary>
    /// <param name="scene">The surface of the models themselves.</param>
    /// <param name="models">The levels of each, in the order of the surface.</param>
    public NestedLevels(NestedTerrain scene, IReadOnlyList<TerrainLevels> models)
    {
        (Scene, Models) = (scene, models);
        if (!scene.Models.SequenceEqual(models.Select(levels => levels.Grid(0))))
        {
            throw new ArgumentException("The levels are of other models.", nameof(models));
        }
    }

    /// <summary>The surface of the models themselves.</summary>
    public NestedTerrain Scene { get; }

    /// <summary>The levels of each model, the coarsest model first.</summary>
    public IReadOnlyList<TerrainLevels> Models { get; }

    /// <summary>The surface of a combination of levels; it is joined when it is first drawn.</summary>
    /// <param name="levels">The level of each model; null for one that is left out.</param>
    public NestedTerrain Terrain(IReadOnlyList<int?> levels)
    {
        if (levels.All(level => level == 0))
        {
            return Scene;
        }

        string key = string.Join(',', levels.Select(level => level?.ToString(CultureInfo.InvariantCulture) ?? "-"));
        lock (_gate)
        {
            int known = _kept.FindIndex(kept => kept.Key == key);
            if (known >= 0)
            {
                (string, NestedTerrain) used = _kept[known];
                _kept.RemoveAt(known);
                _kept.Add(used);
                return used.Item2;
            }

            ITerrainGrid?[] grids = [.. levels.Select((level, model) => level is { } there ? Models[model].Grid(there) : null)];
            NestedTerrain terrain = new(Scene, grids, MostAlike(grids));
            _kept.Add((key, terrain));
            if (_kept.Count > MaxSurfaces)
            {
                _kept.RemoveAt(0);
            }

            return terrain;
        }
    }

    /// <summary>Whether a model has data wherever a finer one has, well within its border.</summary>
    /// <param name="finer">Number of the other.</param>
    internal bool Covers(int coarser, int finer) => _covers.GetOrAdd(
        (coarser, finer), pair => ModelReach.Covers(Scene.WholeParts[pair.Coarser], Scene.WholeParts[pair.Finer]));

    /// <summary>The surface that has the same levels of most of the first models.</summary>
    private NestedTerrain MostAlike(ITerrainGrid?[] grids) =>
        _kept.Select(kept => kept.Terrain).Prepend(Scene).MaxBy(terrain => terrain.CountSame(grids))!;
}
