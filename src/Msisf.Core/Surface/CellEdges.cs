using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Surface;

/// <summary>
/// Edge functions of cells in a plane: for each edge from a to b and a point p the cross product (a - p) x (b - p). One object holds eight
/// cells and eight points, one cell and eight points, or eight cells and one point; <see cref="FourCellEdges"/> half as many.
/// </summary>
/// <remarks>
/// Nothing is fused, so an edge that is run through the other way, as in the neighbouring cell, has exactly the opposite value: no point
/// falls between two facets if zero counts as inside. The south-western facet (NW, SW, SE) lies to one side of <see cref="West"/>,
/// <see cref="South"/> and minus <see cref="Diagonal"/>, the north-eastern facet (NW, SE, NE) of <see cref="East"/>, <see cref="North"/>
/// and <see cref="Diagonal"/>. A facet that is seen from outside has products above 0 for a point within it if the plane's y axis points
/// up, and below 0 if it points down. The products are also the weights of the corners opposite to the edges.
/// </remarks>
internal readonly struct CellEdges
{
    /// <summary>Computes the products from the positions of the corners relative to the points.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public CellEdges(
        Vector512<double> xNorthWest,
        Vector512<double> yNorthWest,
        Vector512<double> xNorthEast,
        Vector512<double> yNorthEast,
        Vector512<double> xSouthWest,
        Vector512<double> ySouthWest,
        Vector512<double> xSouthEast,
        Vector512<double> ySouthEast)
    {
        Diagonal = Cross(xNorthWest, yNorthWest, xSouthEast, ySouthEast);
        West = Cross(xNorthWest, yNorthWest, xSouthWest, ySouthWest);
        South = Cross(xSouthWest, ySouthWest, xSouthEast, ySouthEast);
        East = Cross(xSouthEast, ySouthEast, xNorthEast, yNorthEast);
        North = Cross(xNorthEast, yNorthEast, xNorthWest, yNorthWest);
    }

    /// <summary>Product of the edge from north-west to south-east.</summary>
    public Vector512<double> Diagonal { get; }

    /// <summary>Product of the edge from north-west to south-west.</summary>
    public Vector512<double> West { get; }

    /// <summary>Product of the edge from south-west to south-east.</summary>
    public Vector512<double> South { get; }

    /// <summary>Product of the edge from south-east to north-east.</summary>
    public Vector512<double> East { get; }

    /// <summary>Product of the edge from north-east to north-west.</summary>
    public Vector512<double> North { get; }

    /// <summary>Maximum of the south-western facet's products; at most 0 for a point in it, if the y axis points down.</summary>
    public Vector512<double> MaxOfSouthWest => Vector512.MaxNative(Vector512.MaxNative(West, South), -Diagonal);

    /// <summary>Maximum of the north-eastern facet's products; at most 0 for a point in it, if the y axis points down.</summary>
    public Vector512<double> MaxOfNorthEast => Vector512.MaxNative(Vector512.MaxNative(East, North), Diagonal);

    /// <summary>Minimum of the south-western facet's products; at least 0 for a point in it, if the y axis points up.</summary>
    public Vector512<double> MinOfSouthWest => Vector512.MinNative(Vector512.MinNative(West, South), -Diagonal);

    /// <summary>Minimum of the north-eastern facet's products; at least 0 for a point in it, if the y axis points up.</summary>
    public Vector512<double> MinOfNorthEast => Vector512.MinNative(Vector512.MinNative(East, North), Diagonal);

    /// <summary>The cross product of two vectors, without FMA.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<double> Cross(Vector512<double> xa, Vector512<double> ya, Vector512<double> xb, Vector512<double> yb) =>
        (xa * yb) - (xb * ya);

    /// <summary>Twice the signed area of facets with the corners a, b, c; a is the north-western corner of the cell.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<double> Area(
        Vector512<double> xa, Vector512<double> ya, Vector512<double> xb, Vector512<double> yb, Vector512<double> xc,
        Vector512<double> yc) =>
        Cross(xb - xa, yb - ya, xc - xa, yc - ya);
}

/// <summary>The <see cref="CellEdges"/> of one cell and four points, with the same bits.</summary>
/// <remarks>
/// Five products of eight numbers do not stay in the registers of a processor without AVX-512, those of four do. Nine samples of a pixel
/// are three vectors of four, but two of eight.
/// </remarks>
internal readonly struct FourCellEdges
{
    /// <summary>Computes the products from the positions of the corners relative to the points.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public FourCellEdges(
        Vector256<double> xNorthWest,
        Vector256<double> yNorthWest,
        Vector256<double> xNorthEast,
        Vector256<double> yNorthEast,
        Vector256<double> xSouthWest,
        Vector256<double> ySouthWest,
        Vector256<double> xSouthEast,
        Vector256<double> ySouthEast)
    {
        Diagonal = Cross(xNorthWest, yNorthWest, xSouthEast, ySouthEast);
        West = Cross(xNorthWest, yNorthWest, xSouthWest, ySouthWest);
        South = Cross(xSouthWest, ySouthWest, xSouthEast, ySouthEast);
        East = Cross(xSouthEast, ySouthEast, xNorthEast, yNorthEast);
        North = Cross(xNorthEast, yNorthEast, xNorthWest, yNorthWest);
    }

    /// <inheritdoc cref="CellEdges.Diagonal"/>
    public Vector256<double> Diagonal { get; }

    /// <inheritdoc cref="CellEdges.West"/>
    public Vector256<double> West { get; }

    /// <inheritdoc cref="CellEdges.South"/>
    public Vector256<double> South { get; }

    /// <inheritdoc cref="CellEdges.East"/>
    public Vector256<double> East { get; }

    /// <inheritdoc cref="CellEdges.North"/>
    public Vector256<double> North { get; }

    /// <inheritdoc cref="CellEdges.MaxOfSouthWest"/>
    public Vector256<double> MaxOfSouthWest => Vector256.MaxNative(Vector256.MaxNative(West, South), -Diagonal);

    /// <inheritdoc cref="CellEdges.MaxOfNorthEast"/>
    public Vector256<double> MaxOfNorthEast => Vector256.MaxNative(Vector256.MaxNative(East, North), Diagonal);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Cross(Vector256<double> xa, Vector256<double> ya, Vector256<double> xb, Vector256<double> yb) =>
        (xa * yb) - (xb * ya);
}
