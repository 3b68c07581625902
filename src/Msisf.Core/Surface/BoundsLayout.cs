namespace Msisf.Core.Surface;

/// <summary>
/// How the cells of a mesh are divided into the nodes of a <see cref="BoundsTree"/>. Level 0 is the finest. The nodes of a level form a
/// grid with rows from the top and columns from the left. Each node is a square of nodes of the level below.
/// </summary>
/// <param name="lines">Number of lines of samples of the mesh.</param>
/// <param name="samples">Number of samples per line.</param>
internal abstract class BoundsLayout(int lines, int samples)
{
    /// <summary>Number of lines of samples of the mesh.</summary>
    public int Lines { get; } = lines;

    /// <summary>Number of samples per line.</summary>
    public int Samples { get; } = samples;

    public abstract int Levels { get; }

    /// <summary>
    /// The coarsest level whose nodes are bounded by reading their cells; the bounds of nodes of coarser levels are the union of their
    /// children's.
    /// </summary>
    public abstract int CoarsestReadLevel { get; }

    /// <summary>Number of rows of nodes of a level.</summary>
    public abstract int Rows(int level);

    /// <summary>Number of columns of nodes of a level.</summary>
    public abstract int Columns(int level);

    /// <summary>Number of nodes of the level below along an edge of a node; nodes in the last row and column may have fewer.</summary>
    public abstract int ChildrenPerEdge(int level);

    /// <summary>Row and column, in its node, of the child that a walk comes to after so many others.</summary>
    public virtual (int Down, int Right) ChildAt(int child, int edge) => (child / edge, child % edge);

    /// <summary>The cells of a node.</summary>
    public abstract CellRange Cells(int level, int row, int column);

    /// <summary>The cells of all nodes.</summary>
    public CellRange AllCells
    {
        get
        {
            CellRange last = Cells(0, Rows(0) - 1, Columns(0) - 1);
            CellRange first = Cells(0, 0, 0);
            return new CellRange(first.FirstLine, last.EndLine, first.FirstSample, last.EndSample);
        }
    }

    /// <summary>The nodes of the level below that make up a node.</summary>
    /// <param name="level">The node's level, which is not the finest.</param>
    public NodeRange ChildrenOf(int level, int row, int column)
    {
        int edge = ChildrenPerEdge(level);
        return new NodeRange(
            row * edge, Math.Min((row + 1) * edge, Rows(level - 1)), column * edge, Math.Min((column + 1) * edge, Columns(level - 1)));
    }
}
