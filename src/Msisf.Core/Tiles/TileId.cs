using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tiles;

/// <summary>A 5 x 5 degree tile, named by its south-west corner; <c>default</c> is the one north-east of (0, 0).</summary>
/// <param name="SouthDegrees">Southern border: -90, -85, ... 85.</param>
/// <param name="WestDegrees">Western border: 0, 5, ... 355.</param>
public readonly record struct TileId(int SouthDegrees, int WestDegrees) : IComparable<TileId>
{
    /// <summary>Edge of a tile, degrees.</summary>
    public const int SizeDegrees = 5;

    /// <summary>Rows of tiles from pole to pole.</summary>
    public const int Rows = 180 / SizeDegrees;

    /// <summary>Columns of tiles around the Moon.</summary>
    public const int Columns = 360 / SizeDegrees;

    /// <summary>All tiles of the Moon.</summary>
    public const int Count = Rows * Columns;

    /// <summary>All 2,592 tiles, by latitude, then longitude.</summary>
    public static IEnumerable<TileId> All => Enumerable.Range(0, Count).Select(FromNumber);

    /// <summary>Index in <see cref="All"/>.</summary>
    public int Number => ((SouthDegrees + 90) / SizeDegrees * Columns) + (WestDegrees / SizeDegrees);

    /// <summary>Row, 0 northernmost.</summary>
    public int RowFromNorth => Rows - 1 - ((SouthDegrees + 90) / SizeDegrees);

    /// <summary>Column, 0 east of longitude 0.</summary>
    public int Column => WestDegrees / SizeDegrees;

    /// <summary>The part of a pattern's file name that says where it is: "lat_-5_0_lon_355_360".</summary>
    public string RangeText => Invariant($"lat_{SouthDegrees}_{SouthDegrees + SizeDegrees}_lon_{WestDegrees}_{WestDegrees + SizeDegrees}");

    /// <summary>The tile with an index in <see cref="All"/>.</summary>
    public static TileId FromNumber(int number) => new((number / Columns * SizeDegrees) - 90, number % Columns * SizeDegrees);

    /// <summary>The tile that holds a point; latitude +90 belongs to the last row, longitude 360 to the first column.</summary>
    public static TileId Containing(SelenographicPoint point)
    {
        int row = (int)((double.RadiansToDegrees(point.Latitude) + 90.0) / SizeDegrees);
        int column = (int)(double.RadiansToDegrees(point.Longitude) / SizeDegrees);
        return FromNumber((Math.Min(row, Rows - 1) * Columns) + (column % Columns));
    }

    /// <summary>
    /// The tile whose pattern draws a facet: the one that holds the cell's north-west sample; the northern fan belongs to the tiles of line
    /// 0.
    /// </summary>
    /// <param name="facet">A facet of the surface.</param>
    /// <param name="pixelsPerDegree">Resolution of the grid, px/deg, at least 1.</param>
    public static TileId Holding(FacetId facet, int pixelsPerDegree)
    {
        int size = SizeDegrees * pixelsPerDegree;
        return At(Math.Max(facet.Line, 0) / size, facet.Sample / size % Columns);
    }

    /// <summary>The tile in a row and column.</summary>
    /// <param name="rowFromNorth">0 northernmost.</param>
    /// <param name="column">0 east of longitude 0.</param>
    public static TileId At(int rowFromNorth, int column) => new(90 - (SizeDegrees * (rowFromNorth + 1)), SizeDegrees * column);

    /// <summary>Northernmost grid line of the tile's samples at a resolution in px/deg (line 0 is northernmost).</summary>
    public int FirstLine(int pixelsPerDegree) => RowFromNorth * SizeDegrees * pixelsPerDegree;

    /// <summary>Westernmost grid sample of the tile at a resolution in px/deg.</summary>
    public int FirstSample(int pixelsPerDegree) => WestDegrees * pixelsPerDegree;

    /// <summary>By latitude, then longitude.</summary>
    public int CompareTo(TileId other) =>
        SouthDegrees != other.SouthDegrees ? SouthDegrees.CompareTo(other.SouthDegrees) : WestDegrees.CompareTo(other.WestDegrees);
}
