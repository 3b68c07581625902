using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Shadows;

/// <summary>
/// Points of light space from which terrain hides the Sun's disc up to a line across it, as far as the sections of the terrain in some
/// planes tell. It finds most points deep in a shadow at once, which the facets in front of them would have to hide point by point of the
/// disc.
/// </summary>
/// <remarks>
/// <para>
/// The segment from a point of a plane below the lowest terrain of its column straight down (towards u = 0) meets no facet before it
/// reaches the sphere that is solid everywhere, so the point is inside the Moon, and a ray to the Sun that passes it is blocked: it enters
/// the Moon through a facet that faces away, between its start and the point or, from a point inside, later.
/// </para>
/// <para>
/// If all rays from a point to that part of the disc cross a plane at such points, the point is in the zone. The points of a plane that are
/// in the zone, in whole columns, are found from plane to plane: heights sink by as much as the highest ray rises, and lose a column on
/// either side each time that a ray to the disc's rim has moved across by a column's width. As the disc's part is taken as a rectangle, u
/// and v are treated one by one.
/// </para>
/// </remarks>
internal sealed class DarkZone
{
    private readonly SectionGrid _grid;
    private readonly Memory<float> _heights;
    private readonly double _slope;
    private readonly double _top;
    private readonly double _minU;

    /// <summary>Computes the zone.</summary>
    /// <param name="grid">The planes and columns.</param>
    /// <param name="lowest">Lowest height of all terrain in each plane and column, m.</param>
    /// <param name="solidRadius">Radius of the sphere that is solid everywhere, m.</param>
    /// <param name="slope">Radius of the Sun's disc over its distance.</param>
    /// <param name="top">How far along u the disc is hidden, over its distance: up to the slope, which is the whole disc.</param>
    /// <param name="heights">Room for the zone's heights, of the same length.</param>
    public DarkZone(
        SectionGrid grid, ReadOnlyMemory<float> lowest, double solidRadius, double slope, double top, Memory<float> heights)
    {
        _grid = grid;
        _heights = heights;
        _slope = slope;
        _top = top;

        // The rays from there stay above u = 0 in all planes.
        _minU = slope * (grid.DepthOf(grid.Planes) - grid.MinDepth);
        Sweep(lowest.Span, solidRadius);
    }

    /// <summary>Tells which of eight points, m, are in the zone.</summary>
    public Vector512<double> Holds(Vector512<double> u, Vector512<double> v, Vector512<double> w)
    {
        Vector512<double> holds = Vector512<double>.Zero;
        for (int lane = 0; lane < Vector512<double>.Count; lane++)
        {
            if (Holds(new Vector3D(u[lane], v[lane], w[lane])))
            {
                holds = holds.WithElement(lane, BitConverter.Int64BitsToDouble(-1L));
            }
        }

        return holds;
    }

    /// <summary>Whether a point, m, is in the zone.</summary>
    public bool Holds(Vector3D point)
    {
        int plane = _grid.PlaneAt(point.Z);
        if (plane < 0)
        {
            return false;
        }

        double behind = point.Z - _grid.DepthOf(plane);
        double minV = point.Y - (_slope * behind);
        double maxV = point.Y + (_slope * behind);
        if (!(minV >= _grid.MinV && maxV <= _grid.MaxV && point.X >= _minU && behind <= _grid.Spacing))
        {
            return false;
        }

        double height = point.X + (_top * behind) - _grid.BaseU;
        ReadOnlySpan<float> heights = _heights.Span.Slice(plane * _grid.Columns, _grid.Columns);
        int last = _grid.ColumnOf(maxV);
        for (int column = _grid.ColumnOf(minV); column <= last; column++)
        {
            if (!(height < heights[column]))
            {
                return false;
            }
        }

        return true;
    }

    private void Sweep(ReadOnlySpan<float> lowest, double solidRadius)
    {
        int columns = _grid.Columns;
        double drop = _top * _grid.Spacing;
        int planesPerColumn = Math.Max(1, (int)(_grid.ColumnWidth / (_slope * _grid.Spacing)));
        double[] old = new double[columns];
        double[] young = new double[columns];
        double[] spare = new double[columns];
        Array.Fill(old, double.NegativeInfinity);
        Array.Fill(young, double.NegativeInfinity);
        for (int plane = 0; plane < _grid.Planes; plane++)
        {
            if (plane % planesPerColumn == 0)
            {
                // All heights found so far lose a column; so those that are found now have lost one when the next ones begin.
                for (int column = 0; column < columns; column++)
                {
                    old[column] = Math.Max(old[column], young[column]);
                }

                Narrow(old, spare);
                (old, spare) = (spare, old);
                Array.Fill(young, double.NegativeInfinity);
            }

            Span<float> heights = _heights.Span.Slice(plane * columns, columns);
            for (int column = 0; column < columns; column++)
            {
                double height = lowest[(plane * columns) + column];
                spare[column] = double.IsFinite(height) && IsSolid(plane, column, solidRadius) ? height : double.NegativeInfinity;
            }

            for (int column = 0; column < columns; column++)
            {
                old[column] -= drop;
                young[column] = Math.Max(young[column] - drop, LowestNear(spare, column));
                heights[column] = MathF.BitDecrement((float)Math.Max(old[column], young[column]));
            }
        }
    }

    /// <summary>Whether the plane's part of a column reaches into the solid sphere.</summary>
    private bool IsSolid(int plane, int column, double solidRadius)
    {
        double v = Math.Max(Math.Abs(_grid.StartOf(column)), Math.Abs(_grid.StartOf(column + 1)));
        double depth = _grid.DepthOf(plane);
        return (v * v) + (depth * depth) < solidRadius * solidRadius;
    }

    private static void Narrow(double[] heights, double[] narrowed)
    {
        for (int column = 0; column < heights.Length; column++)
        {
            narrowed[column] = LowestNear(heights, column);
        }
    }

    /// <summary>Minimum of a column and its neighbours; minus infinity at the border.</summary>
    private static double LowestNear(double[] heights, int column) => column == 0 || column == heights.Length - 1
        ? double.NegativeInfinity
        : Math.Min(heights[column], Math.Min(heights[column - 1], heights[column + 1]));
}

/// <summary>The points of light space for which all rays to the Sun pass below the lowest terrain, so that they are in shadow.</summary>
/// <param name="solidRadius">Lower bound of the distance of all facets from the Moon's centre, m; 0 for no zone.</param>
/// <param name="slope">Radius of the Sun's disc over its distance; 0 for a point.</param>
internal readonly struct NightZone(double solidRadius, double slope)
{
    /// <summary>
    /// Tells which of eight points are in the zone. In the plane w = 0 light space does not change lengths, and a ray to a part of the
    /// disc meets this plane at most the slope times w away from the ray to the disc's centre.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<double> Holds(Vector512<double> u, Vector512<double> v, Vector512<double> w)
    {
        Vector512<double> room = Vector512.Create(solidRadius) - (Vector512.Create(slope) * w);
        return Vector512.GreaterThan(w, Vector512<double>.Zero)
            & Vector512.GreaterThan(room, Vector512<double>.Zero)
            & Vector512.LessThan((u * u) + (v * v), room * room);
    }
}
