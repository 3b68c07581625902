namespace Msisf.Core.Mesh.Bounds;

/// <summary>
/// Divides a mesh into patches of 8 x 8 cells for single rays, cell blocks of 32 x 32 cells for images, and further levels of 4 x 4 nodes
/// each, up to some tens of degrees. The northernmost row begins with the northern fan.
/// </summary>
/// <param name="mesh">The mesh whose cells are divided.</param>
internal sealed class SquareLayout(FacetMesh mesh) : BoundsLayout(mesh.Lines, mesh.Samples)
{
    /// <summary>The level of the patches.</summary>
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

    /// <inheritdoc/>
    public override int Levels { get; } = LevelsFor(mesh.Samples);

    /// <inheritdoc/>
    public override int CoarsestReadLevel => CellBlockLevel;

    /// <summary>Number of cells along an edge of a node; nodes at the south pole and at longitude 360 degrees may have fewer.</summary>
    public static int Side(int level) => 1 << SideShift(level);

    /// <summary>Base-2 logarithm of <see cref="Side"/>.</summary>
    public static int SideShift(int level) => 3 + (2 * level);

    /// <inheritdoc/>
    public override int Rows(int level) => (Lines + Side(level)) >> SideShift(level);

    /// <inheritdoc/>
    public override int Columns(int level) => (Samples + Side(level) - 1) >> SideShift(level);

    /// <inheritdoc/>
    protected override int ChildrenPerEdge(int level) => Fan;

    /// <inheritdoc/>
    public override CellRange Cells(int level, int row, int column) => new(
        (row << SideShift(level)) - 1,
        Math.Min((row + 1) << SideShift(level), Lines + 1) - 1,
        column << SideShift(level),
        Math.Min((column + 1) << SideShift(level), Samples));

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
