namespace Msisf.Core.Surface;

/// <summary>The known bounds of a level's nodes; memory is allocated only where bounds are known. Safe for several threads.</summary>
internal sealed class NodeStore
{
    private const int ChunkShift = 4;
    private const int ChunkSide = 1 << ChunkShift;

    private readonly int _chunkColumns;
    private readonly Chunk?[]?[] _chunks;

    public NodeStore(int rows, int columns)
    {
        _chunkColumns = (columns + ChunkSide - 1) >> ChunkShift;
        _chunks = new Chunk?[]?[(rows + ChunkSide - 1) >> ChunkShift];
    }

    /// <summary>Gets the bounds of a node if they are known.</summary>
    public bool TryGet(int row, int column, out NodeBounds bounds)
    {
        if (Volatile.Read(ref _chunks[row >> ChunkShift]) is { } chunks && Volatile.Read(ref chunks[column >> ChunkShift]) is { } chunk)
        {
            int index = IndexOf(row, column);
            bool isKnown = Volatile.Read(ref chunk.IsKnown[index]);
            bounds = chunk.Bounds[index];
            return isKnown;
        }

        bounds = default;
        return false;
    }

    /// <summary>Stores the bounds of a node. Several threads may set the same node, but only to the same bounds.</summary>
    public void Set(int row, int column, NodeBounds bounds)
    {
        ref Chunk?[]? chunks = ref _chunks[row >> ChunkShift];
        Chunk?[] inRow = Volatile.Read(ref chunks) ?? Publish(ref chunks, new Chunk?[_chunkColumns]);
        ref Chunk? chunk = ref inRow[column >> ChunkShift];
        Chunk target = Volatile.Read(ref chunk) ?? Publish(ref chunk, new Chunk());
        target.Bounds[IndexOf(row, column)] = bounds;
        Volatile.Write(ref target.IsKnown[IndexOf(row, column)], true);
    }

    private static int IndexOf(int row, int column) => ((row & (ChunkSide - 1)) << ChunkShift) | (column & (ChunkSide - 1));

    private static T Publish<T>(ref T? place, T made)
        where T : class => Interlocked.CompareExchange(ref place, made, null) ?? made;

    private sealed class Chunk
    {
        public NodeBounds[] Bounds { get; } = new NodeBounds[ChunkSide * ChunkSide];

        public bool[] IsKnown { get; } = new bool[ChunkSide * ChunkSide];
    }
}
