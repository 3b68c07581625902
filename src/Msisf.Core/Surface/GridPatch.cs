using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Surface;

/// <summary>
/// The facets of one elevation model: its mesh with each vertex on a lattice, and the bounds of the facets. The model is read only where it
/// is needed. Safe for several threads.
/// </summary>
internal sealed class GridPatch
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

    /// <summary>The cells that finer models leave; null for all.</summary>
    public CellMask? Kept { get; }

    /// <summary>Whether a frame shows nothing of the model.</summary>
    public bool IsLeftOut => Kept is { IsAny: false };

    /// <summary>The same model with some of its cells.</summary>
    public GridPatch WithCells(CellMask kept) => new(this, kept);

    /// <summary>Whether a cell of the mesh belongs to the surface, because no finer model has its place.</summary>
    public bool Has(int line, int sample) => Kept?.Has(line, sample) ?? true;

    /// <summary>The cells of a block, or of a piece of it.</summary>
    public CellRange CellsOf(CellBlock block) => block.Piece == 0 ? block.Cells(Mesh) : Kept!.Pieces[block.Piece - 1];

    /// <summary>Position of a vertex whose radius is known, m, MOON_ME, on the lattice.</summary>
    /// <param name="line">A line of the mesh; -1 (north pole) to the mesh's lines (south pole) of a closed one.</param>
    /// <param name="sample">A sample; of a closed mesh up to its number of samples, which is 0 again.</param>
    /// <param name="radius">m.</param>
    public Vector3D Vertex(int line, int sample, double radius) => Geometry.Vertex(line, sample, radius);

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
