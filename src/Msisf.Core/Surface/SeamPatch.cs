namespace Msisf.Core.Surface;

/// <summary>The seams: the facets between several models, which close the gaps between their cells; immutable.</summary>
/// <remarks>
/// The renderer's kernels know blocks of cells. A block of seams is laid out so: in lines 0, 2, 4 ... of cells each second cell has one
/// facet as its south-western half; the cells between stand for nothing (<see cref="CellsOfLine"/>).
/// </remarks>
internal sealed class SeamPatch : Patch
{
    /// <summary>Number of facets of a block; the last one may have fewer.</summary>
    public const int BlockFacets = 64;

    /// <summary>Facets of all seams together are fewer.</summary>
    public const int MaxFacets = 1 << 23;

    private const int LineFacets = 16;
    private const uint EverySecondCell = 0x55555555;

    private readonly SeamVertex[] _vertices;
    private readonly int[] _corners;

    /// <summary>Takes the facets.</summary>
    /// <param name="corners">
    /// Three indices of vertices for each facet, counter-clockwise seen from outside; neighbours follow each other.
    /// </param>
    public SeamPatch(SeamVertex[] vertices, int[] corners)
    {
        _vertices = vertices;
        _corners = corners;
        SeamBlock[] blocks = new SeamBlock[(Count + BlockFacets - 1) / BlockFacets];
        for (int block = 0; block < blocks.Length; block++)
        {
            int first = 3 * BlockFacets * block;
            blocks[block] = SeamBlock.Of(
                [.. corners.AsSpan(first, 3 * FacetsOf(block)).ToArray().Select(corner => vertices[corner].Position)]);
        }

        Blocks = blocks;
        Layout = new RowOfBlocks(blocks.Length);
        double widest = 0.0;
        for (int facet = 0; facet < Count; facet++)
        {
            (Vector3D a, Vector3D b, Vector3D c) = CornersOf(facet);
            Vector3D middle = a + b + c;
            widest = Math.Max(widest, Math.Max(SineSquare(middle, a), Math.Max(SineSquare(middle, b), SineSquare(middle, c))));
        }

        double angle = Math.Atan2(Math.Sqrt(widest), Math.Sqrt(1.0 - widest));
        Sagitta = Count == 0 ? 1.0 : Math.Cos(angle + Tolerances.CapRadius);
    }

    /// <summary>No facets: the surface of one model.</summary>
    public static SeamPatch None { get; } = new([], []);

    /// <summary>Number of facets.</summary>
    public int Count => _corners.Length / 3;

    /// <summary>Bounds of each block.</summary>
    public IReadOnlyList<SeamBlock> Blocks { get; }

    public override double Sagitta { get; }

    public override string? ProductId => null;

    public override BoundsLayout Layout { get; }

    /// <summary>The cells of a line of a block that have facets, as bits.</summary>
    public static uint CellsOfLine(int line, int facets)
    {
        int count = Math.Clamp(facets - (line / 2 * LineFacets), 0, LineFacets);
        return (line & 1) != 0 ? 0 : EverySecondCell & (uint)((1UL << (2 * count)) - 1);
    }

    /// <summary>Number in its block of the facet of a cell.</summary>
    public static int FacetAt(int line, int sample) => (line / 2 * LineFacets) + (sample / 2);

    public int FacetsOf(int block) => Math.Min(BlockFacets, Count - (block * BlockFacets));

    public override bool TryGetKnown(NodePlace node, out NodeBounds bounds)
    {
        bounds = BoundsOf(node);
        return true;
    }

    public override NodeBounds BoundsOf(NodePlace node)
    {
        TerrainNode block = Blocks[node.Column].Node;
        return NodeBounds.Within((block.MinRadius, block.MaxRadius));
    }

    public override NodeBox BoxOf(NodePlace node, double minRadius, double maxRadius) => Blocks[node.Column].Box;

    public override TerrainNode NodeOf(NodePlace node, NodeBounds bounds) => Blocks[node.Column].Node;

    public override bool Has(FacetId facet) =>
        facet.Line == 0 && facet.Sample >= 0 && facet.Sample < Count && facet.Half == FacetHalf.SouthWest;

    public override (int Part, int Line, int Sample) VertexOf(FacetId facet, int corner)
    {
        SeamVertex vertex = VertexOf(facet.Sample, corner);
        return (vertex.Part, vertex.Line, vertex.Sample);
    }

    public override (int Part, FacetSource Source) SourceOf(FacetId facet)
    {
        int part = Math.Max(VertexOf(facet.Sample, 0).Part, Math.Max(VertexOf(facet.Sample, 1).Part, VertexOf(facet.Sample, 2).Part));
        return (part, FacetSource.Seam);
    }

    public override (Vector3D A, Vector3D B, Vector3D C) CornersOf(FacetId facet) => CornersOf(facet.Sample);

    public override IEnumerable<FacetId> FacetsOf(NodePlace node) => Enumerable
        .Range(node.Column * BlockFacets, FacetsOf(node.Column)).Select(facet => new FacetId(0, facet, FacetHalf.SouthWest));

    public override long CountFacets(CellRange cells) => FacetsOf(cells.FirstSample / CellBlock.Size);

    /// <summary>The corners of a facet, m, body-fixed, counter-clockwise seen from outside.</summary>
    public (Vector3D A, Vector3D B, Vector3D C) CornersOf(int facet) =>
        (VertexOf(facet, 0).Position, VertexOf(facet, 1).Position, VertexOf(facet, 2).Position);

    /// <summary>A corner of a facet.</summary>
    /// <param name="corner">0 to 2.</param>
    public SeamVertex VertexOf(int facet, int corner) => _vertices[_corners[(3 * facet) + corner]];

    /// <summary>Square of the sine of the angle between two directions, which is far below a right angle.</summary>
    private static double SineSquare(Vector3D u, Vector3D v) => Vector3D.Cross(u, v).LengthSquared / (u.LengthSquared * v.LengthSquared);

    public override void Load(BlockVertices vertices, Vector3D originBodyFixed)
    {
        int block = vertices.Block.Column;
        int facets = FacetsOf(block);
        int lines = 2 * ((facets + LineFacets - 1) / LineFacets);
        vertices.Begin(lines, 2 * LineFacets, facets);
        for (int i = 0; i < lines / 2 * LineFacets; i++)
        {
            // Places without a facet repeat the last one, so that all numbers are of the block.
            (Vector3D a, Vector3D b, Vector3D c) = CornersOf((block * BlockFacets) + Math.Min(i, facets - 1));
            int at = (i / LineFacets * 2 * BlockVertices.Stride) + (i % LineFacets * 2);
            Put(at, a - originBodyFixed);
            Put(at + 1, c - originBodyFixed);
            Put(at + BlockVertices.Stride, b - originBodyFixed);
            Put(at + BlockVertices.Stride + 1, c - originBodyFixed);
        }

        void Put(int index, Vector3D position) =>
            (vertices.X[index], vertices.Y[index], vertices.Z[index]) = (position.X, position.Y, position.Z);
    }

    /// <summary>Blocks without nodes above them, as cells that lie beside each other.</summary>
    private sealed class RowOfBlocks(int blocks) : BoundsLayout(lines: 0, samples: 0)
    {
        public override int Levels => SquareLayout.CellBlockLevel + 1;

        public override int CoarsestReadLevel => SquareLayout.CellBlockLevel;

        public override int Rows(int level) => 1;

        public override int Columns(int level) => blocks;

        public override int ChildrenPerEdge(int level) => 1;

        public override CellRange Cells(int level, int row, int column) =>
            new(0, CellBlock.Size, column * CellBlock.Size, (column + 1) * CellBlock.Size);
    }
}
