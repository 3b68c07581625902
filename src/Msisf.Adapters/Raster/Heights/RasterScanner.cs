using System.Collections.Concurrent;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// Looks once at all pixels of a raster, band by band from the top. Several strips of a band are looked at at once; each reads the file for
/// itself.
/// </summary>
internal sealed class RasterScanner
{
    /// <summary>px: width of a strip; a file that is stored in whole rows has one strip.</summary>
    private const int StripWidth = 4096;

    private readonly RasterBlocks _blocks;
    private readonly RasterLevels _levels;
    private readonly GridWindow _window;
    private readonly SquareGrid _layout;
    private readonly ScannedSquare[] _squares;
    private readonly RasterBorder _border;
    private readonly float[] _lastRow;
    private readonly ConcurrentBag<float[]> _buffers = [];
    private readonly Lock _gate = new();
    private UndeclaredGaps _undeclared = UndeclaredGaps.None;

    private RasterScanner(RasterBlocks blocks, GridWindow window, RasterLevels levels)
    {
        (_blocks, _window, _levels) = (blocks, window, levels);
        _layout = SquareGrid.Of(blocks.Height, blocks.Width, window.FirstLine, window.FirstSample);
        _squares = new ScannedSquare[_layout.Rows * _layout.Columns];
        Array.Fill(_squares, ScannedSquare.None);
        _border = new RasterBorder(blocks.Height, blocks.Width);
        _lastRow = new float[blocks.Width];
        Array.Fill(_lastRow, float.NaN);
    }

    /// <summary>Looks at all pixels.</summary>
    /// <param name="window">Where they lie in the grid.</param>
    /// <param name="levels">Makes the coarser levels.</param>
    /// <param name="progress">Receives the fraction that is done; null for nobody.</param>
    public static RasterScan Scan(
        RasterBlocks blocks, GridWindow window, RasterLevels levels, IProgress<double>? progress, CancellationToken cancellation)
    {
        RasterScanner scanner = new(blocks, window, levels);
        ParallelOptions options = new() { MaxDegreeOfParallelism = Environment.ProcessorCount, CancellationToken = cancellation };
        (int Start, int Count)[] strips =
            blocks.HasWideBlocks ? [(0, blocks.Width)] : [.. Parts(blocks.Width, window.FirstSample, Math.Max(StripWidth, levels.Step))];
        float[][] columns = new float[2 * strips.Length][];
        foreach ((int row, int rows) in Parts(blocks.Height, window.FirstLine, levels.Step))
        {
            levels.Begin(window.FirstLine + row, rows);
            Parallel.For(0, strips.Length, options, strip => (columns[2 * strip], columns[(2 * strip) + 1]) =
                scanner.ScanPart(row, rows, strips[strip].Start, strips[strip].Count));
            for (int strip = 1; strip < strips.Length; strip++)
            {
                scanner.AddSteps(row, strips[strip].Start, columns[(2 * strip) - 1], columns[2 * strip]);
            }

            if (blocks.IsRing)
            {
                scanner.AddSteps(row, 0, columns[^1], columns[0]);
            }

            levels.Write(window.FirstLine + row, rows);
            progress?.Report((row + rows) / (double)blocks.Height);
        }

        return new RasterScan(scanner._layout, scanner._squares, blocks.Counted(scanner._undeclared), scanner._border);
    }

    /// <summary>Cuts a side where the grid's coordinate is a multiple of a step.</summary>
    private static IEnumerable<(int Start, int Count)> Parts(int size, int first, int step)
    {
        for (int start = 0, count; start < size; start += count)
        {
            count = Math.Min(step - ((first + start) & (step - 1)), size - start);
            yield return (start, count);
        }
    }

    /// <summary>Looks at a part.</summary>
    /// <returns>Its first and its last column.</returns>
    private (float[] First, float[] Last) ScanPart(int row, int rows, int first, int count)
    {
        float[] values = _buffers.TryTake(out float[]? used) && used.Length >= (rows + 1) * count ? used : new float[(rows + 1) * count];
        _lastRow.AsSpan(first, count).CopyTo(values); // the first row is the last one above
        UndeclaredGaps undeclared = _blocks.Read(row, rows, first, count, values.AsSpan(count), count);
        (float[] firstColumn, float[] lastColumn) = (new float[rows], new float[rows]);
        bool hasGaps = false;
        for (int i = 0; i < rows; i++)
        {
            ReadOnlySpan<float> above = values.AsSpan(i * count, count);
            ReadOnlySpan<float> here = values.AsSpan((i + 1) * count, count);
            (firstColumn[i], lastColumn[i]) = (here[0], here[^1]);
            _border.Take(row + i, first, here);
            foreach ((int start, int samples) in Parts(count, _window.FirstSample + first, SquareGrid.Side))
            {
                ScannedSquare part = Of(here, above, start, samples);
                hasGaps |= part.Gaps > 0;
                ref ScannedSquare square = ref _squares[_layout.IndexOf(row + i, first + start)];
                square = square.With(part);
            }
        }

        _levels.Reduce(new GridWindow(
            _window.FirstLine + row, _window.FirstLine + row + rows, _window.FirstSample + first, _window.FirstSample + first + count),
            values.AsMemory(count, rows * count), hasGaps);
        values.AsSpan(rows * count, count).CopyTo(_lastRow.AsSpan(first));
        _buffers.Add(values);
        lock (_gate)
        {
            _undeclared = _undeclared.With(undeclared);
        }

        return (firstColumn, lastColumn);
    }

    /// <summary>Adds the steps from one strip to the next.</summary>
    private void AddSteps(int row, int column, float[] west, float[] east)
    {
        for (int i = 0; i < west.Length; i++)
        {
            float step = Math.Abs(east[i] - west[i]);
            ref ScannedSquare square = ref _squares[_layout.IndexOf(row + i, column)];
            square = step > square.Step ? square with { Step = step } : square;
        }
    }

    /// <summary>Bounds of a part of a row. Places without data count for nothing: a comparison with NaN is false.</summary>
    private static ScannedSquare Of(ReadOnlySpan<float> all, ReadOnlySpan<float> allAbove, int start, int count)
    {
        ReadOnlySpan<float> row = all.Slice(start, count);
        ReadOnlySpan<float> above = allAbove.Slice(start, count);
        (float least, float most, float widest, int gaps, int i) = (float.PositiveInfinity, float.NegativeInfinity, 0.0F, 0, 0);
        Add(row[0], start > 0 ? all[start - 1] : float.NaN, above[0]);
        (Vector256<float> min, Vector256<float> max, Vector256<float> step) =
            (Vector256.Create(least), Vector256.Create(most), Vector256.Create(widest));
        ref float values = ref MemoryMarshal.GetReference(row);
        for (i = 1; i <= count - Vector256<float>.Count; i += Vector256<float>.Count)
        {
            Vector256<float> value = Vector256.LoadUnsafe(ref values, (nuint)i);
            Vector256<float> west = Vector256.Abs(value - Vector256.LoadUnsafe(ref values, (nuint)(i - 1)));
            Vector256<float> north = Vector256.Abs(value - Vector256.Create(above[i..]));
            min = Vector256.ConditionalSelect(Vector256.LessThan(value, min), value, min);
            max = Vector256.ConditionalSelect(Vector256.GreaterThan(value, max), value, max);
            step = Vector256.ConditionalSelect(Vector256.GreaterThan(west, step), west, step);
            step = Vector256.ConditionalSelect(Vector256.GreaterThan(north, step), north, step);
            gaps += Vector256<float>.Count - int.PopCount((int)Vector256.Equals(value, value).ExtractMostSignificantBits());
        }

        for (int lane = 0; lane < Vector256<float>.Count; lane++)
        {
            (least, most, widest) = (Math.Min(least, min[lane]), Math.Max(most, max[lane]), Math.Max(widest, step[lane]));
        }

        for (; i < count; i++)
        {
            Add(row[i], row[i - 1], above[i]);
        }

        return new ScannedSquare(least, most, widest, gaps);

        void Add(float value, float west, float north)
        {
            least = value < least ? value : least;
            most = value > most ? value : most;
            widest = Math.Abs(value - west) > widest ? Math.Abs(value - west) : widest;
            widest = Math.Abs(value - north) > widest ? Math.Abs(value - north) : widest;
            gaps += float.IsNaN(value) ? 1 : 0;
        }
    }
}
