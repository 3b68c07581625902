namespace Msisf.Core.Surface;

/// <summary>
/// A part of the surface: the facets of one elevation model (<see cref="GridPatch"/>), or those that join several
/// (<see cref="SeamPatch"/>). Its facets lie in blocks, and the blocks in a tree of nodes with bounds. Safe for several threads.
/// </summary>
internal abstract class Patch
{
    /// <summary>The model's name; null for seams.</summary>
    public abstract string? ProductId { get; }

    /// <summary>The nodes; those of <see cref="SquareLayout.CellBlockLevel"/> are the blocks.</summary>
    public abstract BoundsLayout Layout { get; }

    /// <summary>The cells that finer models leave; null for all.</summary>
    public virtual CellMask? Kept => null;

    /// <summary>Whether a frame shows nothing of the patch.</summary>
    public bool IsLeftOut => Kept is { IsAny: false };

    /// <summary>
    /// The numbers of the pieces that finer models have left of a block (<see cref="CellBlock.Piece"/>): 0 alone if all of it is left.
    /// </summary>
    public (int First, int Count) PiecesOf(CellBlock block) => Kept?.StateOf(block.Row, block.Column) switch
    {
        null or CellMask.BlockState.Whole => (0, 1),
        CellMask.BlockState.Empty => (0, 0),
        _ => Kept.PiecesOf(block.Row, block.Column),
    };

    /// <summary>Ratio of a facet's minimum radius to its minimum vertex radius, at least.</summary>
    public abstract double Sagitta { get; }

    /// <summary>rad: upper bound of a cell's sides as seen from the Moon's centre; 0 if facets lie in no cells.</summary>
    public virtual double CellAngle => 0.0;

    /// <summary>Gets the bounds of a node if they follow from known bounds; nothing is read.</summary>
    public abstract bool TryGetKnown(NodePlace node, out NodeBounds bounds);

    /// <summary>The bounds of a node; parts that are not known yet are read.</summary>
    public abstract NodeBounds BoundsOf(NodePlace node);

    /// <summary>The box that holds all facets of a node whose vertex radii lie within limits (m).</summary>
    public abstract NodeBox BoxOf(NodePlace node, double minRadius, double maxRadius);

    /// <summary>A node with its place, and with bounds that are known of it.</summary>
    public abstract TerrainNode NodeOf(NodePlace node, NodeBounds bounds);

    public abstract bool Has(FacetId facet);

    /// <summary>A corner of a facet, in the model from which it is taken.</summary>
    /// <param name="corner">0 to 2, counter-clockwise seen from outside.</param>
    /// <returns>Part, line and sample of the vertex.</returns>
    public abstract (int Part, int Line, int Sample) VertexOf(FacetId facet, int corner);

    /// <summary>The finest model at a facet's corners, and what became of its heights; invented ones count as measured.</summary>
    public abstract (int Part, FacetSource Source) SourceOf(FacetId facet);

    /// <summary>The corners of a facet, m, body-fixed, counter-clockwise seen from outside.</summary>
    public abstract (Vector3D A, Vector3D B, Vector3D C) CornersOf(FacetId facet);

    /// <summary>The facets of a node of the finest level, without those that finer models replace.</summary>
    public abstract IEnumerable<FacetId> FacetsOf(NodePlace node);

    /// <summary>Number of facets of some cells; at poles, and beside finer models, an upper bound.</summary>
    public abstract long CountFacets(CellRange cells);

    /// <summary>Reads the vertices of <see cref="BlockVertices.Block"/>.</summary>
    /// <param name="vertices">Receives them.</param>
    /// <param name="originBodyFixed">m, body-fixed; it is subtracted from each vertex with one rounding per component.</param>
    public abstract void Load(BlockVertices vertices, Vector3D originBodyFixed);
}
