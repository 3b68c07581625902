namespace Msisf.Core.Render.Shadows;

/// <summary>A rectangle of bins of a grid; the last column and the last row are included.</summary>
internal readonly record struct GridRange(int FirstColumn, int LastColumn, int FirstRow, int LastRow)
{
    /// <summary>Number of bins.</summary>
    public int Count => (LastColumn - FirstColumn + 1) * (LastRow - FirstRow + 1);
}
