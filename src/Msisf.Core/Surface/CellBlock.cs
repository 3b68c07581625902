namespace Msisf.Core.Surface;

/// <summary>
/// A block of up to 32 x 32 cells, or of facets of the seams between models: the unit in which the renderer culls, reads and draws the
/// surface.
/// </summary>
/// <param name="Row">Row of the block from the top; row 0 of a closed mesh begins with the northern fan. 0 for seams.</param>
/// <param name="Column">Column of the block from the left; of the seams its number.</param>
internal readonly record struct CellBlock(int Row, int Column)
{
    /// <summary>Number of cells along an edge; those at the lower and right end may have fewer.</summary>
    public const int Size = 32;

    /// <summary>Number of the block's patch in <see cref="SurfaceModel.Patches"/>.</summary>
    public int Part { get; init; }

    /// <summary>The block as a node of bounds.</summary>
    public NodePlace Node => new(SquareLayout.CellBlockLevel, Row, Column);

    /// <summary>The block as a node of the surface.</summary>
    public SurfaceNode SurfaceNode => new(Part, Node);

    /// <summary>
    /// 0 for all cells of the block; otherwise a rectangle that a finer model has left, counted from 1 (<see cref="CellMask.Pieces"/>).
    /// </summary>
    public int Piece { get; init; }

    public static int RowsOf(FacetMesh mesh) => (mesh.Cells.Lines + Size - 1) / Size;

    public static int ColumnsOf(FacetMesh mesh) => (mesh.Cells.Samples + Size - 1) / Size;

    public CellRange Cells(FacetMesh mesh) => new(
        mesh.Cells.FirstLine + (Row * Size),
        Math.Min(mesh.Cells.FirstLine + ((Row + 1) * Size), mesh.Cells.EndLine),
        mesh.Cells.FirstSample + (Column * Size),
        Math.Min(mesh.Cells.FirstSample + ((Column + 1) * Size), mesh.Cells.EndSample));
}
