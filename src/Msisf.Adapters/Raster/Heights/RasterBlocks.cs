using System.Collections.Concurrent;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// The values of a raster in squares, read by GDAL where they are asked for and kept in memory up to a limit. Each thread that reads has
/// the file open for itself. Safe for several threads.
/// </summary>
internal sealed class RasterBlocks : IDisposable
{
    private const int BlockShift = RasterScan.SideShift;
    private const int BlockSide = RasterScan.Side;

    /// <summary>Blocks that are kept, 256 MB; beyond that all are dropped.</summary>
    private const int MaxBlocks = 1024;

    private readonly Func<OpenedRaster> _open;
    private readonly HeightRule _rule;
    private readonly ConcurrentBag<OpenedRaster> _idle = [];
    private readonly ConcurrentDictionary<int, UndeclaredGaps> _undeclared = new();
    private readonly Lock _gate = new();
    private readonly int _blockColumns;
    private float[]?[]?[] _blocks;
    private int _blockCount;
    private bool _isClosed;

    /// <summary>Takes a raster.</summary>
    /// <param name="first">It; closed with this.</param>
    /// <param name="open">Opens it once more.</param>
    /// <param name="rule">What its values mean.</param>
    public RasterBlocks(OpenedRaster first, Func<OpenedRaster> open, HeightRule rule)
    {
        (_open, _rule) = (open, rule);
        (Height, Width) = (first.Image.Height, first.Image.Width);
        _idle.Add(first);
        _blockColumns = (Width + BlockSide - 1) >> BlockShift;
        _blocks = new float[]?[]?[(Height + BlockSide - 1) >> BlockShift];
    }

    /// <summary>Number of rows.</summary>
    public int Height { get; }

    /// <summary>Pixels of a row.</summary>
    public int Width { get; }

    /// <summary>What can't be a height, in the blocks that were read so far.</summary>
    public UndeclaredGaps Undeclared => _undeclared.Values.Aggregate(UndeclaredGaps.None, (all, next) => all.With(next));

    /// <summary>The value of a pixel; NaN without data.</summary>
    public float ValueAt(int row, int column) =>
        Block(row >> BlockShift, column >> BlockShift)[((row & (BlockSide - 1)) << BlockShift) | (column & (BlockSide - 1))];

    /// <summary>The values of a square, NaN without data; its rows are <see cref="RasterScan.Side"/> apart.</summary>
    public float[] Block(int blockRow, int blockColumn) =>
        Volatile.Read(ref Volatile.Read(ref _blocks)[blockRow]) is { } inRow && Volatile.Read(ref inRow[blockColumn]) is { } block
            ? block
            : Keep(blockRow, blockColumn, ReadBlock(blockRow, blockColumn));

    /// <summary>Drops what was read.</summary>
    public void Forget()
    {
        lock (_gate)
        {
            Volatile.Write(ref _blocks, new float[]?[]?[_blocks.Length]);
            _blockCount = 0;
        }
    }

    /// <summary>Closes the file.</summary>
    public void Dispose()
    {
        _isClosed = true;
        while (_idle.TryTake(out OpenedRaster? raster))
        {
            raster.Dispose();
        }
    }

    /// <exception cref="BadInputException">The file is damaged.</exception>
    private float[] ReadBlock(int blockRow, int blockColumn)
    {
        int line = blockRow << BlockShift;
        int sample = blockColumn << BlockShift;
        int lines = Math.Min(BlockSide, Height - line);
        int samples = Math.Min(BlockSide, Width - sample);
        float[] values = new float[BlockSide * BlockSide];
        ObjectDisposedException.ThrowIf(_isClosed, this);
        OpenedRaster raster = _idle.TryTake(out OpenedRaster? known) ? known : _open();
        try
        {
            raster.Image.Read(line, lines, sample, samples, values, BlockSide);
        }
        finally
        {
            _idle.Add(raster);
        }

        bool isDeclared = raster.File.NoData is not null || raster.IsWarped;
        UndeclaredGaps undeclared = UndeclaredGaps.None;
        for (int i = 0; i < lines; i++)
        {
            Span<float> row = values.AsSpan(i * BlockSide, samples);
            for (int j = 0; j < row.Length; j++)
            {
                if (!_rule.IsHeight(row[j]))
                {
                    undeclared = float.IsNaN(row[j]) && isDeclared ? undeclared : undeclared.With(line + i, sample + j, row[j]);
                    row[j] = float.NaN;
                }
            }
        }

        if (undeclared.Count > 0)
        {
            _undeclared[(blockRow * _blockColumns) + blockColumn] = undeclared;
        }

        return values;
    }

    private float[] Keep(int blockRow, int blockColumn, float[] block)
    {
        lock (_gate)
        {
            if (_blocks[blockRow]?[blockColumn] is { } known)
            {
                return known;
            }

            if (++_blockCount > MaxBlocks)
            {
                Volatile.Write(ref _blocks, new float[]?[]?[_blocks.Length]);
                _blockCount = 1;
            }

            if (_blocks[blockRow] is null)
            {
                Volatile.Write(ref _blocks[blockRow], new float[]?[_blockColumns]);
            }

            Volatile.Write(ref _blocks[blockRow]![blockColumn], block);
            return block;
        }
    }
}
