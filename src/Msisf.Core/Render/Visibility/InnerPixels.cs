using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// The pixels of a row that lie in a facet with all their samples: a range of columns, from the facet's three sides. One lane of four
/// repeats a side.
/// </summary>
internal readonly struct InnerPixels
{
    /// <summary>Part of the distance to a side by which it is widened: more than the rounding of edge functions.</summary>
    private const double Slack = 1e-6;

    private readonly Vector256<double> _x;
    private readonly Vector256<double> _y;
    private readonly Vector256<double> _width;
    private readonly Vector256<double> _height;
    private readonly Vector256<double> _reach;

    /// <summary>For a facet, its corners in the order of the sides of <see cref="Msisf.Core.Surface.CellEdges"/>.</summary>
    /// <param name="margin">px: maximum distance of a sample from its pixel's centre along columns or rows.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public InnerPixels(CellCorner a, CellCorner b, CellCorner c, double margin)
    {
        _x = Vector256.Create(a.X, b.X, c.X, c.X);
        _y = Vector256.Create(a.Y, b.Y, c.Y, c.Y);
        _width = Vector256.Create(b.X, c.X, a.X, a.X) - _x;
        _height = Vector256.Create(b.Y, c.Y, a.Y, a.Y) - _y;
        _reach = (1.0 + Slack) * margin * (Vector256.Abs(_width) + Vector256.Abs(_height));
    }

    /// <summary>The first and the last column; the first is greater if there is none.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be drawn with unoptimised vectors
    public (double First, double Last) At(double row)
    {
        // Inside, height * (column - x) is at least this.
        Vector256<double> least = _reach + (_width * (Vector256.Create(row) - _y));
        Vector256<double> limits = _x + (least / _height);
        Vector256<double> zero = Vector256<double>.Zero;
        Vector256<double> none = Vector256.Equals(_height, zero) & Vector256.GreaterThan(least, zero);
        Vector256<double> low = Vector256.ConditionalSelect(
            Vector256.GreaterThan(_height, zero), limits, Vector256.Create(double.NegativeInfinity));
        Vector256<double> high = Vector256.ConditionalSelect(
            Vector256.LessThan(_height, zero), limits, Vector256.Create(double.PositiveInfinity));
        low = Vector256.ConditionalSelect(none, Vector256.Create(double.PositiveInfinity), low);
        Vector128<double> low2 = Vector128.MaxNative(low.GetLower(), low.GetUpper());
        Vector128<double> high2 = Vector128.MinNative(high.GetLower(), high.GetUpper());
        return (Math.Ceiling(Math.Max(low2[0], low2[1])), Math.Floor(Math.Min(high2[0], high2[1])));
    }
}

/// <summary>The inverse depth of a facet as a function of the place in the image, 1/m.</summary>
/// <param name="X">Column of a corner.</param>
/// <param name="Y">Row of the corner.</param>
/// <param name="AtCorner">The inverse depth there.</param>
internal readonly record struct FacetPlane(double X, double Y, double AtCorner, double PerColumn, double PerRow)
{
    /// <summary>Through three corners, which are not in a line.</summary>
    public static FacetPlane Of(CellCorner a, CellCorner b, CellCorner c)
    {
        (double bx, double by, double bDepth) = (b.X - a.X, b.Y - a.Y, b.InverseDepth - a.InverseDepth);
        (double cx, double cy, double cDepth) = (c.X - a.X, c.Y - a.Y, c.InverseDepth - a.InverseDepth);
        double perArea = 1.0 / ((bx * cy) - (cx * by));
        return new FacetPlane(
            a.X, a.Y, a.InverseDepth, ((bDepth * cy) - (cDepth * by)) * perArea, ((cDepth * bx) - (bDepth * cx)) * perArea);
    }

    /// <summary>The inverse depth at a place.</summary>
    public double At(double x, double y) => AtCorner + (PerColumn * (x - X)) + (PerRow * (y - Y));

    /// <summary>The inverse depths at eight places.</summary>
    public Vector512<double> At(Vector512<double> x, Vector512<double> y) =>
        Vector512.Create(AtCorner) + (PerColumn * (x - Vector512.Create(X))) + (PerRow * (y - Vector512.Create(Y)));
}
