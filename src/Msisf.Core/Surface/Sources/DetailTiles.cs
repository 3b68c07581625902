using System.Collections.Concurrent;
using System.Runtime.CompilerServices;
using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// Values at the samples of lattices in square tiles, computed when they are needed and kept up to a limit of memory. Safe for several
/// threads.
/// </summary>
/// <typeparam name="T">A value.</typeparam>
/// <param name="bytes">Memory for the tiles that are kept.</param>
/// <param name="read">Computes a tile.</param>
internal sealed class DetailTiles<T>(int bytes, ReadDetail<T> read)
    where T : unmanaged
{
    /// <summary>Samples along a tile's edge.</summary>
    public const int Side = 64;

    /// <summary>A full store drops one tile in this many at once: those not used for the longest time.</summary>
    private const int PartDropped = 4;

    private readonly int _capacity = bytes / (Side * Side * Unsafe.SizeOf<T>());
    private readonly ConcurrentDictionary<(LatticeFace Face, int Level, int Row, int Column), Tile> _tiles = new();
    private readonly Lock _gate = new();
    private long _now;

    /// <summary>The values of a tile, line by line.</summary>
    /// <param name="face">The map.</param>
    /// <param name="level">The lattice's level.</param>
    /// <param name="row">The tile's first line, divided by <see cref="Side"/>.</param>
    /// <param name="column">The same of its first sample.</param>
    public T[] Get(LatticeFace face, int level, int row, int column)
    {
        Tile tile = _tiles.GetOrAdd((face, level, row, column), key => new Tile(() => Compute(key.Face, key.Level, key.Row, key.Column)));
        tile.LastUse = Interlocked.Increment(ref _now);
        if (_tiles.Count > _capacity)
        {
            Drop();
        }

        return tile.Values;
    }

    private T[] Compute(LatticeFace face, int level, int row, int column)
    {
        T[] values = new T[Side * Side];
        read(face.Map(level), row * Side, column * Side, Side, values);
        return values;
    }

    private void Drop()
    {
        lock (_gate)
        {
            if (_tiles.Count > _capacity)
            {
                foreach (var old in _tiles.ToArray().OrderBy(tile => tile.Value.LastUse).Take(_capacity / PartDropped))
                {
                    _tiles.TryRemove(old);
                }
            }
        }
    }

    private sealed class Tile(Func<T[]> compute)
    {
        private readonly Lazy<T[]> _values = new(compute);

        public T[] Values => _values.Value;

        public long LastUse { get; set; }
    }
}

/// <summary>Computes values at samples of a map, as <see cref="IGroundDetail.ReadRadii"/> does.</summary>
internal delegate void ReadDetail<T>(PolarStereographic map, int firstLine, int firstSample, int side, Span<T> values);
