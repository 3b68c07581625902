using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Visibility;

/// <summary>Where eight cells cross rows of the picture: the sides and the diagonal of each.</summary>
internal readonly struct CellSlopes
{
    private readonly Slope _north;
    private readonly Slope _west;
    private readonly Slope _south;
    private readonly Slope _east;
    private readonly Slope _diagonal;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public CellSlopes(EightCells cells)
    {
        _north = new Slope(cells, 0, FacetCorners.NorthEast);
        _west = new Slope(cells, 0, FacetCorners.SouthWest);
        _south = new Slope(cells, FacetCorners.SouthWest, FacetCorners.SouthEast);
        _east = new Slope(cells, FacetCorners.NorthEast, FacetCorners.SouthEast);
        _diagonal = new Slope(cells, 0, FacetCorners.SouthEast);
    }

    /// <summary>Columns between which the cells cross rows, each cell its own, within some rounding; low is above high where a cell does not.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (Vector512<double> Low, Vector512<double> High) Between(EightCells cells, Vector512<double> row)
    {
        Vector512<double> northWest = cells.Y(0) - row;
        Vector512<double> northEast = cells.Y(FacetCorners.NorthEast) - row;
        Vector512<double> southWest = cells.Y(FacetCorners.SouthWest) - row;
        Vector512<double> southEast = cells.Y(FacetCorners.SouthEast) - row;
        Vector512<double> low = Vector512.Create(double.PositiveInfinity);
        Vector512<double> high = Vector512.Create(double.NegativeInfinity);
        _north.Widen(cells.X(0), northWest, northEast, ref low, ref high);
        _west.Widen(cells.X(0), northWest, southWest, ref low, ref high);
        _south.Widen(cells.X(FacetCorners.SouthWest), southWest, southEast, ref low, ref high);
        _east.Widen(cells.X(FacetCorners.NorthEast), northEast, southEast, ref low, ref high);
        _diagonal.Widen(cells.X(0), northWest, southEast, ref low, ref high);
        return (low, high);
    }

    private readonly struct Slope
    {
        private readonly Vector512<double> _perRow;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Slope(EightCells cells, int corner, int other) =>
            _perRow = (cells.X(other) - cells.X(corner)) / (cells.Y(other) - cells.Y(corner));

        /// <summary>Adds the crossing. A side along the row has none, which is no number and changes nothing: its neighbours end where it does.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Widen(
            Vector512<double> x, Vector512<double> down, Vector512<double> otherDown, ref Vector512<double> low, ref Vector512<double> high)
        {
            Vector512<double> crossing = x - (down * _perRow);
            Vector512<double> isCrossed = Vector512.LessThanOrEqual(down * otherDown, Vector512<double>.Zero);
            low = Vector512.ConditionalSelect(isCrossed, Vector512.MinNative(crossing, low), low);
            high = Vector512.ConditionalSelect(isCrossed, Vector512.MaxNative(crossing, high), high);
        }
    }
}
