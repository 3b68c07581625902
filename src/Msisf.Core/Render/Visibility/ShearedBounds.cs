using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// A parallelogram around each of eight cells, with horizontal top and bottom and with sides along the cell's longer side. For long thin
/// cells, such as all cells near a pole, it holds fewer pixels than an upright rectangle. It encloses the cell whatever the direction of
/// the sides.
/// </summary>
internal readonly struct ShearedBounds
{
    /// <summary>
    /// px per row: maximum shift of the sides from one row to the next. More would not fit nearly horizontal cells better, but would cost
    /// accuracy.
    /// </summary>
    private const double MaxLean = 64.0;

    private readonly Vector512<double> _top;
    private readonly Vector512<double> _lean;
    private readonly Vector512<double> _left;
    private readonly Vector512<double> _right;

    private ShearedBounds(
        Vector512<double> top, Vector512<double> lean, Vector512<double> left, Vector512<double> right, Vector512<double> slack)
    {
        _top = top;
        _lean = lean;
        _left = left - slack;
        _right = right + slack;
    }

    /// <summary>Makes boxes with vertical sides.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ShearedBounds Upright(Vector512<double> left, Vector512<double> right) =>
        new(Vector512<double>.Zero, Vector512<double>.Zero, left, right, Vector512.Create(CellSides.Slack));

    /// <summary>Makes boxes with sides along the cells' western or northern sides, whichever cross more rows.</summary>
    /// <param name="margin">px: maximum distance of a sample from its pixel along columns or rows; 0 for a pinhole.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ShearedBounds Along(EightCells cells, double margin)
    {
        Vector512<double> top = cells.Y(0);
        Vector512<double> x = cells.X(0);
        Vector512<double> westX = cells.X(FacetCorners.SouthWest) - x;
        Vector512<double> westY = cells.Y(FacetCorners.SouthWest) - top;
        Vector512<double> northX = cells.X(FacetCorners.NorthEast) - x;
        Vector512<double> northY = cells.Y(FacetCorners.NorthEast) - top;
        Vector512<double> isWest = Vector512.GreaterThan(Vector512.Abs(westY), Vector512.Abs(northY));
        Vector512<double> lean = Vector512.ConditionalSelect(isWest, westX, northX) / Vector512.ConditionalSelect(isWest, westY, northY);
        lean = Vector512.MinNative(Vector512.MaxNative(lean, Vector512.Create(-MaxLean)), Vector512.Create(MaxLean));
        Vector512<double> northEast = cells.X(FacetCorners.NorthEast) - (lean * northY);
        Vector512<double> southWest = cells.X(FacetCorners.SouthWest) - (lean * westY);
        Vector512<double> southEast = cells.X(FacetCorners.SouthEast) - (lean * (cells.Y(FacetCorners.SouthEast) - top));
        return new ShearedBounds(
            top,
            lean,
            Vector512.MinNative(Vector512.MinNative(x, northEast), Vector512.MinNative(southWest, southEast)),
            Vector512.MaxNative(Vector512.MaxNative(x, northEast), Vector512.MaxNative(southWest, southEast)),
            Vector512.Create(CellSides.Slack + margin) + (margin * Vector512.Abs(lean)));
    }

    /// <summary>Left and right column of the box of each cell in a row, px.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (Vector512<double> Left, Vector512<double> Right) At(Vector512<double> row)
    {
        Vector512<double> shift = _lean * (row - _top);
        return (_left + shift, _right + shift);
    }
}
