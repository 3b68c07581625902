namespace Msisf.Core.Render.Shadows;

/// <summary>A rectangle of bins of a grid; the last column and the last row are included.</summary>
internal readonly record struct GridRange(int FirstColumn, int LastColumn, int FirstRow, int LastRow)
{
    /// <summary>The rectangle with the bins around it.</summary>
    /// <param name="size">Number of bins along each edge of the grid.</param>
    public GridRange WithNeighbours(int size) => new(
        Math.Max(FirstColumn - 1, 0), Math.Min(LastColumn + 1, size - 1), Math.Max(FirstRow - 1, 0), Math.Min(LastRow + 1, size - 1));

    /// <summary>Number of bins.</summary>
    public int Count => (LastColumn - FirstColumn + 1) * (LastRow - FirstRow + 1);
}
