using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Eight neighbouring cells of a line in light space: tells which of their facets face away from the Sun, and the bounds of those cells.
/// </summary>
/// <param name="vertices">Vertices of a block, in light space, m; the strip is moved through them.</param>
internal sealed class CellStrip(BlockVertices vertices)
{
    public const int Cells = 8;

    private int _northWest;
    private Vector512<double> _isSouthWestAway;
    private Vector512<double> _isNorthEastAway;
    private LightBox _box;

    /// <summary>Index of the first cell's north-western vertex.</summary>
    public int NorthWest => _northWest;

    /// <summary>Mask of the cells whose facet (NW, SW, SE) faces away from the Sun.</summary>
    public uint SouthWestAway => (uint)_isSouthWestAway.ExtractMostSignificantBits();

    /// <summary>Mask of the cells whose facet (NW, SE, NE) faces away from the Sun.</summary>
    public uint NorthEastAway => (uint)_isNorthEastAway.ExtractMostSignificantBits();

    /// <summary>Bounds of the cells with a facet that faces away from the Sun, m.</summary>
    public ref readonly LightBox Box => ref _box;

    /// <summary>Minimum depth of the cells with a facet that faces away from the Sun, m.</summary>
    public double MinDepth { get; private set; }

    /// <summary>Moves the strip to other cells.</summary>
    /// <param name="line">Line of the cells in the block.</param>
    /// <param name="sample">Sample of the first cell in the block.</param>
    /// <param name="receivers">Bounds of the receivers; cells outside are left out.</param>
    /// <param name="slope">Radius of the Sun's disc over its distance; facets that face away from any part of it count.</param>
    /// <returns>Whether any facet faces away and is not left out.</returns>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be drawn with unoptimised vectors
    public bool TrySet(int line, int sample, in LightBox receivers, double slope)
    {
        _northWest = (line * BlockVertices.Stride) + sample;
        ref double us = ref BlockVertices.CornersFrom(vertices.X, _northWest);
        ref double vs = ref BlockVertices.CornersFrom(vertices.Y, _northWest);
        Vector512<double> uNorthWest = Vector512.LoadUnsafe(ref us);
        Vector512<double> vNorthWest = Vector512.LoadUnsafe(ref vs);
        Vector512<double> uNorthEast = Vector512.LoadUnsafe(ref us, 1);
        Vector512<double> vNorthEast = Vector512.LoadUnsafe(ref vs, 1);
        Vector512<double> uSouthWest = Vector512.LoadUnsafe(ref us, BlockVertices.Stride);
        Vector512<double> vSouthWest = Vector512.LoadUnsafe(ref vs, BlockVertices.Stride);
        Vector512<double> uSouthEast = Vector512.LoadUnsafe(ref us, BlockVertices.Stride + 1);
        Vector512<double> vSouthEast = Vector512.LoadUnsafe(ref vs, BlockVertices.Stride + 1);
        Vector512<double> southWest = CellEdges.Area(uNorthWest, vNorthWest, uSouthWest, vSouthWest, uSouthEast, vSouthEast);
        Vector512<double> northEast = CellEdges.Area(uNorthWest, vNorthWest, uSouthEast, vSouthEast, uNorthEast, vNorthEast);
        Vector512<double> minU = Min(uNorthWest, uNorthEast, uSouthWest, uSouthEast);
        Vector512<double> maxU = Max(uNorthWest, uNorthEast, uSouthWest, uSouthEast);
        Vector512<double> minV = Min(vNorthWest, vNorthEast, vSouthWest, vSouthEast);
        Vector512<double> maxV = Max(vNorthWest, vNorthEast, vSouthWest, vSouthEast);
        Vector512<double> isHere = Vector512.LessThanOrEqual(Vector512.Create(receivers.MinU), maxU)
            & Vector512.GreaterThanOrEqual(Vector512.Create(receivers.MaxU), minU)
            & Vector512.LessThanOrEqual(Vector512.Create(receivers.MinV), maxV)
            & Vector512.GreaterThanOrEqual(Vector512.Create(receivers.MaxV), minV)
            & Vector512.LessThan(
                Lanes.Numbers, Vector512.Create((double)(vertices.Samples - 1 - sample)));
        if (vertices.IsOfSeams)
        {
            isHere &= Lanes.Mask(vertices.CellsOfLine(line) >> sample);
        }

        if (slope > 0.0)
        {
            (southWest, northEast) = MaxAreas(southWest, northEast, slope);
        }

        _isSouthWestAway = isHere & Vector512.GreaterThan(southWest, Vector512<double>.Zero);
        _isNorthEastAway = isHere & Vector512.GreaterThan(northEast, Vector512<double>.Zero);
        Vector512<double> isAway = _isSouthWestAway | _isNorthEastAway;
        if (isAway == Vector512<double>.Zero)
        {
            return false;
        }

        ref double ws = ref BlockVertices.CornersFrom(vertices.Z, _northWest);
        MinDepth = Min(isAway, Min(
            Vector512.LoadUnsafe(ref ws),
            Vector512.LoadUnsafe(ref ws, 1),
            Vector512.LoadUnsafe(ref ws, BlockVertices.Stride),
            Vector512.LoadUnsafe(ref ws, BlockVertices.Stride + 1)));
        _box = new LightBox(Min(isAway, minU), -Min(isAway, -maxU), Min(isAway, minV), -Min(isAway, -maxV));
        return true;
    }

    /// <summary>The south-western facet of a cell of the strip.</summary>
    public LightFacet SouthWestFacet(int cell) => Facet(
        _northWest + cell, _northWest + cell + BlockVertices.Stride, _northWest + cell + BlockVertices.Stride + 1);

    /// <summary>The north-eastern facet of a cell of the strip.</summary>
    public LightFacet NorthEastFacet(int cell) =>
        Facet(_northWest + cell, _northWest + cell + BlockVertices.Stride + 1, _northWest + cell + 1);

    /// <summary>A slab along the strip that holds the cells of <see cref="Box"/>; narrower than the box if the strip is oblique.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be drawn with unoptimised vectors
    public LightSlab FindSlab()
    {
        ref double us = ref BlockVertices.CornersFrom(vertices.X, _northWest);
        ref double vs = ref BlockVertices.CornersFrom(vertices.Y, _northWest);
        Vector512<double> isAway = _isSouthWestAway | _isNorthEastAway;
        uint away = (uint)isAway.ExtractMostSignificantBits();
        int first = BitOperations.TrailingZeroCount(away);
        int end = BitOperations.Log2(away) + 1;
        double u = Unsafe.Add(ref us, first);
        double v = Unsafe.Add(ref vs, first);
        double southU = Unsafe.Add(ref us, first + BlockVertices.Stride) - u;
        double southV = Unsafe.Add(ref vs, first + BlockVertices.Stride) - v;
        double eastU = Unsafe.Add(ref us, end) - u;
        double eastV = Unsafe.Add(ref vs, end) - v;
        bool isEastLonger = (eastU * eastU) + (eastV * eastV) > (southU * southU) + (southV * southV);
        double acrossU = isEastLonger ? -eastV : -southV;
        double acrossV = isEastLonger ? eastU : southU;
        Vector512<double> northWest = Across(ref us, ref vs, 0, acrossU, acrossV);
        Vector512<double> northEast = Across(ref us, ref vs, 1, acrossU, acrossV);
        Vector512<double> southWest = Across(ref us, ref vs, BlockVertices.Stride, acrossU, acrossV);
        Vector512<double> southEast = Across(ref us, ref vs, BlockVertices.Stride + 1, acrossU, acrossV);
        double margin = Tolerances.LightPoint * (Math.Abs(acrossU) + Math.Abs(acrossV));
        return new LightSlab(
            acrossU,
            acrossV,
            Min(isAway, Min(northWest, northEast, southWest, southEast)) - margin,
            margin - Min(isAway, -Max(northWest, northEast, southWest, southEast)));
    }

    /// <summary>Mask of the cells whose bounds allow that they lie between a point and a part of the Sun's disc.</summary>
    /// <param name="point">The point in light space, m.</param>
    /// <param name="slope">Radius of the disc over its distance.</param>
    /// <param name="minA">Minimum, over the part of the disc, of the u by which a ray to it moves with each metre towards the Sun.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be drawn with unoptimised vectors
    public uint CellsNear(Vector3D point, double slope, double minA)
    {
        ref double us = ref BlockVertices.CornersFrom(vertices.X, _northWest);
        ref double vs = ref BlockVertices.CornersFrom(vertices.Y, _northWest);
        ref double ws = ref BlockVertices.CornersFrom(vertices.Z, _northWest);
        (Vector512<double> minU, Vector512<double> maxU) = Bounds(ref us);
        (Vector512<double> minV, Vector512<double> maxV) = Bounds(ref vs);
        (Vector512<double> minW, Vector512<double> maxW) = Bounds(ref ws);
        Vector512<double> u = Vector512.Create(point.X);
        Vector512<double> v = Vector512.Create(point.Y);
        Vector512<double> reach = (Vector512.Create(slope) * (Vector512.Create(point.Z) - minW)) + Vector512.Create(Tolerances.LightPoint);
        Vector512<double> lowest = Vector512.Create(minA) * (Vector512.Create(point.Z) - (minA < 0.0 ? minW : maxW));
        return (uint)((_isSouthWestAway | _isNorthEastAway)
            & Vector512.LessThan(minW, Vector512.Create(point.Z))
            & Vector512.LessThanOrEqual(minU - reach, u)
            & Vector512.GreaterThanOrEqual(maxU + Vector512.Create(Tolerances.LightPoint), u + lowest)
            & Vector512.LessThanOrEqual(minV - reach, v)
            & Vector512.GreaterThanOrEqual(maxV + reach, v)).ExtractMostSignificantBits();
    }

    /// <summary>Whether a facet that faces away from the Sun lies between a point of light space, m, and the Sun.</summary>
    /// <remarks>
    /// Each point of an edge is inside at least one of the two facets that share it (<see cref="CellEdges"/>). A facet's depth at the point
    /// is the mean of its corners' depths, weighted by the edge functions. Only the sign of its difference from the point's depth is
    /// needed, so no division is made. <see cref="FacetCaster"/> computes the same sums for one facet and eight points.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be drawn with unoptimised vectors
    public bool IsInFrontOf(double u, double v, double w)
    {
        ref double us = ref BlockVertices.CornersFrom(vertices.X, _northWest);
        ref double vs = ref BlockVertices.CornersFrom(vertices.Y, _northWest);
        Vector512<double> pu = Vector512.Create(u);
        Vector512<double> pv = Vector512.Create(v);
        Vector512<double> uNorthWest = Vector512.LoadUnsafe(ref us) - pu;
        Vector512<double> vNorthWest = Vector512.LoadUnsafe(ref vs) - pv;
        Vector512<double> uNorthEast = Vector512.LoadUnsafe(ref us, 1) - pu;
        Vector512<double> vNorthEast = Vector512.LoadUnsafe(ref vs, 1) - pv;
        Vector512<double> uSouthWest = Vector512.LoadUnsafe(ref us, BlockVertices.Stride) - pu;
        Vector512<double> vSouthWest = Vector512.LoadUnsafe(ref vs, BlockVertices.Stride) - pv;
        Vector512<double> uSouthEast = Vector512.LoadUnsafe(ref us, BlockVertices.Stride + 1) - pu;
        Vector512<double> vSouthEast = Vector512.LoadUnsafe(ref vs, BlockVertices.Stride + 1) - pv;
        CellEdges edges = new(uNorthWest, vNorthWest, uNorthEast, vNorthEast, uSouthWest, vSouthWest, uSouthEast, vSouthEast);
        Vector512<double> inSouthWest = _isSouthWestAway & Vector512.GreaterThanOrEqual(edges.MinOfSouthWest, Vector512<double>.Zero);
        Vector512<double> inNorthEast = _isNorthEastAway & Vector512.GreaterThanOrEqual(edges.MinOfNorthEast, Vector512<double>.Zero);
        if ((inSouthWest | inNorthEast) == Vector512<double>.Zero)
        {
            return false;
        }

        ref double ws = ref BlockVertices.CornersFrom(vertices.Z, _northWest);
        Vector512<double> pw = Vector512.Create(w);
        Vector512<double> wNorthWest = Vector512.LoadUnsafe(ref ws) - pw;
        Vector512<double> wNorthEast = Vector512.LoadUnsafe(ref ws, 1) - pw;
        Vector512<double> wSouthWest = Vector512.LoadUnsafe(ref ws, BlockVertices.Stride) - pw;
        Vector512<double> wSouthEast = Vector512.LoadUnsafe(ref ws, BlockVertices.Stride + 1) - pw;
        Vector512<double> southWest = (edges.South * wNorthWest) + (-edges.Diagonal * wSouthWest) + (edges.West * wSouthEast);
        Vector512<double> northEast = (edges.East * wNorthWest) + (edges.North * wSouthEast) + (edges.Diagonal * wNorthEast);
        return ((inSouthWest & Vector512.LessThan(southWest, Vector512<double>.Zero))
            | (inNorthEast & Vector512.LessThan(northEast, Vector512<double>.Zero))) != Vector512<double>.Zero;
    }

    /// <summary>
    /// The maximum, over the Sun's disc, of each facet's signed area seen from a point of the disc. The ray to a point of the disc moves
    /// across by a constant times the depth, so the area is linear in the two components of that constant.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be drawn with unoptimised vectors
    private (Vector512<double> SouthWest, Vector512<double> NorthEast) MaxAreas(
        Vector512<double> southWest, Vector512<double> northEast, double slope)
    {
        ref double us = ref BlockVertices.CornersFrom(vertices.X, _northWest);
        ref double vs = ref BlockVertices.CornersFrom(vertices.Y, _northWest);
        ref double ws = ref BlockVertices.CornersFrom(vertices.Z, _northWest);
        Vector512<double> u = Vector512.LoadUnsafe(ref us);
        Vector512<double> v = Vector512.LoadUnsafe(ref vs);
        Vector512<double> w = Vector512.LoadUnsafe(ref ws);
        Vector512<double> uDiagonal = Vector512.LoadUnsafe(ref us, BlockVertices.Stride + 1) - u;
        Vector512<double> vDiagonal = Vector512.LoadUnsafe(ref vs, BlockVertices.Stride + 1) - v;
        Vector512<double> wDiagonal = Vector512.LoadUnsafe(ref ws, BlockVertices.Stride + 1) - w;
        Vector512<double> uSouth = Vector512.LoadUnsafe(ref us, BlockVertices.Stride) - u;
        Vector512<double> vSouth = Vector512.LoadUnsafe(ref vs, BlockVertices.Stride) - v;
        Vector512<double> wSouth = Vector512.LoadUnsafe(ref ws, BlockVertices.Stride) - w;
        Vector512<double> uEast = Vector512.LoadUnsafe(ref us, 1) - u;
        Vector512<double> vEast = Vector512.LoadUnsafe(ref vs, 1) - v;
        Vector512<double> wEast = Vector512.LoadUnsafe(ref ws, 1) - w;
        return (
            southWest + Gain((wSouth * vDiagonal) - (vSouth * wDiagonal), (uSouth * wDiagonal) - (wSouth * uDiagonal), slope),
            northEast + Gain((wDiagonal * vEast) - (vDiagonal * wEast), (uDiagonal * wEast) - (wDiagonal * uEast), slope));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Gain(Vector512<double> alongU, Vector512<double> alongV, double slope) =>
        Vector512.Create(slope) * Vector512.Sqrt((alongU * alongU) + (alongV * alongV));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (Vector512<double> Min, Vector512<double> Max) Bounds(ref double corners)
    {
        Vector512<double> northWest = Vector512.LoadUnsafe(ref corners);
        Vector512<double> northEast = Vector512.LoadUnsafe(ref corners, 1);
        Vector512<double> southWest = Vector512.LoadUnsafe(ref corners, BlockVertices.Stride);
        Vector512<double> southEast = Vector512.LoadUnsafe(ref corners, BlockVertices.Stride + 1);
        return (Min(northWest, northEast, southWest, southEast), Max(northWest, northEast, southWest, southEast));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Across(ref double us, ref double vs, nuint corner, double acrossU, double acrossV) =>
        (
            Vector512.LoadUnsafe(
                ref us, corner) * Vector512.Create(acrossU)) + (Vector512.LoadUnsafe(ref vs, corner) * Vector512.Create(acrossV));

    private LightFacet Facet(int a, int b, int c) => new(
        vertices.X[a], vertices.Y[a], vertices.Z[a], vertices.X[b], vertices.Y[b], vertices.Z[b], vertices.X[c], vertices.Y[c],
        vertices.Z[c]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Min(Vector512<double> a, Vector512<double> b, Vector512<double> c, Vector512<double> d) =>
        Vector512.MinNative(Vector512.MinNative(a, b), Vector512.MinNative(c, d));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Max(Vector512<double> a, Vector512<double> b, Vector512<double> c, Vector512<double> d) =>
        Vector512.MaxNative(Vector512.MaxNative(a, b), Vector512.MaxNative(c, d));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Min(Vector512<double> isMeant, Vector512<double> values) =>
        Lanes.Min(Vector512.ConditionalSelect(isMeant, values, Vector512.Create(double.PositiveInfinity)));
}

/// <summary>Points of light space with <c>Min &lt;= u AcrossU + v AcrossV &lt;= Max</c>; <c>default</c> contains all points.</summary>
/// <param name="AcrossU">Component along u of the slab's normal, which can have any length.</param>
/// <param name="AcrossV">Component along v of the slab's normal.</param>
/// <param name="Min">Minimum, m times the length of the normal.</param>
/// <param name="Max">Maximum, m times the length of the normal.</param>
internal readonly record struct LightSlab(double AcrossU, double AcrossV, double Min, double Max)
{
    /// <summary>Mask of the points, of eight, that are in the slab.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint Holds(Vector512<double> u, Vector512<double> v)
    {
        Vector512<double> across = (u * Vector512.Create(AcrossU)) + (v * Vector512.Create(AcrossV));
        return (uint)(Vector512.GreaterThanOrEqual(across, Vector512.Create(Min))
            & Vector512.LessThanOrEqual(across, Vector512.Create(Max))).ExtractMostSignificantBits();
    }
}
