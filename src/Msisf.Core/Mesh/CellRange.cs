using System.Numerics;

namespace Msisf.Core.Mesh;

/// <summary>
/// A rectangle of mesh cells (<see cref="FacetMesh"/>); its vertices are the lines and samples from first to end, both included.
/// </summary>
/// <param name="FirstLine">Northernmost cell line; -1 is the northern fan.</param>
/// <param name="EndLine">One past the southernmost cell line.</param>
/// <param name="FirstSample">Westernmost cell.</param>
/// <param name="EndSample">One past the easternmost cell; may lie beyond the prime meridian.</param>
internal readonly record struct CellRange(int FirstLine, int EndLine, int FirstSample, int EndSample)
{
    /// <summary>Cells from north to south.</summary>
    public int Lines => EndLine - FirstLine;

    /// <summary>Cells from west to east.</summary>
    public int Samples => EndSample - FirstSample;

    /// <summary>
    /// Western and eastern part. The cut is at a power of two, so that what comes of a whole mesh by such cuts and has at most 2^k cells a
    /// side never lies across a multiple of 2^k.
    /// </summary>
    public (CellRange West, CellRange East) CutAlongMeridian()
    {
        int middle = FirstSample + CutOf(Samples);
        return (this with { EndSample = middle }, this with { FirstSample = middle });
    }

    /// <summary>Northern and southern part, cut as by <see cref="CutAlongMeridian"/>; lines count from the northern fan.</summary>
    public (CellRange North, CellRange South) CutAlongParallel()
    {
        int middle = FirstLine + CutOf(Lines);
        return (this with { EndLine = middle }, this with { FirstLine = middle });
    }

    /// <summary>The largest power of two below a number from 2 on.</summary>
    private static int CutOf(int cells) => 1 << BitOperations.Log2((uint)(cells - 1));
}
