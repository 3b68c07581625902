using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// The projected corners of eight neighbouring cells of a line. They are read again from the block's arrays at each use, because there are
/// not enough vector registers to hold them all.
/// </summary>
internal readonly ref struct EightCells
{
    private readonly ref double _x;
    private readonly ref double _y;
    private readonly ref double _inverseDepth;

    /// <param name="index">Index of the north-western vertex of the westernmost cell.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public EightCells(ProjectedBlock block, int index)
    {
        _x = ref BlockVertices.CornersFrom(block.X, index);
        _y = ref BlockVertices.CornersFrom(block.Y, index);
        _inverseDepth = ref BlockVertices.CornersFrom(block.InverseDepth, index);
    }

    /// <summary>Minimum column of each cell.</summary>
    public Vector512<double> Left => Min(ref _x);

    /// <summary>Maximum column of each cell.</summary>
    public Vector512<double> Right => Max(ref _x);

    /// <summary>Minimum row of each cell.</summary>
    public Vector512<double> Top => Min(ref _y);

    /// <summary>Maximum row of each cell.</summary>
    public Vector512<double> Bottom => Max(ref _y);

    /// <summary>px2: twice the signed area of the south-western facets; negative where they face the camera.</summary>
    public Vector512<double> SouthWestArea =>
        CellEdges.Area(
            X(0), Y(0), X(FacetCorners.SouthWest), Y(FacetCorners.SouthWest), X(FacetCorners.SouthEast), Y(FacetCorners.SouthEast));

    /// <summary>px2: twice the signed area of the north-eastern facets; negative where they face the camera.</summary>
    public Vector512<double> NorthEastArea =>
        CellEdges.Area(
            X(0), Y(0), X(FacetCorners.SouthEast), Y(FacetCorners.SouthEast), X(FacetCorners.NorthEast), Y(FacetCorners.NorthEast));

    /// <summary>Column of a corner of each cell.</summary>
    /// <param name="corner">An offset of <see cref="FacetCorners"/>; 0 is the north-western corner.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<double> X(int corner) => Vector512.LoadUnsafe(ref _x, (nuint)corner);

    /// <summary>Row of a corner of each cell.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<double> Y(int corner) => Vector512.LoadUnsafe(ref _y, (nuint)corner);

    /// <summary>1/m: inverse depth of a corner of each cell.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<double> InverseDepth(int corner) => Vector512.LoadUnsafe(ref _inverseDepth, (nuint)corner);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Min(ref double of) => Vector512.MinNative(
        Vector512.MinNative(Vector512.LoadUnsafe(ref of), Vector512.LoadUnsafe(ref of, FacetCorners.NorthEast)),
        Vector512.MinNative(Vector512.LoadUnsafe(ref of, FacetCorners.SouthWest), Vector512.LoadUnsafe(ref of, FacetCorners.SouthEast)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Max(ref double of) => Vector512.MaxNative(
        Vector512.MaxNative(Vector512.LoadUnsafe(ref of), Vector512.LoadUnsafe(ref of, FacetCorners.NorthEast)),
        Vector512.MaxNative(Vector512.LoadUnsafe(ref of, FacetCorners.SouthWest), Vector512.LoadUnsafe(ref of, FacetCorners.SouthEast)));
}
