namespace Msisf.Core.Lod;

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
