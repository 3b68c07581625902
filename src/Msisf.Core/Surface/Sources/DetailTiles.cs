using System.Collections.Concurrent;
using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// The heights of lattices in square tiles, computed when they are needed and kept up to a limit of memory. Safe for several threads.
/// </summary>
/// <param name="detail">Computes them.</param>
internal sealed class DetailTiles(IGroundDetail detail)
{
    /// <summary>Samples along a tile's edge.</summary>
    public const int Side = 64;

    /// <summary>Tiles that are kept: 96 MiB of heights, which is what the windows of one view can have.</summary>
    private const int Capacity = (96 << 20) / (Side * Side * sizeof(double));

    /// <summary>A full store drops one tile in this many at once: those not used for the longest time.</summary>
    private const int PartDropped = 4;

    private readonly ConcurrentDictionary<(LatticeFace Face, int Level, int Row, int Column), Tile> _tiles = new();
    private readonly Lock _gate = new();
    private long _now;

    /// <summary>The radii of a tile, m, line by line.</summary>
    /// <param name="face">The map.</param>
    /// <param name="level">The lattice's level.</param>
    /// <param name="row">The tile's first line, divided by <see cref="Side"/>.</param>
    /// <param name="column">The same of its first sample.</param>
    public double[] Get(LatticeFace face, int level, int row, int column)
    {
        Tile tile = _tiles.GetOrAdd((face, level, row, column), key => new Tile(() => Compute(key.Face, key.Level, key.Row, key.Column)));
        tile.LastUse = Interlocked.Increment(ref _now);
        if (_tiles.Count > Capacity)
        {
            Drop();
        }

        return tile.Radii;
    }

    private double[] Compute(LatticeFace face, int level, int row, int column)
    {
        double[] radii = new double[Side * Side];
        detail.ReadRadii(face.Map(level), row * Side, column * Side, Side, radii);
        return radii;
    }

    private void Drop()
    {
        lock (_gate)
        {
            if (_tiles.Count > Capacity)
            {
                foreach (var old in _tiles.ToArray().OrderBy(tile => tile.Value.LastUse).Take(Capacity / PartDropped))
                {
                    _tiles.TryRemove(old);
                }
            }
        }
    }

    private sealed class Tile(Func<double[]> compute)
    {
        private readonly Lazy<double[]> _radii = new(compute);

        public double[] Radii => _radii.Value;

        public long LastUse { get; set; }
    }
}
