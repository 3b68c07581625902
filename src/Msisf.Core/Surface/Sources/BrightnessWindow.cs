namespace Msisf.Core.Surface.Sources;

/// <summary>The factors of the ground's reflectance in one window of a view. Safe for several threads.</summary>
internal sealed class BrightnessWindow
{
    private const int Side = DetailTiles<float>.Side;

    private readonly DetailTiles<float> _tiles;
    private readonly LatticeFace _face;
    private readonly int _level;
    private readonly double _perMetre;
    private readonly (double Top, double Bottom, double Left, double Right) _metres;
    private readonly int _firstRow;
    private readonly int _firstColumn;
    private readonly int _columns;
    private readonly float[]?[] _known;

    /// <summary>Takes a window; nothing is computed yet.</summary>
    /// <param name="tiles">The factors, at the samples of a lattice twice as wide as the window's.</param>
    /// <param name="place">Where the window lies.</param>
    public BrightnessWindow(DetailTiles<float> tiles, WindowPlace place)
    {
        CellRange cells = place.Cells;
        double cell = Math.ScaleB(1.0, place.Level);
        (_tiles, _face, _level, _perMetre) = (tiles, place.Face, place.Level + 1, 0.5 / cell);
        _metres = (cell * cells.FirstLine, cell * cells.EndLine, cell * cells.FirstSample, cell * cells.EndSample);
        (_firstRow, _firstColumn) = (TileOf(cells.FirstLine >> 1), TileOf(cells.FirstSample >> 1));
        _columns = TileOf((cells.EndSample >> 1) + 1) - _firstColumn + 1;
        _known = new float[(TileOf((cells.EndLine >> 1) + 1) - _firstRow + 1) * _columns][];
    }

    /// <summary>Whether a place lies in the window.</summary>
    /// <param name="line">m, in the lattices' map.</param>
    /// <param name="sample">m.</param>
    public bool Holds(double line, double sample) =>
        line >= _metres.Top && line <= _metres.Bottom && sample >= _metres.Left && sample <= _metres.Right;

    /// <summary>How much the window's factors count if there is none around it: along its border they go over into 1.</summary>
    public double PartAt(double line, double sample)
    {
        double inside = Math.Min(
            Math.Min(line - _metres.Top, _metres.Bottom - line), Math.Min(sample - _metres.Left, _metres.Right - sample));
        return Math.Min(2.0 * inside * _perMetre / WindowPlan.WidestBorder, 1.0);
    }

    /// <summary>The factor at a place in the window.</summary>
    public double FactorAt(double line, double sample)
    {
        (double y, double x) = (line * _perMetre, sample * _perMetre);
        (int row, int column) = ((int)Math.Floor(y), (int)Math.Floor(x));
        (double down, double right) = (y - row, x - column);
        int at = ((row & (Side - 1)) * Side) + (column & (Side - 1));
        float[] tile = TileAt(TileOf(row), TileOf(column));
        if ((row & (Side - 1)) < Side - 1 && (column & (Side - 1)) < Side - 1)
        {
            return Mixed(tile[at], tile[at + 1], tile[at + Side], tile[at + Side + 1]);
        }

        return Mixed(tile[at], At(row, column + 1), At(row + 1, column), At(row + 1, column + 1));

        double Mixed(double northWest, double northEast, double southWest, double southEast)
        {
            double north = northWest + (right * (northEast - northWest));
            double south = southWest + (right * (southEast - southWest));
            return north + (down * (south - north));
        }
    }

    private static int TileOf(int lattice) => lattice >> 6;

    private float At(int row, int column) => TileAt(TileOf(row), TileOf(column))[((row & (Side - 1)) * Side) + (column & (Side - 1))];

    private float[] TileAt(int row, int column) =>
        _known[((row - _firstRow) * _columns) + column - _firstColumn] ??= _tiles.Get(_face, _level, row, column);
}
