using System.Collections.Concurrent;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// The values of a raster in squares, read by GDAL where they are asked for and kept in memory up to a limit. Each thread that reads has
/// the file open for itself, unless several may share it. Safe for several threads.
/// </summary>
internal sealed class RasterBlocks : IDisposable
{
    private const int BlockShift = SquareGrid.SideShift;
    private const int BlockSide = SquareGrid.Side;

    /// <summary>Blocks that are kept, 128 MB; for a further one goes one that was not asked for of late.</summary>
    private const int MaxBlocks = 512;

    /// <summary>The collector is asked for after so many: left to itself it comes to large arrays late.</summary>
    private const int BlocksPerCollection = 256;

    private readonly Func<OpenedRaster> _open;
    private readonly OpenedRaster? _shared;
    private readonly HeightRule _rule;
    private readonly ConcurrentBag<OpenedRaster> _idle = [];
    private readonly Lock _gate = new();
    private readonly int _blockColumns;
    private readonly KeptBlock?[]?[] _blocks;
    private readonly Queue<KeptBlock> _kept = new();
    private int _dropped;
    private bool _isClosed;

    /// <summary>Takes a raster.</summary>
    /// <param name="first">It; closed with this.</param>
    /// <param name="open">Opens it once more.</param>
    /// <param name="rule">What its values mean.</param>
    public RasterBlocks(OpenedRaster first, Func<OpenedRaster> open, HeightRule rule)
    {
        (_open, _rule) = (open, rule);
        (Height, Width) = (first.Placement.Window.Lines, first.Placement.Window.Samples);
        (HasWideBlocks, IsRing) = (first.File.HasWideBlocks, first.Placement.IsRing);
        _shared = first.IsShared ? first : null;
        Return(first);
        _blockColumns = (Width + BlockSide - 1) >> BlockShift;
        _blocks = new KeptBlock?[]?[(Height + BlockSide - 1) >> BlockShift];
    }

    /// <summary>Number of rows.</summary>
    public int Height { get; }

    /// <summary>Pixels of a row.</summary>
    public int Width { get; }

    /// <summary>Whether a part of a row costs as much as all of it.</summary>
    public bool HasWideBlocks { get; }

    /// <summary>Whether the last pixel of a row lies beside the first one.</summary>
    public bool IsRing { get; }

    /// <summary>How many pixels of a row from one on lie in one block.</summary>
    /// <param name="column">The first.</param>
    /// <param name="most">At most so many.</param>
    public int RunLength(int column, int most) =>
        Math.Min(most, Math.Min(BlockSide - (column & (BlockSide - 1)), Width - column));

    /// <summary>The values of the next pixels of a row, as many as lie in one block; NaN without data.</summary>
    /// <param name="column">The first.</param>
    /// <param name="most">At most so many.</param>
    public ReadOnlySpan<float> RunAt(int row, int column, int most) =>
        Block(row >> BlockShift, column >> BlockShift).AsSpan(
            ((row & (BlockSide - 1)) << BlockShift) | (column & (BlockSide - 1)), RunLength(column, most));

    private float[] Block(int blockRow, int blockColumn)
    {
        if (Volatile.Read(ref _blocks[blockRow]) is not { } inRow || Volatile.Read(ref inRow[blockColumn]) is not { } block)
        {
            return Keep(blockRow, blockColumn, ReadBlock(blockRow, blockColumn));
        }

        block.IsUsed = true;
        return block.Values;
    }

    /// <summary>Closes the file.</summary>
    public void Dispose()
    {
        _isClosed = true;
        _shared?.Dispose();
        while (_idle.TryTake(out OpenedRaster? raster))
        {
            raster.Dispose();
        }
    }

    /// <summary>Reads a rectangle past the memory.</summary>
    /// <param name="line">Top row.</param>
    /// <param name="lines">How many rows.</param>
    /// <param name="sample">Leftmost pixel.</param>
    /// <param name="samples">How many pixels of a row.</param>
    /// <param name="values">Receives the values, NaN without data.</param>
    /// <param name="stride">Values from one row to the next.</param>
    /// <returns>What can't be a height, and is not declared.</returns>
    /// <exception cref="BadInputException">The file is damaged.</exception>
    public UndeclaredGaps Read(int line, int lines, int sample, int samples, Span<float> values, int stride)
    {
        ObjectDisposedException.ThrowIf(_isClosed, this);
        OpenedRaster raster = Take();
        try
        {
            return raster.Read(line, lines, sample, samples, values, stride, _rule);
        }
        finally
        {
            Return(raster);
        }
    }

    /// <summary>Counts the pixels that can't be heights, and that the file does not declare; samples between pixels share them.</summary>
    /// <param name="found">Those that were found while samples were read.</param>
    public UndeclaredGaps Counted(UndeclaredGaps found)
    {
        OpenedRaster raster = Take();
        try
        {
            return found.Count > 0 && raster.IsWarped ? raster.Undeclared(_rule) : found;
        }
        finally
        {
            Return(raster);
        }
    }

    private OpenedRaster Take() => _shared ?? (_idle.TryTake(out OpenedRaster? known) ? known : _open());

    private void Return(OpenedRaster raster)
    {
        if (raster != _shared)
        {
            _idle.Add(raster);
        }
    }

    private float[] ReadBlock(int blockRow, int blockColumn)
    {
        int line = blockRow << BlockShift;
        int sample = blockColumn << BlockShift;
        float[] values = new float[BlockSide * BlockSide];
        Read(line, Math.Min(BlockSide, Height - line), sample, Math.Min(BlockSide, Width - sample), values, BlockSide);
        return values;
    }

    private float[] Keep(int blockRow, int blockColumn, float[] values)
    {
        lock (_gate)
        {
            KeptBlock?[] inRow = _blocks[blockRow] ?? new KeptBlock?[_blockColumns];
            if (inRow[blockColumn] is { } known)
            {
                return known.Values;
            }

            if (_kept.Count == MaxBlocks)
            {
                Drop();
            }

            KeptBlock block = new(blockRow, blockColumn, values);
            _kept.Enqueue(block);
            Volatile.Write(ref inRow[blockColumn], block);
            Volatile.Write(ref _blocks[blockRow], inRow);
            return values;
        }
    }

    /// <summary>Drops the longest kept of the blocks that nobody asked for since it was last looked at.</summary>
    private void Drop()
    {
        KeptBlock block = _kept.Dequeue();
        while (block.IsUsed)
        {
            block.IsUsed = false;
            _kept.Enqueue(block);
            block = _kept.Dequeue();
        }

        Volatile.Write(ref _blocks[block.Row]![block.Column], null);
        if (++_dropped % BlocksPerCollection == 0)
        {
            GC.Collect(GC.MaxGeneration, GCCollectionMode.Forced, blocking: true, compacting: false);
        }
    }

    /// <summary>A block in memory, and whether it was asked for of late.</summary>
    private sealed record KeptBlock(int Row, int Column, float[] Values)
    {
        public bool IsUsed { get; set; }
    }
}
