using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// The four sides of one cell and its diagonal, from which the columns that the cell covers in a row are found. Three of the eight vector
/// lanes repeat the diagonal.
/// </summary>
internal readonly struct CellSides
{
    /// <summary>px: widens a range of columns on both sides. It is more than the rounding error of a crossing.</summary>
    public const double Slack = 1e-6;

    private readonly Vector512<double> _x;
    private readonly Vector512<double> _y;
    private readonly Vector512<double> _otherY;
    private readonly Vector512<double> _perRow;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public CellSides(CellCorner northWest, CellCorner northEast, CellCorner southWest, CellCorner southEast)
    {
        (CellCorner a, CellCorner b, CellCorner c, CellCorner d) = (northWest, northEast, southWest, southEast);
        _x = Vector512.Create(a.X, c.X, d.X, b.X, a.X, a.X, a.X, a.X);
        _y = Vector512.Create(a.Y, c.Y, d.Y, b.Y, a.Y, a.Y, a.Y, a.Y);
        _otherY = Vector512.Create(c.Y, d.Y, b.Y, a.Y, d.Y, d.Y, d.Y, d.Y);
        _perRow = (Vector512.Create(c.X, d.X, b.X, a.X, d.X, d.X, d.X, d.X) - _x) / (_otherY - _y);
    }

    /// <summary>Returns columns outside of which no sample lies in the cell, for samples near a row.</summary>
    /// <param name="margin">px: maximum distance of a sample from the row, and from the column of its pixel.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be drawn with unoptimised vectors
    public (double First, double Last) Within(double row, double margin)
    {
        (double aboveFirst, double aboveLast) = At(row - margin);
        (double belowFirst, double belowLast) = At(row + margin);
        Vector512<double> isBetween = Vector512.LessThanOrEqual(Vector512.Abs(_y - Vector512.Create(row)), Vector512.Create(margin));
        Vector512<double> low = Vector512.ConditionalSelect(isBetween, _x, Vector512.Create(double.PositiveInfinity));
        Vector512<double> high = Vector512.ConditionalSelect(isBetween, _x, Vector512.Create(double.NegativeInfinity));
        (double first, double last) = Ends(low, high);
        return (Math.Min(Math.Min(aboveFirst, belowFirst), first) - margin, Math.Max(Math.Max(aboveLast, belowLast), last) + margin);
    }

    /// <summary>
    /// Returns columns outside of which no pixel of the row lies in the cell. A side parallel to the row adds no crossing: its end points
    /// are also ends of the neighbouring sides.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (double First, double Last) At(double row)
    {
        Vector512<double> rows = Vector512.Create(row);
        Vector512<double> down = _y - rows;
        Vector512<double> crossing = _x - (down * _perRow);
        Vector512<double> isCrossed = Vector512.LessThanOrEqual(down * (_otherY - rows), Vector512<double>.Zero)
            & Vector512.Equals(crossing, crossing);
        Vector512<double> low = Vector512.ConditionalSelect(isCrossed, crossing, Vector512.Create(double.PositiveInfinity));
        Vector512<double> high = Vector512.ConditionalSelect(isCrossed, crossing, Vector512.Create(double.NegativeInfinity));
        return Ends(low, high);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (double First, double Last) Ends(Vector512<double> low, Vector512<double> high)
    {
        Vector256<double> low4 = Vector256.MinNative(low.GetLower(), low.GetUpper());
        Vector256<double> high4 = Vector256.MaxNative(high.GetLower(), high.GetUpper());
        Vector128<double> low2 = Vector128.MinNative(low4.GetLower(), low4.GetUpper());
        Vector128<double> high2 = Vector128.MaxNative(high4.GetLower(), high4.GetUpper());
        return (Math.Min(low2[0], low2[1]) - Slack, Math.Max(high2[0], high2[1]) + Slack);
    }
}
