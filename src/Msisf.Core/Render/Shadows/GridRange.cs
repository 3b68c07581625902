namespace Msisf.Core.Render.Shadows;

/// <summary>Neighbouring bins of a grid, the last ones included.</summary>
internal readonly record struct GridRange(int FirstColumn, int LastColumn, int FirstRow, int LastRow)
{
    /// <summary>How many.</summary>
    public int Count => (LastColumn - FirstColumn + 1) * (LastRow - FirstRow + 1);
}
