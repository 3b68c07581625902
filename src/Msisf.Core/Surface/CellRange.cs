using System.Numerics;

namespace Msisf.Core.Surface;

/// <summary>
/// A rectangle of mesh cells (<see cref="FacetMesh"/>); its vertices are the lines and samples from first to end, both included.
/// </summary>
/// <param name="FirstLine">Northernmost cell line; -1 is the northern fan.</param>
/// <param name="EndLine">One past the southernmost cell line.</param>
/// <param name="FirstSample">Westernmost cell.</param>
/// <param name="EndSample">One past the easternmost cell; may lie beyond the prime meridian.</param>
internal readonly record struct CellRange(int FirstLine, int EndLine, int FirstSample, int EndSample)
{
    /// <summary>Number of cells from north to south.</summary>
    public int Lines => EndLine - FirstLine;

    /// <summary>Number of cells from west to east.</summary>
    public int Samples => EndSample - FirstSample;

    /// <summary>
    /// Splits the range into a western and an eastern part, of which the western one is a power of two wide. Repeated cuts of a whole mesh
    /// therefore give parts that never cross a multiple of 2^k once they have at most 2^k cells per side.
    /// </summary>
    public (CellRange West, CellRange East) CutAlongMeridian()
    {
        int middle = FirstSample + CutOf(Samples);
        return (this with { EndSample = middle }, this with { FirstSample = middle });
    }

    /// <summary>
    /// Splits the range into a northern and a southern part, as <see cref="CutAlongMeridian"/> does; lines count from the northern fan.
    /// </summary>
    public (CellRange North, CellRange South) CutAlongParallel()
    {
        int middle = FirstLine + CutOf(Lines);
        return (this with { EndLine = middle }, this with { FirstLine = middle });
    }

    /// <summary>The largest power of two below a number that is at least 2.</summary>
    private static int CutOf(int cells) => 1 << BitOperations.Log2((uint)(cells - 1));
}
