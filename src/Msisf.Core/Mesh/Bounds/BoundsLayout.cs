namespace Msisf.Core.Mesh.Bounds;

/// <summary>
/// How the cells of a mesh are divided into the nodes of a <see cref="BoundsTree"/>. Level 0 is the finest. A level's nodes are a grid of
/// rows from the north and columns from longitude 0 to the east, and each is a square of nodes of the level below.
/// </summary>
/// <param name="lines">Lines of samples of the mesh.</param>
/// <param name="samples">Samples a line.</param>
internal abstract class BoundsLayout(int lines, int samples)
{
    /// <summary>Lines of samples of the mesh.</summary>
    public int Lines { get; } = lines;

    /// <summary>Samples a line.</summary>
    public int Samples { get; } = samples;

    /// <summary>How many levels there are.</summary>
    public abstract int Levels { get; }

    /// <summary>
    /// The coarsest level whose nodes are bounded by reading their cells; those of coarser levels are the union of their children.
    /// </summary>
    public abstract int CoarsestReadLevel { get; }

    /// <summary>Rows of nodes of a level.</summary>
    public abstract int Rows(int level);

    /// <summary>Columns of nodes of a level.</summary>
    public abstract int Columns(int level);

    /// <summary>Nodes of the level below along an edge of a node; those at the last row and column may have fewer.</summary>
    protected abstract int ChildrenPerEdge(int level);

    /// <summary>The cells of a node.</summary>
    public abstract CellRange Cells(int level, int row, int column);

    /// <summary>The nodes of the level below of which a node consists.</summary>
    /// <param name="level">Not the finest.</param>
    /// <param name="row">The node's row.</param>
    /// <param name="column">The node's column.</param>
    public NodeRange ChildrenOf(int level, int row, int column)
    {
        int edge = ChildrenPerEdge(level);
        return new NodeRange(
            row * edge, Math.Min((row + 1) * edge, Rows(level - 1)), column * edge, Math.Min((column + 1) * edge, Columns(level - 1)));
    }
}
