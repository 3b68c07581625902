using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// The receivers of a frame, sorted into a grid of bins across the Sun's rays: those of neighbouring bins of a row lie one behind the
/// other, so that a facet goes through the ones that it may hide eight at a time.
/// </summary>
/// <remarks>
/// The sort counts first: <see cref="Lay"/>, <see cref="Count"/> for each row, <see cref="Place"/>, <see cref="Sort"/> for each row.
/// From <see cref="Place"/> on the depths can be asked for, and by them <see cref="Want"/> the bins that are worth sorting.
/// </remarks>
internal sealed class ReceiverGrid
{
    private const int LaneCount = 8;
    private const int MaxBins = 2048;

    private readonly DepthPyramid _depths = new();
    private LightAxis _u;
    private LightAxis _v;
    private int[] _bins = [];
    private Part[] _parts = [];
    private byte[] _isWanted = [];
    private bool _wantsAll;
    private int[] _starts = [];

    /// <summary>Bins to an edge.</summary>
    public int Size { get; private set; }

    /// <summary>Receivers.</summary>
    public int Length { get; private set; }

    /// <summary>
    /// Light space, m. The last receiver is followed by a vector that means nothing, as in the other arrays, so that vectors can be read
    /// from any receiver of a <see cref="Run"/> without range checks.
    /// </summary>
    public double[] U { get; private set; } = [];

    /// <inheritdoc cref="U"/>
    public double[] V { get; private set; } = [];

    /// <inheritdoc cref="U"/>
    public double[] W { get; private set; } = [];

    /// <summary>Pixels: row of the image times its width plus column.</summary>
    public int[] Pixels { get; private set; } = [];

    /// <summary>Across the rays.</summary>
    public LightAxis AxisU => _u;

    /// <summary>Across the rays.</summary>
    public LightAxis AxisV => _v;

    /// <summary>Begins a frame.</summary>
    /// <param name="box">Where most receivers will be; a bad guess costs time only.</param>
    /// <param name="receivers">How many there will be, about.</param>
    /// <param name="parts">Groups of rows that are counted and sorted at the same time.</param>
    /// <param name="length">Of the arrays of <see cref="ReceiverRows"/>.</param>
    public void Lay(LightBox box, int receivers, int parts, int length)
    {
        if (_bins.Length < length)
        {
            _bins = new int[length];
        }

        // A bin of about 2 x 2 pixels: larger ones give facets more receivers to try in vain, smaller ones more bins to visit.
        Size = Math.Clamp((int)Math.Sqrt(0.25 * receivers), 1, MaxBins);
        _u = new LightAxis(box.MinU, box.MaxU, Size);
        _v = new LightAxis(box.MinV, box.MaxV, Size);
        _depths.Prepare(Size);
        int room = Size * Size * 5 / 4; // the next frames' numbers differ a little
        if (_starts.Length < (Size * Size) + 1)
        {
            _starts = new int[room + 1];
            _isWanted = new byte[room];
        }

        if (_parts.Length < parts || _parts[0].Counts.Length < Size * Size)
        {
            _parts = [.. Enumerable.Range(0, Math.Max(parts, _parts.Length)).Select(_ => new Part(new int[room], new float[room]))];
        }

        foreach (Part part in _parts)
        {
            Array.Clear(part.Counts, 0, Size * Size);
            Array.Fill(part.Depths, float.NegativeInfinity, 0, Size * Size);
        }
    }

    /// <summary>Finds the bins of a row's receivers and leaves out those in the night.</summary>
    /// <param name="rows">The receivers.</param>
    /// <param name="row">Which row.</param>
    /// <param name="part">One thread counts and sorts the rows of a part.</param>
    /// <param name="night">Where it is dark for sure.</param>
    /// <returns>Bounds of the receivers that are left.</returns>
    public LightBox Count(ReceiverRows rows, int row, int part, NightZone night)
    {
        int start = rows.Start(row);
        int count = rows.Count(row);
        Span<long> lanes = stackalloc long[LaneCount];
        Span<float> depths = stackalloc float[LaneCount];
        (int[] counts, float[] max) = _parts[part];
        Vector512<double> minU = Vector512.Create(double.PositiveInfinity);
        Vector512<double> minV = minU;
        Vector512<double> maxU = -minU;
        Vector512<double> maxV = -minU;
        Vector512<double> size = Vector512.Create((double)Size);
        for (int i = 0; i < count; i += LaneCount)
        {
            Vector512<double> u = Vector512.LoadUnsafe(ref rows.U[0], (nuint)(start + i));
            Vector512<double> v = Vector512.LoadUnsafe(ref rows.V[0], (nuint)(start + i));
            Vector512<double> w = Vector512.LoadUnsafe(ref rows.W[0], (nuint)(start + i));
            Vector512<double> isNight = night.Holds(u, v, w);
            Vector512<double> isOut = isNight | Vector512.GreaterThanOrEqual(Lanes.Numbers, Vector512.Create((double)(count - i)));
            minU = Vector512.ConditionalSelect(isOut, minU, Vector512.MinNative(minU, u));
            minV = Vector512.ConditionalSelect(isOut, minV, Vector512.MinNative(minV, v));
            maxU = Vector512.ConditionalSelect(isOut, maxU, Vector512.MaxNative(maxU, u));
            maxV = Vector512.ConditionalSelect(isOut, maxV, Vector512.MaxNative(maxV, v));
            Vector512<double> bins = Vector512.ConditionalSelect(isNight, Vector512.Create(-1.0), (_v.BinsOf(v) * size) + _u.BinsOf(u));
            Vector512.ConvertToInt64Native(bins).CopyTo(lanes);
            Vector512.Narrow(w, w).GetLower().CopyTo(depths);
            for (int lane = 0; lane < Math.Min(LaneCount, count - i); lane++)
            {
                int bin = (int)lanes[lane];
                _bins[start + i + lane] = bin;
                if (bin >= 0)
                {
                    counts[bin]++;
                    max[bin] = Math.Max(max[bin], depths[lane]);
                }
            }
        }

        return new LightBox(Lanes.Min(minU), -Lanes.Min(-maxU), Lanes.Min(minV), -Lanes.Min(-maxV));
    }

    /// <summary>Gives each bin its place, and in it each part; finds the bins' depths. No bin is wanted yet.</summary>
    public void Place()
    {
        int next = 0;
        for (int bin = 0; bin < Size * Size; bin++)
        {
            _starts[bin] = next;
            float max = float.NegativeInfinity;
            foreach ((int[] counts, float[] depths) in _parts)
            {
                (counts[bin], next) = (next, next + counts[bin]);
                max = Math.Max(max, depths[bin]);
            }

            _depths.Bins[bin] = MathF.BitIncrement(max);
        }

        _depths.Finish();
        _wantsAll = false;
        Array.Clear(_isWanted, 0, Size * Size);
        _starts[Size * Size] = next;
        Length = next;
        if (U.Length < next + LaneCount)
        {
            int room = next + (next / 4) + LaneCount; // the next frames' numbers differ a little
            U = new double[room];
            V = new double[room];
            W = new double[room];
            Pixels = new int[room];
        }
    }

    /// <summary>Has some bins sorted. Several threads may call it.</summary>
    public void Want(GridRange bins)
    {
        for (int row = bins.FirstRow; row <= bins.LastRow; row++)
        {
            _isWanted.AsSpan((row * Size) + bins.FirstColumn, bins.LastColumn - bins.FirstColumn + 1).Fill(1);
        }
    }

    /// <summary>Has all bins sorted.</summary>
    public void WantAll() => _wantsAll = true;

    /// <summary>Puts a row's receivers into their bins, as far as these are wanted; the places of others mean nothing.</summary>
    /// <param name="rows">The receivers.</param>
    /// <param name="row">Which row.</param>
    /// <param name="part">As it was counted.</param>
    /// <param name="firstPixel">The row's first.</param>
    /// <param name="hide">Gets the pixels of those in the night.</param>
    public void Sort(ReceiverRows rows, int row, int part, int firstPixel, Action<int> hide)
    {
        int[] next = _parts[part].Counts;
        int start = rows.Start(row);
        for (int i = start; i < start + rows.Count(row); i++)
        {
            int bin = _bins[i];
            if (bin < 0)
            {
                hide(firstPixel + rows.Columns[i]);
            }
            else if (_wantsAll || _isWanted[bin] != 0)
            {
                int place = next[bin]++;
                U[place] = rows.U[i];
                V[place] = rows.V[i];
                W[place] = rows.W[i];
                Pixels[place] = firstPixel + rows.Columns[i];
            }
        }
    }

    /// <summary>The bins that a box touches.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public GridRange BinsOf(in LightBox box) =>
        new(_u.BinOf(box.MinU), _u.BinOf(box.MaxU), _v.BinOf(box.MinV), _v.BinOf(box.MaxV));

    /// <summary>No receiver in some bins is deeper; m, minus infinity if there is none. It may say too much.</summary>
    public float MaxDepth(GridRange bins) => _depths.Max(bins);

    /// <summary>No receiver is deeper; m.</summary>
    public float MaxDepth() => _depths.Max(new GridRange(0, Size - 1, 0, Size - 1));

    /// <summary>A bit for each lane of a vector from one receiver on that comes before another.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Meant(int receiver, int end) => (1u << Math.Min(end - receiver, LaneCount)) - 1;

    /// <summary>Lets no facet try a receiver any more. Any thread may do so.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void TakeOut(int receiver) => W[receiver] = double.NegativeInfinity;

    /// <summary>The receivers in neighbouring bins of a row.</summary>
    /// <returns>First receiver and one past the last.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (int First, int End) Run(int row, int firstColumn, int lastColumn)
    {
        Debug.Assert(row >= 0 && row < Size && firstColumn >= 0 && lastColumn < Size, "A bin lies outside the grid.");
        ref int start = ref Unsafe.Add(ref MemoryMarshal.GetArrayDataReference(_starts), row * Size);
        return (Unsafe.Add(ref start, firstColumn), Unsafe.Add(ref start, lastColumn + 1));
    }

    /// <summary>What one thread finds of the bins.</summary>
    /// <param name="Counts">Receivers of each; later the place of the next.</param>
    /// <param name="Depths">Maximum depth of each, m.</param>
    private sealed record Part(int[] Counts, float[] Depths);
}
