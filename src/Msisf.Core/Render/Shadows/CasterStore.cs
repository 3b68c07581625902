using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Facets that may cast a shadow, in light space: <see cref="Stride"/> numbers each, first the three corners' u, then their v, then w
/// of the corner across from each edge (the third, first, second), each three followed by one that means nothing. Its chunks serve
/// all frames.
/// </summary>
internal sealed class CasterStore
{
    /// <summary>Numbers a facet.</summary>
    public const int Stride = 12;

    private const int ChunkBits = 10;

    private readonly Lock _lock = new();
    private double[][] _chunks = [];
    private int _used;

    /// <summary>Facets in a chunk.</summary>
    public const int ChunkSize = 1 << ChunkBits;

    /// <summary>Forgets all facets.</summary>
    public void Clear() => _used = 0;

    /// <summary>Takes a chunk for one writer. Safe for several threads.</summary>
    /// <returns>Number of its first facet.</returns>
    public int TakeChunk()
    {
        lock (_lock)
        {
            if (_used == _chunks.Length)
            {
                double[][] grown = new double[Math.Max(16, 2 * _used)][];
                _chunks.CopyTo(grown, 0);
                Volatile.Write(ref _chunks, grown);
            }

            _chunks[_used] ??= new double[ChunkSize * Stride];
            return _used++ << ChunkBits;
        }
    }

    /// <summary>First of the numbers of a facet.</summary>
    public ref double this[int facet]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => ref Unsafe.Add(
            ref MemoryMarshal.GetArrayDataReference(_chunks[facet >> ChunkBits]), (facet & (ChunkSize - 1)) * Stride);
    }
}
