namespace Msisf.Core.Terrain;

/// <summary>The part of a grid for which a model has samples.</summary>
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
}
