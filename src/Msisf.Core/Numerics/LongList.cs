namespace Msisf.Core.Numerics;

/// <summary>
/// A list that grows by pieces of fixed size, so that tens of millions of items never are in memory twice, as they are while an array
/// grows.
/// </summary>
/// <typeparam name="T">Type of the items.</typeparam>
public sealed class LongList<T>
    where T : struct
{
    private const int PieceBits = 14;
    private const int PieceLength = 1 << PieceBits;

    private readonly List<T[]> _pieces = [];

    /// <summary>Number of items.</summary>
    public int Count { get; private set; }

    /// <summary>An item.</summary>
    /// <param name="index">From 0 to below <see cref="Count"/>.</param>
    public T this[int index] => _pieces[index >> PieceBits][index & (PieceLength - 1)];

    /// <summary>Adds an item at the end.</summary>
    public void Add(T item)
    {
        if (Count == _pieces.Count * PieceLength)
        {
            _pieces.Add(new T[PieceLength]);
        }

        _pieces[Count >> PieceBits][Count & (PieceLength - 1)] = item;
        Count++;
    }
}
