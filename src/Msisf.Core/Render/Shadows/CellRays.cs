using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Tells through which facets of eight neighbouring cells the rays from a point to the points of the Sun's disc pass. Each lane is a cell;
/// (a, b) are those of <see cref="DiscRays"/>.
/// </summary>
/// <remarks>
/// The edge functions of <see cref="CellStrip.IsInFrontOf"/> are linear in (a, b). The sign of the depth sum does not depend on (a, b),
/// because it only tells on which side of the facet's plane the point is.
/// </remarks>
internal readonly struct CellRays
{
    private readonly CellEdges _value;
    private readonly CellEdges _perA;
    private readonly CellEdges _perB;

    /// <summary>Computes the edge functions.</summary>
    /// <param name="vertices">Vertices of a block in light space, m.</param>
    /// <param name="northWest">Index of the first cell's north-western vertex.</param>
    /// <param name="point">The point in light space, m.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public CellRays(BlockVertices vertices, int northWest, Vector3D point)
    {
        ref double us = ref BlockVertices.CornersFrom(vertices.X, northWest);
        ref double vs = ref BlockVertices.CornersFrom(vertices.Y, northWest);
        ref double ws = ref BlockVertices.CornersFrom(vertices.Z, northWest);
        Vector512<double> uNorthWest = From(ref us, 0, point.X);
        Vector512<double> vNorthWest = From(ref vs, 0, point.Y);
        Vector512<double> wNorthWest = From(ref ws, 0, point.Z);
        Vector512<double> uNorthEast = From(ref us, 1, point.X);
        Vector512<double> vNorthEast = From(ref vs, 1, point.Y);
        Vector512<double> wNorthEast = From(ref ws, 1, point.Z);
        Vector512<double> uSouthWest = From(ref us, BlockVertices.Stride, point.X);
        Vector512<double> vSouthWest = From(ref vs, BlockVertices.Stride, point.Y);
        Vector512<double> wSouthWest = From(ref ws, BlockVertices.Stride, point.Z);
        Vector512<double> uSouthEast = From(ref us, BlockVertices.Stride + 1, point.X);
        Vector512<double> vSouthEast = From(ref vs, BlockVertices.Stride + 1, point.Y);
        Vector512<double> wSouthEast = From(ref ws, BlockVertices.Stride + 1, point.Z);
        _value = new CellEdges(uNorthWest, vNorthWest, uNorthEast, vNorthEast, uSouthWest, vSouthWest, uSouthEast, vSouthEast);
        _perA = new CellEdges(wNorthWest, vNorthWest, wNorthEast, vNorthEast, wSouthWest, vSouthWest, wSouthEast, vSouthEast);
        _perB = new CellEdges(uNorthWest, wNorthWest, uNorthEast, wNorthEast, uSouthWest, wSouthWest, uSouthEast, wSouthEast);
        SouthWestInFront = (uint)Vector512.LessThan(
            (_value.South * wNorthWest) + (-_value.Diagonal * wSouthWest) + (_value.West * wSouthEast),
            Vector512<double>.Zero).ExtractMostSignificantBits();
        NorthEastInFront = (uint)Vector512.LessThan(
            (_value.East * wNorthWest) + (_value.North * wSouthEast) + (_value.Diagonal * wNorthEast),
            Vector512<double>.Zero).ExtractMostSignificantBits();
    }

    /// <summary>Mask of the cells whose facet (NW, SW, SE) has the point behind its plane.</summary>
    public uint SouthWestInFront { get; }

    /// <summary>Mask of the cells whose facet (NW, SE, NE) has the point behind its plane.</summary>
    public uint NorthEastInFront { get; }

    /// <summary>Whether a ray passes through a facet.</summary>
    /// <param name="a">Across u with each metre towards the Sun.</param>
    /// <param name="b">Across v with each metre towards the Sun.</param>
    /// <param name="southWest">Mask of the cells whose facet (NW, SW, SE) counts.</param>
    /// <param name="northEast">Mask of the cells whose facet (NW, SE, NE) counts.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool AnyHolds(double a, double b, uint southWest, uint northEast)
    {
        Vector512<double> diagonal = At(_value.Diagonal, _perA.Diagonal, _perB.Diagonal, a, b);
        return AnyHolds(
            At(_value.West, _perA.West, _perB.West, a, b),
            At(_value.South, _perA.South, _perB.South, a, b),
            -diagonal,
            southWest)
            || AnyHolds(
                At(_value.East, _perA.East, _perB.East, a, b),
                At(_value.North, _perA.North, _perB.North, a, b),
                diagonal,
                northEast);
    }

    /// <summary>Whether a ray may pass through a facet, of all rays within a reach around one.</summary>
    /// <param name="a">Across u with each metre towards the Sun.</param>
    /// <param name="b">Across v with each metre towards the Sun.</param>
    /// <param name="reachA">Reach around <paramref name="a"/>.</param>
    /// <param name="reachB">Reach around <paramref name="b"/>.</param>
    /// <param name="southWest">Mask of the cells whose facet (NW, SW, SE) counts.</param>
    /// <param name="northEast">Mask of the cells whose facet (NW, SE, NE) counts.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool MayHold(double a, double b, double reachA, double reachB, uint southWest, uint northEast)
    {
        Vector512<double> diagonal = At(_value.Diagonal, _perA.Diagonal, _perB.Diagonal, a, b);
        Vector512<double> reach = Reach(_perA.Diagonal, _perB.Diagonal, reachA, reachB);
        return AnyHolds(
            At(_value.West, _perA.West, _perB.West, a, b) + Reach(_perA.West, _perB.West, reachA, reachB),
            At(_value.South, _perA.South, _perB.South, a, b) + Reach(_perA.South, _perB.South, reachA, reachB),
            reach - diagonal,
            southWest)
            || AnyHolds(
                At(_value.East, _perA.East, _perB.East, a, b) + Reach(_perA.East, _perB.East, reachA, reachB),
                At(_value.North, _perA.North, _perB.North, a, b) + Reach(_perA.North, _perB.North, reachA, reachB),
                reach + diagonal,
                northEast);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> From(ref double corners, nuint first, double point) =>
        Vector512.LoadUnsafe(ref corners, first) - Vector512.Create(point);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> At(Vector512<double> value, Vector512<double> perA, Vector512<double> perB, double a, double b) =>
        value + ((perA * Vector512.Create(a)) + (perB * Vector512.Create(b)));

    /// <summary>Maximum change of an edge function within a reach.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Reach(Vector512<double> perA, Vector512<double> perB, double reachA, double reachB) =>
        (Vector512.Abs(perA) * Vector512.Create(reachA)) + (Vector512.Abs(perB) * Vector512.Create(reachB));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool AnyHolds(Vector512<double> first, Vector512<double> second, Vector512<double> third, uint cells) =>
        (cells & (uint)Vector512.GreaterThanOrEqual(
            Vector512.MinNative(first, Vector512.MinNative(second, third)), Vector512<double>.Zero).ExtractMostSignificantBits()) != 0;
}
