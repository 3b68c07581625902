namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// What all pixels of a raster are: bounds of its squares of 256 pixels, a coarser level, its border, and how many pixels are no data
/// though the file does not say so. Immutable once it is made.
/// </summary>
/// <param name="Rows">Squares from top to bottom.</param>
/// <param name="Columns">Squares from left to right.</param>
/// <param name="Squares">The squares, row by row.</param>
/// <param name="Undeclared">Pixels that can't be heights, which the file does not declare.</param>
/// <param name="Halvings">How many times the resolution of the coarser level is halved; 0 if there is none.</param>
/// <param name="Level">m over the reference radius, NaN without data: the level line by line.</param>
/// <param name="Border">The outermost pixels, and those within.</param>
internal sealed record RasterScan(
    int Rows, int Columns, ScannedSquare[] Squares, UndeclaredGaps Undeclared, int Halvings, float[] Level, RasterBorder Border)
{
    /// <summary>px: side of a square.</summary>
    public const int Side = 1 << SideShift;

    /// <summary>Binary logarithm of <see cref="Side"/>.</summary>
    public const int SideShift = 8;

    /// <summary>Whether any pixel has no data.</summary>
    public bool HasGaps { get; } = Array.Exists(Squares, square => square.Gaps > 0);

    /// <summary>Whether another scan has found the same.</summary>
    public bool IsSameAs(RasterScan other) =>
        (Rows, Columns, Undeclared, Halvings) == (other.Rows, other.Columns, other.Undeclared, other.Halvings)
        && Squares.AsSpan().SequenceEqual(other.Squares) && Level.AsSpan().SequenceEqual(other.Level)
        && Border.Values.AsSpan().SequenceEqual(other.Border.Values);

    /// <summary>The squares of a rectangle of pixels together.</summary>
    public ScannedSquare Of(int firstRow, int rows, int firstColumn, int columns)
    {
        ScannedSquare all = ScannedSquare.None;
        for (int row = firstRow >> SideShift; row <= (firstRow + rows - 1) >> SideShift; row++)
        {
            for (int column = firstColumn >> SideShift; column <= (firstColumn + columns - 1) >> SideShift; column++)
            {
                all = all.With(Squares[(row * Columns) + column]);
            }
        }

        return all;
    }
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
