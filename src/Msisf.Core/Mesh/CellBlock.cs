namespace Msisf.Core.Mesh;

/// <summary>A block of up to 32 x 32 cells, the unit in which the renderer culls, reads and draws the surface.</summary>
/// <param name="Row">From north; row 0 begins with the northern fan.</param>
/// <param name="Column">From longitude 0 to the east.</param>
internal readonly record struct CellBlock(int Row, int Column)
{
    /// <summary>Cells to an edge; blocks at the south pole and at longitude 360 degrees may have fewer.</summary>
    public const int Size = 32;

    /// <summary>Rows of blocks of a mesh.</summary>
    public static int RowsOf(FacetMesh mesh) => ((mesh.Lines + 1) + Size - 1) / Size;

    /// <summary>Columns of blocks of a mesh.</summary>
    public static int ColumnsOf(FacetMesh mesh) => (mesh.Samples + Size - 1) / Size;

    /// <summary>The block of a cell.</summary>
    /// <param name="line">-1 to the mesh's lines - 1.</param>
    /// <param name="sample">0 to the mesh's samples - 1.</param>
    public static CellBlock Containing(int line, int sample) => new((line + 1) / Size, sample / Size);

    /// <summary>The block's cells.</summary>
    public CellRange Cells(FacetMesh mesh) => new(
        (Row * Size) - 1,
        Math.Min((Row + 1) * Size, mesh.Lines + 1) - 1,
        Column * Size,
        Math.Min((Column + 1) * Size, mesh.Samples));
}
