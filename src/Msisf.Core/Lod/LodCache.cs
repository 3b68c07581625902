namespace Msisf.Core.Lod;

/// <summary>
/// Bounds the memory of the computed blocks of all levels of a model: the least recently used are removed first. Time counts the blocks
/// that were added, so a look-up writes nothing that threads share except a block's own time. Safe for several threads.
/// </summary>
internal sealed class LodCache
{
    private const int BlockBytes = sizeof(float) * LodLayout.BlockSamples;

    /// <summary>
    /// A full cache frees one part in this many of its capacity at once, because sorting all blocks for each new one would be slow.
    /// </summary>
    private const int PartsFreed = 8;

    private readonly int _capacity;
    private readonly Lock _gate = new();
    private readonly List<LodBlock> _blocks = [];
    private long _now;

    /// <param name="capacityBytes">Maximum size of the samples that are kept, bytes; at least a few blocks are always kept.</param>
    public LodCache(long capacityBytes) => _capacity = (int)Math.Clamp(capacityBytes / BlockBytes, PartsFreed, int.MaxValue);

    /// <summary>Notes that a block is used.</summary>
    public void Touch(LodBlock block)
    {
        long now = Volatile.Read(ref _now);
        if (block.LastUse != now)
        {
            block.LastUse = now;
        }
    }

    /// <summary>Makes a new block known and, where room is needed, withdraws others.</summary>
    public void Add(LodBlock block)
    {
        lock (_gate)
        {
            if (_blocks.Count >= _capacity)
            {
                LodBlock[] byUse = [.. _blocks.OrderByDescending(known => known.LastUse)]; // taken once: other threads go on changing it
                int kept = _capacity - Math.Max(1, _capacity / PartsFreed);
                foreach (LodBlock old in byUse.AsSpan(kept))
                {
                    old.Withdraw();
                }

                _blocks.Clear();
                _blocks.AddRange(byUse.AsSpan(0, kept));
            }

            block.LastUse = ++_now;
            _blocks.Add(block);
            block.Publish();
        }
    }
}

/// <summary>A computed block of a level.</summary>
internal sealed class LodBlock
{
    private readonly LodBlock?[] _slots;
    private readonly int _slot;

    /// <summary>Takes the samples and the place that the block will have.</summary>
    /// <param name="heights">m over the reference radius, <see cref="LodLayout.Side"/> a line.</param>
    /// <param name="slots">The array that will hold the block.</param>
    /// <param name="slot">Index in it.</param>
    public LodBlock(float[] heights, LodBlock?[] slots, int slot)
    {
        Heights = heights;
        _slots = slots;
        _slot = slot;
    }

    public float[] Heights { get; }

    /// <summary>The cache's time when the block was last used. Several threads may set it; any of their values is good enough.</summary>
    public long LastUse { get; set; }

    /// <summary>Makes the block known to all threads.</summary>
    public void Publish() => Volatile.Write(ref _slots[_slot], this);

    /// <summary>Removes the block from the array; threads that already have it can still read its samples.</summary>
    public void Withdraw() => Volatile.Write(ref _slots[_slot], null);
}
