using Msisf.Core.Lod;

namespace Msisf.Core.Tiles;

/// <summary>
/// A piece of the surface that a scene includes as one mesh: a tile, or a square part of it, at one level of detail. <c>default</c> is
/// not a part.
/// </summary>
/// <param name="Level">0: the model itself; each further level has half the resolution (<see cref="LodLevels"/>).</param>
/// <param name="Subdivisions">Number of parts along the tile's edge, a power of two; 1 for the whole tile.</param>
/// <param name="Row">Row of the part in its tile, 0 northernmost.</param>
/// <param name="Column">Column of the part in its tile, 0 westernmost.</param>
public readonly record struct SurfacePart(TileId Tile, int Level, int Subdivisions, int Row, int Column) : IComparable<SurfacePart>
{
    /// <summary>
    /// Default number of cells along a part's edge; a whole tile of 16 px/deg has two times as many. Smaller parts follow the image's
    /// borders better, but each costs a file and, where levels meet, a skirt.
    /// </summary>
    public const int DefaultCells = 40;

    /// <summary>The tile as its pattern draws it.</summary>
    public static SurfacePart Whole(TileId tile, int level = 0) => new(tile, level, 1, 0, 0);

    /// <summary>Number of parts along a tile's edge at a resolution.</summary>
    /// <param name="pixelsPerDegree">Samples a degree of the level.</param>
    /// <param name="cells">Wanted number of cells along a part's edge.</param>
    public static int SubdivisionsAt(int pixelsPerDegree, int cells = DefaultCells)
    {
        int wanted = 1 << int.Log2(Math.Max(1, TileId.SizeDegrees * pixelsPerDegree / cells));
        return Math.Min(wanted, 1 << int.TrailingZeroCount(pixelsPerDegree)); // a part has whole cells
    }

    /// <summary>The four quarters of the part, at the same level.</summary>
    public IEnumerable<SurfacePart> Quarters()
    {
        for (int quarter = 0; quarter < 4; quarter++)
        {
            yield return new SurfacePart(Tile, Level, 2 * Subdivisions, (2 * Row) + (quarter / 2), (2 * Column) + (quarter % 2));
        }
    }

    /// <summary>The part of twice the edge that holds this one, at the same level; a whole tile has none.</summary>
    public SurfacePart Around() => new(Tile, Level, Subdivisions / 2, Row / 2, Column / 2);

    /// <summary>
    /// The part of a file's name that says which part it is: "lat_0_5_lon_15_20", "lat_0_5_lon_15_20_level_1_part_0_1_of_2".
    /// </summary>
    public string NameText => Level == 0 && Subdivisions == 1
        ? Tile.RangeText
        : Invariant($"{Tile.RangeText}_level_{Level}_part_{Row}_{Column}_of_{Subdivisions}");

    /// <summary>By tile, then fineness, then place.</summary>
    public int CompareTo(SurfacePart other) =>
        (Tile, Level, Subdivisions, Row, Column).CompareTo((other.Tile, other.Level, other.Subdivisions, other.Row, other.Column));
}
