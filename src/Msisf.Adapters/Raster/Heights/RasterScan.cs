using Msisf.Core.Surface.Sources;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// What all pixels of a raster are: bounds of squares of 256 pixels, its border, and how many pixels are no data though the file does not
/// say so. Immutable once it is made.
/// </summary>
/// <param name="Layout">Where the squares lie.</param>
/// <param name="Squares">The squares, row by row.</param>
/// <param name="Undeclared">Pixels that can't be heights, which the file does not declare.</param>
/// <param name="Border">The outermost pixels, and those within.</param>
internal sealed record RasterScan(SquareGrid Layout, ScannedSquare[] Squares, UndeclaredGaps Undeclared, RasterBorder Border)
{
    /// <summary>Whether any pixel has no data.</summary>
    public bool HasGaps { get; } = Array.Exists(Squares, square => square.Gaps > 0);

    /// <summary>Whether another scan has found the same.</summary>
    public bool IsSameAs(RasterScan other) =>
        (Layout, Undeclared) == (other.Layout, other.Undeclared) && Squares.AsSpan().SequenceEqual(other.Squares)
        && Border.Values.AsSpan().SequenceEqual(other.Border.Values);

    /// <summary>The squares of a rectangle of pixels together.</summary>
    public ScannedSquare Of(int firstRow, int rows, int firstColumn, int columns)
    {
        ScannedSquare all = ScannedSquare.None;
        int last = Layout.IndexOf(firstRow + rows - 1, firstColumn);
        for (int row = Layout.IndexOf(firstRow, firstColumn); row <= last; row += Layout.Columns)
        {
            int end = row + Layout.ColumnOf(firstColumn + columns - 1) - Layout.ColumnOf(firstColumn);
            for (int square = row; square <= end; square++)
            {
                all = all.With(Squares[square]);
            }
        }

        return all;
    }
}

/// <summary>Squares of 256 pixels of a raster, which begin at multiples of 256 of the whole grid, as blocks of levels do.</summary>
/// <param name="RowOffset">Pixels of the grid before the raster's first row in the first square, 0 to 255.</param>
/// <param name="ColumnOffset">The same of its first column.</param>
/// <param name="Rows">Squares from top to bottom.</param>
/// <param name="Columns">Squares from left to right.</param>
internal readonly record struct SquareGrid(int RowOffset, int ColumnOffset, int Rows, int Columns)
{
    /// <summary>px: side of a square.</summary>
    public const int Side = 1 << SideShift;

    /// <summary>Binary logarithm of <see cref="Side"/>.</summary>
    public const int SideShift = 8;

    /// <summary>The squares of a raster.</summary>
    /// <param name="height">px.</param>
    /// <param name="width">px.</param>
    /// <param name="line">Line of its first row in the grid.</param>
    /// <param name="sample">Sample of its first column.</param>
    public static SquareGrid Of(int height, int width, int line, int sample)
    {
        (int row, int column) = (line & (Side - 1), sample & (Side - 1));
        return new SquareGrid(row, column, (row + height + Side - 1) >> SideShift, (column + width + Side - 1) >> SideShift);
    }

    /// <summary>The column of squares in which a pixel lies.</summary>
    public int ColumnOf(int column) => (ColumnOffset + column) >> SideShift;

    /// <summary>Index of the square in which a pixel lies.</summary>
    public int IndexOf(int row, int column) => (((RowOffset + row) >> SideShift) * Columns) + ColumnOf(column);
}

/// <summary>Bounds of the stored values of a square.</summary>
/// <param name="Min">The least value; infinity if there is none.</param>
/// <param name="Max">The greatest value; minus infinity if there is none.</param>
/// <param name="Step">The greatest difference of a value and its neighbour to the left or above, in whichever square that is.</param>
/// <param name="Gaps">Pixels of the square without data.</param>
internal readonly record struct ScannedSquare(float Min, float Max, float Step, int Gaps)
{
    /// <summary>No square.</summary>
    public static ScannedSquare None => new(float.PositiveInfinity, float.NegativeInfinity, 0.0F, 0);

    /// <summary>Both together.</summary>
    public ScannedSquare With(ScannedSquare other) =>
        new(Math.Min(Min, other.Min), Math.Max(Max, other.Max), Math.Max(Step, other.Step), Gaps + other.Gaps);
}

/// <summary>Pixels that can't be heights, though the file does not declare them as without data.</summary>
/// <param name="Line">Row of the first one, from 0.</param>
/// <param name="Sample">Its place in the row, from 0.</param>
internal readonly record struct UndeclaredGaps(long Count, int Line, int Sample, float Value)
{
    /// <summary>None.</summary>
    public static UndeclaredGaps None => new(0, int.MaxValue, int.MaxValue, 0.0F);

    /// <summary>A sentence for the log.</summary>
    /// <param name="name">The model's, or its file's.</param>
    public static string NoteOf(string name, UndeclaredGaps gaps) => Invariant(
        $"{name}: {gaps.Count} pixels cannot be heights, though the file does not say that they have no data; the first is line "
            + $"{gaps.Line + 1}, sample {gaps.Sample + 1} ({gaps.Value:R}). They are left without ground, or to a coarser model.");

    /// <summary>With one more.</summary>
    public UndeclaredGaps With(int line, int sample, float value) => With(new UndeclaredGaps(1, line, sample, value));

    /// <summary>Both together.</summary>
    public UndeclaredGaps With(UndeclaredGaps other) =>
        ((Line, Sample).CompareTo((other.Line, other.Sample)) < 0 ? this : other) with { Count = Count + other.Count };
}

/// <summary>Shows how far a work has come.</summary>
/// <param name="progress">Receives the fraction that is done.</param>
/// <param name="display">Ends the display.</param>
public sealed class FractionDisplay(IProgress<double> progress, IDisposable display) : IDisposable
{
    /// <summary>Receives the fraction that is done.</summary>
    public IProgress<double> Progress => progress;

    /// <summary>Ends the display.</summary>
    public void Dispose() => display.Dispose();
}

/// <summary>
/// The values of a raster's outermost pixels, and of those between which and them its slope is taken. Each run needs them where the raster
/// lies in a coarser model: read from the file, each block along the border would be unpacked for them.
/// </summary>
/// <param name="Height">Number of rows.</param>
/// <param name="Width">Pixels of a row.</param>
/// <param name="Values">NaN without data: four rows, then four columns (<see cref="IndexOf"/>).</param>
internal sealed record RasterBorder(int Height, int Width, float[] Values)
{
    private const int Inwards = BorderMisfit.SlopeSamples;

    /// <summary>A border to fill.</summary>
    public RasterBorder(int height, int width)
        : this(height, width, new float[4 * (height + width)])
    {
    }

    /// <summary>Takes what lies on the border of a part of a row. Safe for several threads that have other pixels.</summary>
    /// <param name="first">Column of the first value.</param>
    public void Take(int row, int first, ReadOnlySpan<float> values)
    {
        if (IndexOf(row, Height) is >= 0 and int line)
        {
            values.CopyTo(Values.AsSpan((line * Width) + first));
        }

        foreach (int column in (ReadOnlySpan<int>)[0, Inwards, Width - 1 - Inwards, Width - 1])
        {
            if (column >= first && column < first + values.Length)
            {
                Values[IndexInColumn(row, IndexOf(column, Width))] = values[column - first];
            }
        }
    }

    /// <summary>The values of the next pixels of a row, as many as lie on the border; empty if the first one does not.</summary>
    /// <param name="column">The first.</param>
    /// <param name="most">At most so many.</param>
    public ReadOnlySpan<float> RunAt(int row, int column, int most) =>
        IndexOf(row, Height) is >= 0 and int line ? Values.AsSpan((line * Width) + column, Math.Min(most, Width - column))
        : IndexOf(column, Width) is >= 0 and int index ? Values.AsSpan(IndexInColumn(row, index), 1)
        : default;

    private int IndexInColumn(int row, int index) => (4 * Width) + (index * Height) + row;

    /// <summary>Which of the four rows or columns a place is; -1 for none.</summary>
    private static int IndexOf(int place, int count) =>
        place == 0 ? 0 : place == Inwards ? 1 : place == count - 1 - Inwards ? 2 : place == count - 1 ? 3 : -1;
}
