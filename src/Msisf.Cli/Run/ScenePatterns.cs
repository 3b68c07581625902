using System.Collections.Concurrent;
using Msisf.Adapters.Tiles;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Cli.Run;

/// <summary>The patterns of a run's scenes: each is checked, or made, once a run, however many frames show it. Safe for several threads.</summary>
internal sealed class ScenePatterns
{
    private readonly ConcurrentDictionary<TileId, bool> _ready = new();
    private readonly PatternRepository _repository;
    private readonly IElevationGrid _grid;

    public ScenePatterns(PatternRepository repository, IElevationGrid grid)
    {
        _repository = repository;
        _grid = grid;
    }

    /// <summary>The folder of the patterns.</summary>
    public string Folder => _repository.FolderOf(_grid.PixelsPerDegree);

    /// <summary>File name of a tile's pattern, without folder.</summary>
    public string FileNameOf(TileId tile) => Path.GetFileName(_repository.PathOf(tile, _grid.PixelsPerDegree));

    /// <summary>Makes sure that the patterns are there.</summary>
    /// <returns>How many had to be made.</returns>
    public int Ensure(IEnumerable<TileId> tiles, CancellationToken cancellation)
    {
        TileId[] unknown = [.. tiles.Where(tile => !_ready.ContainsKey(tile))];
        if (unknown.Length == 0)
        {
            return 0;
        }

        PatternSet set = _repository.EnsurePatterns(
            unknown, _grid, new PatternOptions(0.0, PatternFormat.Mesh2), Environment.ProcessorCount, progress: null, cancellation);
        foreach (TileId tile in unknown)
        {
            _ready[tile] = true;
        }

        return set.Written;
    }
}
