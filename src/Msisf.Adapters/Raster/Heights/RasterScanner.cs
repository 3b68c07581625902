using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// Looks once at all pixels of a raster. It goes down strips of columns, several at a time; each reads the file for itself.
/// </summary>
internal sealed class RasterScanner
{
    private const int Side = RasterScan.Side;
    private const int SideShift = RasterScan.SideShift;

    /// <summary>px: width of a strip; a file that is stored in whole rows has one strip.</summary>
    private const int StripWidth = 16 * Side;

    /// <summary>px: rows that are read together.</summary>
    private const int ChunkLines = 2 * Side;

    /// <summary>Samples of the coarser level at most: 16 MB.</summary>
    private const long MostLevelSamples = 1L << 22;

    private readonly RasterBlocks _blocks;
    private readonly double _sphere;
    private readonly HeightRule _rule;
    private readonly int _width;
    private readonly int _strips;
    private readonly int _columns;
    private readonly ScannedSquare[] _squares;
    private readonly float[][] _lastColumns;
    private readonly float[][] _firstColumns;
    private readonly int _halvings;
    private readonly int _levelSamples;
    private readonly float[] _level;
    private readonly RasterBorder _border;

    private RasterScanner(RasterBlocks blocks, double sphere, HeightRule rule, bool hasLevel)
    {
        (_blocks, _sphere, _rule) = (blocks, sphere, rule);
        _width = blocks.HasWideBlocks ? blocks.Width : Math.Min(StripWidth, blocks.Width);
        _strips = (blocks.Width + _width - 1) / _width;
        _columns = (blocks.Width + Side - 1) >> SideShift;
        _squares = new ScannedSquare[((blocks.Height + Side - 1) >> SideShift) * _columns];
        Array.Fill(_squares, ScannedSquare.None);
        _lastColumns = new float[_strips][];
        _firstColumns = new float[_strips][];
        _border = new RasterBorder(blocks.Height, blocks.Width);
        while (hasLevel && SizeOf(blocks.Height) * (long)SizeOf(blocks.Width) > MostLevelSamples)
        {
            _halvings++;
        }

        hasLevel = _halvings > 0 && 1 << _halvings <= ChunkLines;
        _halvings = hasLevel ? _halvings : 0;
        _levelSamples = hasLevel ? SizeOf(blocks.Width) : 0;
        _level = new float[hasLevel ? SizeOf(blocks.Height) * _levelSamples : 0];
    }

    /// <summary>Looks at all pixels.</summary>
    /// <param name="sphere">m: radius of the sphere over which the heights are.</param>
    /// <param name="rule">What the stored values mean.</param>
    /// <param name="hasLevel">Whether a coarser level is wanted, whose samples begin with the first pixel.</param>
    /// <param name="progress">Receives the fraction that is done; null for nobody.</param>
    public static RasterScan Scan(
        RasterBlocks blocks, double sphere, HeightRule rule, bool hasLevel, IProgress<double>? progress, CancellationToken cancellation)
    {
        RasterScanner scanner = new(blocks, sphere, rule, hasLevel);
        UndeclaredGaps undeclared = UndeclaredGaps.None;
        Lock gate = new();
        long done = 0;
        ParallelOptions options = new() { MaxDegreeOfParallelism = Environment.ProcessorCount, CancellationToken = cancellation };
        Parallel.For(0, scanner._strips, options, strip =>
        {
            UndeclaredGaps found = scanner.ScanStrip(strip, lines =>
            {
                cancellation.ThrowIfCancellationRequested();
                progress?.Report(Interlocked.Add(ref done, lines) / ((double)blocks.Height * scanner._strips));
            });
            lock (gate)
            {
                undeclared = undeclared.With(found);
            }
        });
        scanner.AddStepsBetweenStrips();
        return new RasterScan(
            scanner._squares.Length / scanner._columns, scanner._columns, scanner._squares, undeclared, scanner._halvings, scanner._level,
            scanner._border);
    }

    private double RadiusOf(float value) => _sphere + _rule.HeightOf(value);

    private int SizeOf(int pixels) => (pixels + (1 << _halvings) - 1) >> _halvings;

    private UndeclaredGaps ScanStrip(int strip, Action<int> report)
    {
        int first = strip * _width;
        int samples = Math.Min(_width, _blocks.Width - first);
        float[] values = new float[(ChunkLines + 1) * samples]; // the first row is the last one of the chunk above
        values.AsSpan(0, samples).Fill(float.NaN);
        (_firstColumns[strip], _lastColumns[strip]) = (new float[_blocks.Height], new float[_blocks.Height]);
        double[] means = new double[_halvings > 0 ? (ChunkLines / 2) * ((samples + 1) / 2) : 0];
        UndeclaredGaps undeclared = UndeclaredGaps.None;
        for (int line = 0; line < _blocks.Height; line += ChunkLines)
        {
            int lines = Math.Min(ChunkLines, _blocks.Height - line);
            undeclared = undeclared.With(_blocks.Read(line, lines, first, samples, values.AsSpan(samples), samples));
            for (int i = 0; i < lines; i++)
            {
                ReadOnlySpan<float> above = values.AsSpan(i * samples, samples);
                ReadOnlySpan<float> row = values.AsSpan((i + 1) * samples, samples);
                (_firstColumns[strip][line + i], _lastColumns[strip][line + i]) = (row[0], row[^1]);
                _border.Take(line + i, first, row);
                for (int start = 0; start < samples; start += Side)
                {
                    ref ScannedSquare square = ref _squares[(((line + i) >> SideShift) * _columns) + ((first + start) >> SideShift)];
                    square = square.With(Of(row, above, start, Math.Min(Side, samples - start)));
                }
            }

            Reduce(values.AsSpan(samples), means, line, lines, first, samples);
            values.AsSpan(lines * samples, samples).CopyTo(values);
            report(lines);
        }

        return undeclared;
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

    private void AddStepsBetweenStrips()
    {
        for (int strip = 1; strip < _strips; strip++)
        {
            for (int line = 0; line < _blocks.Height; line++)
            {
                float step = Math.Abs(_firstColumns[strip][line] - _lastColumns[strip - 1][line]);
                ref ScannedSquare square = ref _squares[((line >> SideShift) * _columns) + ((strip * _width) >> SideShift)];
                square = step > square.Step ? square with { Step = step } : square;
            }
        }
    }

    /// <summary>Computes the samples of the coarser level that stand for a chunk, in the steps of <see cref="BlockReducer"/>.</summary>
    private void Reduce(ReadOnlySpan<float> values, double[] means, int line, int lines, int first, int samples)
    {
        if (_halvings == 0)
        {
            return;
        }

        int stride = (samples + 1) / 2;
        double reference = MoonConstants.ReferenceRadius;
        (int height, int width) = ((lines + 1) / 2, stride);
        for (int row = 0; row < height; row++)
        {
            ReadOnlySpan<float> north = values.Slice(2 * row * samples, samples);
            ReadOnlySpan<float> south = values.Slice(Math.Min((2 * row) + 1, lines - 1) * samples, samples);
            for (int i = 0; i < width; i++)
            {
                int right = Math.Min((2 * i) + 1, samples - 1);
                means[(row * stride) + i] = BlockReducer.MeanOf(
                    RadiusOf(north[2 * i]), RadiusOf(south[2 * i]), RadiusOf(north[right]), RadiusOf(south[right]), reference);
            }
        }

        for (int halving = 1; halving < _halvings; halving++)
        {
            (int below, int rightmost) = (height - 1, width - 1);
            (height, width) = ((height + 1) / 2, (width + 1) / 2);
            for (int row = 0; row < height; row++)
            {
                (int north, int south) = (2 * row * stride, Math.Min((2 * row) + 1, below) * stride);
                for (int i = 0; i < width; i++)
                {
                    int right = Math.Min((2 * i) + 1, rightmost);
                    means[(row * stride) + i] = BlockReducer.MeanOf(
                        means[north + (2 * i)], means[south + (2 * i)], means[north + right], means[south + right], reference);
                }
            }
        }

        for (int row = 0; row < height; row++)
        {
            int start = (((line >> _halvings) + row) * _levelSamples) + (first >> _halvings);
            for (int i = 0; i < width; i++)
            {
                _level[start + i] = (float)(means[(row * stride) + i] - reference);
            }
        }
    }
}
