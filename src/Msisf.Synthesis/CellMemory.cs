using System.Collections.Concurrent;

namespace Msisf.Synthesis;

/// <summary>
/// Keeps what was found in cells of <see cref="CraterCells"/>, since neighbouring blocks of ground ask for the same cells. Safe for several
/// threads.
/// </summary>
/// <typeparam name="T">What lies in cells.</typeparam>
internal sealed class CellMemory<T>
{
    /// <summary>Cells that are kept at most, some 10 MB; all are forgotten when there are more.</summary>
    private const int MostCells = 1 << 15;

    private readonly ConcurrentDictionary<(int Octave, int Band, int Column), T[]> _known = new();
    private int _count;

    /// <summary>What lies in a cell.</summary>
    /// <param name="octave">The cell's octave of diameters.</param>
    /// <param name="cell">The cell.</param>
    /// <param name="find">Finds it, the same each time.</param>
    public T[] Get(int octave, CraterCell cell, Func<int, CraterCell, IEnumerable<T>> find)
    {
        (int, int, int) key = (octave, cell.Band, cell.Column);
        if (_known.TryGetValue(key, out T[]? known))
        {
            return known;
        }

        if (Interlocked.Increment(ref _count) > MostCells)
        {
            _known.Clear();
            Interlocked.Exchange(ref _count, 1);
        }

        return _known[key] = [.. find(octave, cell)];
    }
}
