using System.Runtime.Intrinsics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Surface;

/// <summary>
/// The facets of one elevation model: its mesh with each vertex on a lattice, and the bounds of the facets. The model is read only where it
/// is needed. Safe for several threads.
/// </summary>
internal sealed class GridPatch : Patch
{
    /// <summary>Makes the facets of a model; nothing of the model is read yet.</summary>
    /// <param name="grid">The elevation model.</param>
    public GridPatch(ITerrainGrid grid)
    {
        Grid = grid;
        Mesh = new FacetMesh(grid);
        Geometry = MeshGeometry.Of(Mesh);
        Bounds = new BoundsTree(new SquareLayout(Mesh), Mesh, Geometry);
    }

    private GridPatch(GridPatch whole, CellMask kept)
    {
        (Grid, Mesh, Geometry, Bounds) = (whole.Grid, whole.Mesh, whole.Geometry, whole.Bounds);
        Kept = kept;
    }

    /// <summary>The model.</summary>
    public ITerrainGrid Grid { get; }

    /// <summary>The mesh of the model's facets.</summary>
    public FacetMesh Mesh { get; }

    /// <summary>Where the mesh's vertices lie.</summary>
    public MeshGeometry Geometry { get; }

    /// <summary>The surface's bounds in the nodes of <see cref="SquareLayout"/>, computed at the first request.</summary>
    public BoundsTree Bounds { get; }

    public override string? ProductId => Grid.ProductId;

    public override BoundsLayout Layout => Bounds.Layout;

    public override CellMask? Kept { get; }

    public override double Sagitta => Geometry.Sagitta;

    public override double CellAngle => Geometry.CellAngle;

    /// <summary>The same model with some of its cells.</summary>
    public GridPatch WithCells(CellMask kept) => new(this, kept);

    /// <summary>Whether a cell of the mesh belongs to the surface, because no finer model has its place.</summary>
    public bool Has(int line, int sample) => Kept?.Has(line, sample) ?? true;

    /// <summary>The cells of a block, or of a piece of it.</summary>
    public CellRange CellsOf(CellBlock block) => block.Piece == 0 ? block.Cells(Mesh) : Kept!.Pieces[block.Piece - 1];

    /// <summary>Position of a vertex whose radius is known, m, body-fixed, on the lattice.</summary>
    /// <param name="line">A line of the mesh; -1 (north pole) to the mesh's lines (south pole) of a closed one.</param>
    /// <param name="sample">A sample; of a closed mesh up to its number of samples, which is 0 again.</param>
    /// <param name="radius">m.</param>
    public Vector3D Vertex(int line, int sample, double radius) => Geometry.Vertex(line, sample, radius);

    public override bool TryGetKnown(NodePlace node, out NodeBounds bounds) =>
        Bounds.TryGetKnown(node.Level, node.Row, node.Column, out bounds);

    public override NodeBounds BoundsOf(NodePlace node) => Bounds.Of(node.Level, node.Row, node.Column);

    public override NodeBox BoxOf(NodePlace node, double minRadius, double maxRadius) =>
        Bounds.BoxOf(node.Level, node.Row, node.Column, minRadius, maxRadius);

    public override TerrainNode NodeOf(NodePlace node, NodeBounds bounds) =>
        Bounds.NodeOf(Bounds.CapOf(node.Level, node.Row, node.Column), bounds);

    public override bool Has(FacetId facet)
    {
        CellRange cells = Mesh.Cells;
        return facet.Line >= cells.FirstLine && facet.Line < cells.EndLine && facet.Sample >= cells.FirstSample
            && facet.Sample < cells.EndSample && Has(facet.Line, facet.Sample);
    }

    public override (int Part, int Line, int Sample) VertexOf(FacetId facet, int corner)
    {
        bool isSouth = corner == 1 || (corner == 2 && facet.Half == FacetHalf.SouthWest);
        bool isEast = corner == 2 || (corner == 1 && facet.Half == FacetHalf.NorthEast);
        return (facet.Part, isSouth ? facet.Line + 1 : facet.Line, isEast ? Mesh.Next(facet.Sample) : facet.Sample);
    }

    public override (int Part, FacetSource Source) SourceOf(FacetId facet)
    {
        return (facet.Part, IsBlended(0) || IsBlended(1) || IsBlended(2) ? FacetSource.Blended : FacetSource.Measured);

        bool IsBlended(int corner)
        {
            (_, int line, int sample) = VertexOf(facet, corner);
            return line >= 0 && line < Grid.Lines && Grid.IsBlended(line, sample);
        }
    }

    public override (Vector3D A, Vector3D B, Vector3D C) CornersOf(FacetId facet) => Corners(facet.Line, facet.Sample).Facet(facet.Half);

    public override IEnumerable<FacetId> FacetsOf(NodePlace node)
    {
        CellRange cells = Layout.Cells(node.Level, node.Row, node.Column);
        for (int line = cells.FirstLine; line < cells.EndLine; line++)
        {
            for (int sample = cells.FirstSample; sample < cells.EndSample; sample++)
            {
                if (!Has(line, sample))
                {
                    continue;
                }

                if (line < Mesh.SouthFanLine)
                {
                    yield return new FacetId(line, sample, FacetHalf.SouthWest);
                }

                if (line >= 0 || !Mesh.IsClosed)
                {
                    yield return new FacetId(line, sample, FacetHalf.NorthEast);
                }
            }
        }
    }

    public override long CountFacets(CellRange cells) => 2L * cells.Lines * cells.Samples;

    public override void Load(BlockVertices vertices, Vector3D originBodyFixed)
    {
        CellRange cells = CellsOf(vertices.Block);
        vertices.Begin(cells, Mesh.SouthFanLine);
        int samples = vertices.Samples;
        int whole = (samples + Vector512<double>.Count - 1) / Vector512<double>.Count * Vector512<double>.Count;
        Span<double> radii = vertices.Radii;
        radii[samples..].Fill(Grid.ReferenceRadius);
        for (int line = 0; line < vertices.Lines; line++)
        {
            int start = line * BlockVertices.Stride;
            Mesh.ReadRadii(cells.FirstLine + line, cells.FirstSample, radii[..samples]);
            Geometry.PlaceLine(
                cells.FirstLine + line, cells.FirstSample, radii[..whole], originBodyFixed, vertices.X.AsSpan(start, whole),
                vertices.Y.AsSpan(start, whole), vertices.Z.AsSpan(start, whole));
        }
    }

    /// <summary>The corners of a cell of the mesh.</summary>
    public CellCorners Corners(int line, int sample)
    {
        Span<double> radii = stackalloc double[4];
        ReadCorners(line, sample, radii);
        return Corners(line, sample, radii);
    }

    /// <summary>The corners of a cell whose radii are known in the order NW, NE, SW, SE.</summary>
    public CellCorners Corners(int line, int sample, ReadOnlySpan<double> radii) => new(
        Vertex(line, sample, radii[0]),
        Vertex(line, sample + 1, radii[1]),
        Vertex(line + 1, sample, radii[2]),
        Vertex(line + 1, sample + 1, radii[3]));

    /// <summary>The radii of a cell's corners, m, in the order NW, NE, SW, SE.</summary>
    public void ReadCorners(int line, int sample, Span<double> radii)
    {
        Mesh.ReadRadii(line, sample, radii[..2]);
        Mesh.ReadRadii(line + 1, sample, radii[2..]);
    }
}
