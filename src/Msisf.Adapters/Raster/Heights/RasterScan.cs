using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// What all pixels of a raster are: bounds of its squares of 256 pixels, and how many pixels are no data though the file does not say so.
/// Immutable once it is made.
/// </summary>
internal sealed class RasterScan
{
    /// <summary>px: side of a square.</summary>
    public const int Side = 1 << SideShift;

    /// <summary>Binary logarithm of <see cref="Side"/>.</summary>
    public const int SideShift = 8;

    /// <summary>Takes the bounds of the squares, row by row.</summary>
    public RasterScan(int rows, int columns, ScannedSquare[] squares, UndeclaredGaps undeclared)
    {
        (Rows, Columns, Squares, Undeclared) = (rows, columns, squares, undeclared);
        HasGaps = Array.Exists(squares, square => square.Gaps > 0);
    }

    /// <summary>Squares from top to bottom.</summary>
    public int Rows { get; }

    /// <summary>Squares from left to right.</summary>
    public int Columns { get; }

    /// <summary>The squares, row by row.</summary>
    public ScannedSquare[] Squares { get; }

    /// <summary>Pixels that can't be heights, which the file does not declare.</summary>
    public UndeclaredGaps Undeclared { get; }

    /// <summary>Whether any pixel has no data.</summary>
    public bool HasGaps { get; }

    /// <summary>The square of a pixel.</summary>
    public ref readonly ScannedSquare At(int row, int column) =>
        ref Squares[((row >> SideShift) * Columns) + (column >> SideShift)];

    /// <summary>Looks at all pixels.</summary>
    /// <param name="height">Rows of pixels.</param>
    /// <param name="width">Pixels of a row.</param>
    /// <param name="blockAt">The pixels of a square, NaN without data; rows are <see cref="Side"/> apart.</param>
    /// <param name="undeclared">What was found besides.</param>
    /// <param name="progress">Receives the fraction that is done; null for nobody.</param>
    /// <param name="cancellation">Cancels the work.</param>
    public static RasterScan Of(
        int height, int width, Func<int, int, float[]> blockAt, Func<UndeclaredGaps> undeclared, IProgress<double>? progress,
        CancellationToken cancellation)
    {
        (int rows, int columns) = ((height + Side - 1) >> SideShift, (width + Side - 1) >> SideShift);
        ScannedSquare[] squares = new ScannedSquare[rows * columns];
        int done = 0;
        ParallelOptions options = new() { MaxDegreeOfParallelism = Environment.ProcessorCount, CancellationToken = cancellation };
        Parallel.For(0, rows, options, row =>
        {
            for (int column = 0; column < columns; column++)
            {
                float[] block = blockAt(row, column);
                int lines = Math.Min(Side, height - (row << SideShift));
                int samples = Math.Min(Side, width - (column << SideShift));
                squares[(row * columns) + column] = ScannedSquare.Of(
                    block, lines, samples,
                    column + 1 < columns ? blockAt(row, column + 1) : null,
                    row + 1 < rows ? blockAt(row + 1, column) : null,
                    row + 1 < rows && column + 1 < columns ? blockAt(row + 1, column + 1)[0] : float.NaN);
            }

            progress?.Report(Interlocked.Increment(ref done) / (double)rows);
        });
        return new RasterScan(rows, columns, squares, undeclared());
    }
}

/// <summary>Bounds of the stored values of a square and of the pixels along its right and lower side, which its cells end in.</summary>
/// <param name="Min">The least value; infinity if there is none.</param>
/// <param name="Max">The greatest value; minus infinity if there is none.</param>
/// <param name="Step">The greatest difference of neighbouring values of a row or a column.</param>
/// <param name="Gaps">Pixels of the square without data.</param>
internal readonly record struct ScannedSquare(float Min, float Max, float Step, int Gaps)
{
    private const int Side = RasterScan.Side;

    /// <summary>Looks at a square.</summary>
    /// <param name="block">Its pixels.</param>
    /// <param name="lines">Rows that it has.</param>
    /// <param name="samples">Pixels of a row that it has.</param>
    /// <param name="right">The square to the right; null if there is none.</param>
    /// <param name="below">The square below; null if there is none.</param>
    /// <param name="corner">The pixel to the right of the pixel below its last one; NaN if there is none.</param>
    public static ScannedSquare Of(float[] block, int lines, int samples, float[]? right, float[]? below, float corner)
    {
        (float min, float max, float step, int gaps) = (float.PositiveInfinity, float.NegativeInfinity, 0.0F, 0);
        for (int line = 0; line < lines; line++)
        {
            ReadOnlySpan<float> row = block.AsSpan(line * Side, samples);
            ReadOnlySpan<float> next = line + 1 < lines ? block.AsSpan((line + 1) * Side, samples)
                : below is not null ? below.AsSpan(0, samples) : row;
            for (int i = 0; i < samples; i++)
            {
                Add(row[i], i + 1 < samples ? row[i + 1] : right is not null ? right[line * Side] : float.NaN, next[i]);
                gaps += float.IsNaN(row[i]) ? 1 : 0;
            }
        }

        for (int i = 0; below is not null && i < samples; i++)
        {
            Add(below[i], i + 1 < samples ? below[i + 1] : corner, float.NaN);
        }

        for (int i = 0; right is not null && i < lines; i++)
        {
            Add(right[i * Side], float.NaN, i + 1 < lines ? right[(i + 1) * Side] : corner);
        }

        Add(corner, float.NaN, float.NaN);
        return new ScannedSquare(min, max, step, gaps);

        // A comparison with NaN is false, so places without data count for nothing.
        void Add(float value, float east, float south)
        {
            min = value < min ? value : min;
            max = value > max ? value : max;
            float eastStep = Math.Abs(east - value);
            float southStep = Math.Abs(south - value);
            step = eastStep > step ? eastStep : step;
            step = southStep > step ? southStep : step;
        }
    }
}

/// <summary>Pixels that can't be heights, though the file does not declare them as without data.</summary>
/// <param name="Count">How many.</param>
/// <param name="Line">Row of the first one, from 0.</param>
/// <param name="Sample">Its place in the row, from 0.</param>
/// <param name="Value">Its value.</param>
internal readonly record struct UndeclaredGaps(long Count, int Line, int Sample, float Value)
{
    /// <summary>None.</summary>
    public static UndeclaredGaps None => new(0, int.MaxValue, int.MaxValue, 0.0F);

    /// <summary>With one more.</summary>
    public UndeclaredGaps With(int line, int sample, float value) => (line, sample).CompareTo((Line, Sample)) < 0
        ? new UndeclaredGaps(Count + 1, line, sample, value)
        : this with { Count = Count + 1 };

    /// <summary>Both together.</summary>
    public UndeclaredGaps With(UndeclaredGaps other) =>
        ((Line, Sample).CompareTo((other.Line, other.Sample)) < 0 ? this : other) with { Count = Count + other.Count };
}
