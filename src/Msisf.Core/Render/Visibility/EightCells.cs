using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Mesh;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// The projected corners of eight neighbouring cells of a line, read again from the block's arrays wherever they are needed: there are not
/// registers for all.
/// </summary>
internal readonly ref struct EightCells
{
    private readonly ref double _x;
    private readonly ref double _y;
    private readonly ref double _inverseDepth;

    /// <param name="block">Their block.</param>
    /// <param name="index">North-western vertex of the westernmost cell.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public EightCells(ProjectedBlock block, int index)
    {
        _x = ref BlockVertices.CornersFrom(block.X, index);
        _y = ref BlockVertices.CornersFrom(block.Y, index);
        _inverseDepth = ref BlockVertices.CornersFrom(block.InverseDepth, index);
    }

    /// <summary>Minimum column of each cell.</summary>
    public Vector512<double> Left => Min(ref _x);

    /// <summary>Maximum column.</summary>
    public Vector512<double> Right => Max(ref _x);

    /// <summary>Minimum row.</summary>
    public Vector512<double> Top => Min(ref _y);

    /// <summary>Maximum row.</summary>
    public Vector512<double> Bottom => Max(ref _y);

    /// <summary>px2: twice the area of the south-western facets, below 0 where they face the camera.</summary>
    public Vector512<double> SouthWestArea =>
        CellEdges.Area(
            X(0), Y(0), X(FacetCorners.SouthWest), Y(FacetCorners.SouthWest), X(FacetCorners.SouthEast), Y(FacetCorners.SouthEast));

    /// <summary>px2: the same of the north-eastern facets.</summary>
    public Vector512<double> NorthEastArea =>
        CellEdges.Area(
            X(0), Y(0), X(FacetCorners.SouthEast), Y(FacetCorners.SouthEast), X(FacetCorners.NorthEast), Y(FacetCorners.NorthEast));

    /// <summary>Column of a corner of each cell.</summary>
    /// <param name="corner">Of <see cref="FacetCorners"/>; 0 is the north-western one.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<double> X(int corner) => Vector512.LoadUnsafe(ref _x, (nuint)corner);

    /// <summary>Row of a corner.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<double> Y(int corner) => Vector512.LoadUnsafe(ref _y, (nuint)corner);

    /// <summary>1/m: one over the depth of a corner.</summary>
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
