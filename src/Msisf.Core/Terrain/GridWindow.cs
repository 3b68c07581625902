namespace Msisf.Core.Terrain;

/// <summary>
/// The part of a grid for which a model has samples. Of a map across the prime meridian they count on there, beyond those of the grid.
/// </summary>
/// <param name="FirstLine">Its top line.</param>
/// <param name="EndLine">The line below its last one.</param>
/// <param name="FirstSample">Its leftmost sample.</param>
/// <param name="EndSample">The sample to the right of its last one.</param>
public readonly record struct GridWindow(int FirstLine, int EndLine, int FirstSample, int EndSample)
{
    /// <summary>Number of lines.</summary>
    public int Lines => EndLine - FirstLine;

    /// <summary>Number of samples of a line.</summary>
    public int Samples => EndSample - FirstSample;

    /// <summary>
    /// The same part of the grid in which a sample stands for 2 x 2 of this one; it reaches as far as the samples that stand for any of
    /// this window's.
    /// </summary>
    public GridWindow Halved() => new(FirstLine >> 1, (EndLine + 1) >> 1, FirstSample >> 1, (EndSample + 1) >> 1);
}
