namespace Msisf.Core.Surface;

/// <summary>
/// Divides a mesh into patches of 8 x 8 cells for single rays, cell blocks of 32 x 32 cells for images, and further levels of 4 x 4 nodes
/// each, up to some tens of degrees. The top row of a closed mesh begins with the northern fan.
/// </summary>
/// <param name="mesh">The mesh whose cells are divided.</param>
internal sealed class SquareLayout(FacetMesh mesh) : BoundsLayout(mesh.Lines, mesh.Samples)
{
    public const int PatchLevel = 0;

    /// <summary>The level whose nodes are the <see cref="CellBlock"/>s.</summary>
    public const int CellBlockLevel = 1;

    /// <summary>The level of the groups of 4 x 4 cell blocks.</summary>
    public const int GroupLevel = 2;

    /// <summary>Number of cell blocks of a group.</summary>
    public const int GroupBlocks = Fan * Fan;

    private const int Fan = 4;

    /// <summary>
    /// Minimum number of nodes around the Moon on a level above the groups: the cap around a larger node might exceed a hemisphere.
    /// </summary>
    private const int MinColumns = 8;

    public override int Levels { get; } = LevelsFor(mesh.Samples);

    public override int CoarsestReadLevel => CellBlockLevel;

    /// <summary>Number of cells along an edge of a node; those at the lower and right end may have fewer.</summary>
    public static int Side(int level) => 1 << SideShift(level);

    /// <summary>Base-2 logarithm of <see cref="Side"/>.</summary>
    public static int SideShift(int level) => 3 + (2 * level);

    public override int Rows(int level) => (mesh.Cells.Lines + Side(level) - 1) >> SideShift(level);

    public override int Columns(int level) => (mesh.Cells.Samples + Side(level) - 1) >> SideShift(level);

    public override int ChildrenPerEdge(int level) => Fan;

    /// <inheritdoc/>
    /// <remarks>Quarter by quarter, and each quarter again by its quarters, so that successive blocks are neighbours.</remarks>
    public override (int Down, int Right) ChildAt(int child, int edge) =>
        (((child >> 2) & 2) + ((child >> 1) & 1), ((child >> 1) & 2) + (child & 1));

    public override CellRange Cells(int level, int row, int column) => new(
        mesh.Cells.FirstLine + (row << SideShift(level)),
        Math.Min(mesh.Cells.FirstLine + ((row + 1) << SideShift(level)), mesh.Cells.EndLine),
        mesh.Cells.FirstSample + (column << SideShift(level)),
        Math.Min(mesh.Cells.FirstSample + ((column + 1) << SideShift(level)), mesh.Cells.EndSample));

    private static int LevelsFor(int samples)
    {
        int levels = GroupLevel + 1;
        while (Side(levels) * MinColumns <= samples)
        {
            levels++;
        }

        return levels;
    }
}
