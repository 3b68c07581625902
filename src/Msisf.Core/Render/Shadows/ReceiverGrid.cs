using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Sorts the receivers of a frame into a grid of bins across the Sun's rays, by counting. Each step hands out what the next one needs, so
/// that none can be left out: <see cref="Lay"/> the rows to count, <see cref="Counting.Place"/> the bins to mark, and
/// <see cref="Placed.MakeRoom"/> the rows to sort.
/// </summary>
internal sealed class ReceiverGrid
{
    private const int LaneCount = 8;
    private const int MaxBins = 2048;
    private const int NoBin = -1;

    private readonly DepthGrid _depths = new();
    private readonly ReceiverArrays _arrays = new();
    private int[] _bins = []; // of each column of each row; below 0 without receiver
    private ReceiverBin[][] _parts = [];
    private byte[] _isWanted = [];
    private bool _wantsAll;
    private int[] _starts = [];
    private int _length;

    /// <summary>Bytes of the arrays that the grid has replaced by smaller or larger ones.</summary>
    public long ReplacedBytes => _arrays.ReplacedBytes;

    private int Size => _depths.Size;

    /// <summary>Begins a frame: sets the bins and clears their counts.</summary>
    /// <param name="box">Bounds of most receivers; a wrong estimate makes the search slower but not wrong.</param>
    /// <param name="receivers">Approximate number of receivers.</param>
    /// <param name="parts">Number of groups of rows that are counted and sorted at the same time.</param>
    /// <param name="length">Maximum number of receivers, with whole vectors in each row.</param>
    public Counting Lay(LightBox box, int receivers, int parts, int length)
    {
        if (_bins.Length < length)
        {
            _bins = new int[length];
        }

        // A bin of about 2 x 2 pixels: with larger bins facets test more receivers in vain, with smaller ones they visit more bins.
        int size = SizeFor(receivers);

        // Room for as many receivers as there are pixels: what no frame uses takes no memory, and arrays that grew with the frames of an
        // orbit would leave their predecessors behind.
        int maxSize = Math.Max(size, SizeFor(length));
        int room = maxSize * maxSize;
        _depths.Lay(box, size, maxSize);
        if (_starts.Length < room + 1)
        {
            _starts = new int[room + 1];
            _isWanted = new byte[room];
        }

        if (_parts.Length < parts || _parts[0].Length < room)
        {
            _parts = [.. Enumerable.Range(0, Math.Max(parts, _parts.Length)).Select(_ => new ReceiverBin[room])];
        }

        foreach (ReceiverBin[] part in _parts)
        {
            Array.Fill(part, ReceiverBin.Empty, 0, size * size);
        }

        return new Counting(this);
    }

    private LightBox Count(ReceiverRow row, int start, int number, NightZone night, DarkZone? dark, Action<int> hide)
    {
        int count = row.Count;
        Span<float> depths = stackalloc float[LaneCount];
        Span<int> numbers = stackalloc int[LaneCount];
        Span<int> bins = _bins.AsSpan(start, row.Width);
        bins.Fill(NoBin);
        ReadOnlySpan<double> us = row.U;
        ReadOnlySpan<double> vs = row.V;
        ReadOnlySpan<double> ws = row.W;
        Vector512<double> minU = Vector512.Create(double.PositiveInfinity);
        Vector512<double> minV = minU;
        Vector512<double> maxU = -minU;
        Vector512<double> maxV = -minU;
        Vector512<double> size = Vector512.Create((double)Size);
        (LightAxis axisU, LightAxis axisV) = (_depths.AxisU, _depths.AxisV);
        for (int i = 0; i < count; i += LaneCount)
        {
            Vector512<double> u = ArrayLanes.Load(us, i);
            Vector512<double> v = ArrayLanes.Load(vs, i);
            Vector512<double> w = ArrayLanes.Load(ws, i);
            Vector512<double> isNight = night.Holds(u, v, w) | (dark?.Holds(u, v, w) ?? Vector512<double>.Zero);
            Vector512<double> isOut = isNight | Vector512.GreaterThanOrEqual(Lanes.Numbers, Vector512.Create((double)(count - i)));
            minU = Vector512.ConditionalSelect(isOut, minU, Vector512.MinNative(minU, u));
            minV = Vector512.ConditionalSelect(isOut, minV, Vector512.MinNative(minV, v));
            maxU = Vector512.ConditionalSelect(isOut, maxU, Vector512.MaxNative(maxU, u));
            maxV = Vector512.ConditionalSelect(isOut, maxV, Vector512.MaxNative(maxV, v));
            Vector512<double> all = Vector512.ConditionalSelect(
                isNight, Vector512.Create((double)NoBin), (axisV.BinsOf(v) * size) + axisU.BinsOf(u));
            Vector512<long> whole = Vector512.ConvertToInt64Native(all);
            Vector512.Narrow(whole, whole).GetLower().CopyTo(numbers);
            Vector512.Narrow(w, w).GetLower().CopyTo(depths);
            ReceiverBin.Count(_parts[number], numbers[..Math.Min(LaneCount, count - i)], depths, row.Columns.AsSpan(i), bins, hide);
        }

        return new LightBox(Lanes.Min(minU), -Lanes.Min(-maxU), Lanes.Min(minV), -Lanes.Min(-maxV));
    }

    private Placed Place()
    {
        int next = 0;
        for (int bin = 0; bin < Size * Size; bin++)
        {
            _starts[bin] = next;
            float max = float.NegativeInfinity;
            foreach (ReceiverBin[] part in _parts)
            {
                (part[bin].Receivers, next) = (next, next + part[bin].Receivers);
                max = Math.Max(max, part[bin].Depth);
            }

            _depths.Bins[bin] = MathF.BitIncrement(max);
        }

        _depths.Finish();
        _wantsAll = false;
        Array.Clear(_isWanted, 0, Size * Size);
        _starts[Size * Size] = next;
        _length = next;
        return new Placed(this);
    }

    private Sorting MakeRoom()
    {
        if (!_wantsAll)
        {
            LeaveOutUnmarked();
        }

        _arrays.MakeRoom(_starts[Size * Size] + LaneCount, _bins.Length + LaneCount);
        return new Sorting(this);
    }

    private int FindMarked(int start, Span<int> columns)
    {
        ReadOnlySpan<int> bins = _bins.AsSpan(start, columns.Length);
        (byte[] isWanted, bool wantsAll) = (_isWanted, _wantsAll);
        int count = 0;
        for (int column = 0; column < bins.Length; column++)
        {
            columns[count] = column; // stays only if it is counted: a branch would often be mispredicted
            count += wantsAll ? ~bins[column] >>> 31 : bins[column] < 0 ? 0 : isWanted[bins[column]];
        }

        return count;
    }

    private void Sort(ReceiverRow row, int start, int part, int firstPixel)
    {
        ReceiverBin[] next = _parts[part];
        ReadOnlySpan<int> bins = _bins.AsSpan(start, row.Width);
        ReadOnlySpan<int> columns = row.Columns.AsSpan(0, row.Count);
        // read once, not for each receiver
        (double[] toU, double[] toV, double[] toW, int[] toPixels) = (_arrays.U, _arrays.V, _arrays.W, _arrays.Pixels);
        (double[] u, double[] v, double[] w) = (row.U, row.V, row.W);
        for (int i = 0; i < columns.Length; i++)
        {
            int place = next[bins[columns[i]]].Receivers++;
            toU[place] = u[i];
            toV[place] = v[i];
            toW[place] = w[i];
            toPixels[place] = firstPixel + columns[i];
        }
    }

    /// <summary>Gives the bins that are not marked empty ranges.</summary>
    private void LeaveOutUnmarked()
    {
        int next = 0;
        int first = _starts[0];
        for (int bin = 0; bin < Size * Size; bin++)
        {
            int end = _starts[bin + 1];
            _starts[bin] = next;
            if (_isWanted[bin] != 0)
            {
                foreach (ReceiverBin[] part in _parts)
                {
                    part[bin].Receivers -= first - next;
                }

                next += end - first;
            }

            first = end;
        }

        _starts[Size * Size] = next;
    }

    private static int SizeFor(int receivers) => Math.Clamp((int)Math.Sqrt(0.25 * receivers), 1, MaxBins);

    /// <summary>The bins are laid; the rows are counted.</summary>
    public readonly struct Counting(ReceiverGrid grid)
    {
        /// <summary>Finds the bins of a row's receivers and leaves out the receivers in the night zone.</summary>
        /// <param name="start">Where the row begins among all columns, with whole vectors in each row.</param>
        /// <param name="number">Index of the group of rows that this row belongs to; only one thread at a time may work on a group.</param>
        /// <param name="night">The zone in which every point is in shadow.</param>
        /// <param name="dark">A second zone in which every point is in shadow; null for none.</param>
        /// <param name="hide">Called with the column of each receiver in one of the zones.</param>
        /// <returns>Bounds of the receivers that are not left out.</returns>
        public LightBox Count(ReceiverRow row, int start, int number, NightZone night, DarkZone? dark, Action<int> hide) =>
            grid.Count(row, start, number, night, dark, hide);

        /// <summary>Gives each bin, and each part in it, its range in the arrays; finds the bins' depths; unmarks all bins.</summary>
        public Placed Place() => grid.Place();
    }

    /// <summary>All rows are counted; bins are marked.</summary>
    public readonly struct Placed(ReceiverGrid grid)
    {
        public DepthGrid Bins => grid._depths;

        /// <summary>Number of receivers.</summary>
        public int Length => grid._length;

        /// <summary>Marks bins, so that their receivers are sorted. Several threads may call it.</summary>
        public void Want(GridRange bins)
        {
            for (int row = bins.FirstRow; row <= bins.LastRow; row++)
            {
                grid._isWanted.AsSpan((row * grid.Size) + bins.FirstColumn, bins.LastColumn - bins.FirstColumn + 1).Fill(1);
            }
        }

        /// <summary>Marks all bins.</summary>
        public void WantAll() => grid._wantsAll = true;

        /// <summary>Finds the columns of a row's receivers whose bins are marked, from left to right.</summary>
        /// <param name="start">The same place as in <see cref="Counting.Count"/>.</param>
        /// <param name="columns">Receives them; as long as the image is wide.</param>
        public int FindMarked(int start, Span<int> columns) => grid.FindMarked(start, columns);

        /// <summary>Makes room for the receivers of the marked bins; gives back memory that the last frames did not need.</summary>
        public Sorting MakeRoom() => grid.MakeRoom();
    }

    /// <summary>Bins are marked; the rows are sorted.</summary>
    public readonly struct Sorting(ReceiverGrid grid)
    {
        /// <summary>Puts a row's marked receivers into their bins.</summary>
        /// <param name="row">The receivers, in any order.</param>
        /// <param name="start">The same place as in <see cref="Counting.Count"/>.</param>
        /// <param name="part">The same index as in <see cref="Counting.Count"/>.</param>
        /// <param name="firstPixel">Index of the row's first pixel.</param>
        public void Sort(ReceiverRow row, int start, int part, int firstPixel) => grid.Sort(row, start, part, firstPixel);

        /// <summary>The receivers, once all rows are sorted.</summary>
        public SortedReceivers Finish(PlacedReceivers placed) => new(placed, grid._arrays, grid._starts);
    }
}
