using System.Collections.Concurrent;
using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>
/// A model at a resolution halved one or more times (<see cref="BlockReducer"/>), computed block by block when it is first read. Several
/// threads that ask for the same block wait for the first one. Safe for several threads.
/// </summary>
public class ReducedGrid : BlockedGrid
{
    private readonly LodCache _cache;
    private readonly ITerrainGrid _source;
    private readonly int _blocksBetweenReleases;
    private readonly ReducedGrid? _below;
    private readonly BlockReducer _fromSource;
    private readonly BlockReducer? _fromBelow;
    private readonly LodBlock?[]?[] _rows;
    private readonly ConcurrentDictionary<int, Lazy<LodBlock>> _pending = new();
    private int _blocksFromSource;

    /// <summary>Takes the model.</summary>
    /// <param name="source">The model that is reduced.</param>
    /// <param name="halvings">At least 1.</param>
    /// <param name="below">
    /// The level of one halving less, if it is computed from the same source; its blocks are used if they are in memory.
    /// </param>
    /// <param name="cache">Bounds the memory.</param>
    /// <param name="samplesBetweenReleases">Number of samples of the model that are read before their memory is released.</param>
    /// <param name="keepsGaps">Whether it has no data where the model has none; without it such a place is an error.</param>
    internal ReducedGrid(
        ITerrainGrid source, int halvings, ReducedGrid? below, LodCache cache, int samplesBetweenReleases, bool keepsGaps = false)
        : base(source, halvings, keepsGaps)
    {
        _cache = cache;
        _source = source;
        _blocksBetweenReleases = Math.Max(1, (samplesBetweenReleases / LodLayout.BlockSamples) >> (2 * halvings));
        _below = below;
        _fromSource = new BlockReducer(source, halvings, keepsGaps);
        _fromBelow = below is null ? null : new BlockReducer(below, 1, keepsGaps);
        _rows = new LodBlock?[]?[Layout.BlockRows];
    }

    /// <inheritdoc/>
    protected sealed override ReadOnlySpan<float> HeightsOf(int row, int column)
    {
        LodBlock block = Known(row, column) ?? Compute(row, column);
        _cache.Touch(block);
        return block.Heights;
    }

    private LodBlock? Known(int row, int column) => Volatile.Read(ref _rows[row]) is { } slots ? Volatile.Read(ref slots[column]) : null;

    private LodBlock Compute(int row, int column)
    {
        int index = (row * Layout.BlockColumns) + column;
        try
        {
            // A block that another thread finished between our look and this line is not computed again.
            return _pending.GetOrAdd(index, _ => new Lazy<LodBlock>(() => Known(row, column) ?? Reduced(row, column))).Value;
        }
        finally
        {
            _pending.TryRemove(index, out _); // also after a failure: the next reader gets its own
        }
    }

    private LodBlock Reduced(int row, int column)
    {
        float[] heights = new float[LodLayout.BlockSamples];
        BlockReducer reducer = _fromBelow is not null && IsKnownBelow(row, column) ? _fromBelow : _fromSource;
        reducer.Reduce(row, column, heights);
        if (reducer == _fromSource && Interlocked.Increment(ref _blocksFromSource) % _blocksBetweenReleases == 0)
        {
            _source.ReleasePages(); // what was reduced is not read again, and is much
        }

        LodBlock?[] slots = Volatile.Read(ref _rows[row])
            ?? Interlocked.CompareExchange(ref _rows[row], new LodBlock?[Layout.BlockColumns], null)
            ?? Volatile.Read(ref _rows[row])!;
        LodBlock block = new(heights, slots, column);
        _cache.Add(block);
        return block;
    }

    /// <summary>
    /// Whether all blocks of the level below that the block covers are in memory; one that is removed before it is read is computed
    /// again.
    /// </summary>
    private bool IsKnownBelow(int row, int column)
    {
        LodLayout below = _below!.Layout;
        GridWindow block = Layout.SamplesOf(row, column);
        int firstRow = below.RowOf(Math.Max(2 * block.FirstLine, below.Window.FirstLine));
        int lastRow = below.RowOf(Math.Min((2 * block.EndLine) - 1, below.Window.EndLine - 1));
        int firstColumn = below.ColumnOf(Math.Max(2 * block.FirstSample, below.Window.FirstSample));
        int lastColumn = below.ColumnOf(Math.Min((2 * block.EndSample) - 1, below.Window.EndSample - 1));
        return _below.Known(firstRow, firstColumn) is not null && _below.Known(firstRow, lastColumn) is not null
            && _below.Known(lastRow, firstColumn) is not null && _below.Known(lastRow, lastColumn) is not null;
    }
}
