using System.Collections.Concurrent;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
using Msisf.Core.Numerics;

namespace Msisf.Core.Terrain.Lod;

/// <summary>
/// A model at a resolution halved one or more times (<see cref="BlockReducer"/>), computed block by block when it is first read. Several threads
/// that ask for the same block wait for the first one. Safe for several threads.
/// </summary>
public sealed class ReducedGrid : IElevationGrid
{
    private readonly LodLayout _layout;
    private readonly LodCache _cache;
    private readonly ReducedGrid? _below;
    private readonly BlockReducer _fromSource;
    private readonly BlockReducer? _fromBelow;
    private readonly LodBlock?[]?[] _rows;
    private readonly ConcurrentDictionary<int, Lazy<LodBlock>> _pending = new();

    /// <summary>Takes the model.</summary>
    /// <param name="source">The model that is reduced.</param>
    /// <param name="halvings">At least 1.</param>
    /// <param name="below">The level of one halving less, if it is computed from the same source; its blocks are used if they are there.</param>
    /// <param name="cache">Bounds the memory.</param>
    internal ReducedGrid(IElevationGrid source, int halvings, ReducedGrid? below, LodCache cache)
    {
        ProductId = source.ProductId;

        // Means lie between the samples, but for the rounding of their heights.
        (double least, double greatest) = source.RadiusLimits;
        RadiusLimits = (least - Tolerances.VertexLattice, greatest + Tolerances.VertexLattice);
        _layout = new LodLayout(source.PixelsPerDegree >> halvings);
        _cache = cache;
        _below = below;
        _fromSource = new BlockReducer(source, halvings);
        _fromBelow = below is null ? null : new BlockReducer(below, 1);
        _rows = new LodBlock?[]?[_layout.BlockRows];
    }

    /// <inheritdoc/>
    public string ProductId { get; }

    /// <inheritdoc/>
    public (double Least, double Greatest) RadiusLimits { get; }

    /// <inheritdoc/>
    public int PixelsPerDegree => _layout.PixelsPerDegree;

    /// <inheritdoc/>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        _layout.CheckRange(line, 1, firstSample, radii.Length);
        int row = line >> LodLayout.SideShift;
        int start = (line & (LodLayout.Side - 1)) << LodLayout.SideShift;
        while (radii.Length > 0)
        {
            int column = firstSample >> LodLayout.SideShift;
            int inBlock = firstSample & (LodLayout.Side - 1);
            int count = Math.Min(radii.Length, _layout.SamplesOf(column) - inBlock);
            CopyRadii(HeightsOf(row, column).AsSpan(start + inBlock, count), radii);
            radii = radii[count..];
            firstSample = firstSample + count == _layout.Samples ? 0 : firstSample + count;
        }
    }

    /// <inheritdoc/>
    public (double Minimum, double Maximum) RadiusBounds(int firstLine, int lines, int firstSample, int samples)
    {
        _layout.CheckRange(firstLine, lines, firstSample, samples);
        float least = float.PositiveInfinity;
        float greatest = float.NegativeInfinity;
        for (int line = firstLine, nextLine; line < firstLine + lines; line = nextLine)
        {
            nextLine = Math.Min(firstLine + lines, (line | (LodLayout.Side - 1)) + 1);
            for (int done = 0, count; done < samples; done += count)
            {
                int sample = (firstSample + done) % _layout.Samples;
                int column = sample >> LodLayout.SideShift;
                int inBlock = sample & (LodLayout.Side - 1);
                count = Math.Min(samples - done, _layout.SamplesOf(column) - inBlock);
                float[] heights = HeightsOf(line >> LodLayout.SideShift, column);
                for (int i = line; i < nextLine; i++)
                {
                    foreach (float height in heights.AsSpan(((i & (LodLayout.Side - 1)) << LodLayout.SideShift) + inBlock, count))
                    {
                        least = Math.Min(least, height);
                        greatest = Math.Max(greatest, height);
                    }
                }
            }
        }

        return (MoonConstants.ReferenceRadius + least, MoonConstants.ReferenceRadius + greatest);
    }

    private static void CopyRadii(ReadOnlySpan<float> heights, Span<double> radii)
    {
        int i = 0;
        if (Avx.IsSupported)
        {
            ref float source = ref MemoryMarshal.GetReference(heights);
            ref double target = ref MemoryMarshal.GetReference(radii);
            Vector256<double> reference = Vector256.Create(MoonConstants.ReferenceRadius);
            for (; i <= heights.Length - Vector256<double>.Count; i += Vector256<double>.Count)
            {
                (reference + Avx.ConvertToVector256Double(Vector128.LoadUnsafe(ref source, (nuint)i))).StoreUnsafe(ref target, (nuint)i);
            }
        }

        for (; i < heights.Length; i++)
        {
            radii[i] = MoonConstants.ReferenceRadius + heights[i];
        }
    }

    private float[] HeightsOf(int row, int column)
    {
        LodBlock block = Known(row, column) ?? Compute(row, column);
        _cache.Touch(block);
        return block.Heights;
    }

    private LodBlock? Known(int row, int column) => Volatile.Read(ref _rows[row]) is { } slots ? Volatile.Read(ref slots[column]) : null;

    private LodBlock Compute(int row, int column)
    {
        int index = (row * _layout.BlockColumns) + column;
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
        LodBlock?[] slots = Volatile.Read(ref _rows[row])
            ?? Interlocked.CompareExchange(ref _rows[row], new LodBlock?[_layout.BlockColumns], null)
            ?? Volatile.Read(ref _rows[row])!;
        LodBlock block = new(heights, slots, column);
        _cache.Add(block);
        return block;
    }

    /// <summary>All blocks of the level below that the block covers are there; if one goes before it is read, it is computed again.</summary>
    private bool IsKnownBelow(int row, int column)
    {
        LodLayout below = _below!._layout;
        int lastRow = Math.Min((2 * row) + 1, below.BlockRows - 1);
        int lastColumn = Math.Min((2 * column) + 1, below.BlockColumns - 1);
        return _below.Known(2 * row, 2 * column) is not null && _below.Known(2 * row, lastColumn) is not null
            && _below.Known(lastRow, 2 * column) is not null && _below.Known(lastRow, lastColumn) is not null;
    }
}
