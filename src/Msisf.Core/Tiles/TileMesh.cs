using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tiles;

/// <summary>
/// The surface of one tile or part as triangles on the lattice of <see cref="LatticePoint"/>. Treat the arrays as read-only.
/// </summary>
/// <param name="Layout">Which samples are joined, and the order of the vertices.</param>
/// <param name="Radii">m, one a vertex; a pole's is the mean of the line beside it.</param>
/// <param name="Offsets">
/// x, y, z of each vertex in lattice steps from <see cref="Origin"/>, body-fixed axes, each below 2^24 in size; the vertices of the skirt's
/// foot are last.
/// </param>
/// <param name="Faces">
/// Three vertex numbers a triangle (<see cref="TileMeshLayout.CreateFaces"/>); the triangles of the skirt are last.
/// </param>
/// <param name="SkirtFootRadius">m: the radius at which its skirt ends, if it has one.</param>
public sealed record TileMesh(TileMeshLayout Layout, double[] Radii, int[] Offsets, int[] Faces, double SkirtFootRadius)
{
    /// <summary>Offsets must be smaller than this in size to be exact as 32-bit floats, in which POV-Ray stores vertices.</summary>
    public const int OffsetLimit = 1 << 24;

    /// <summary>The point from which the offsets count.</summary>
    public LatticePoint Origin { get; } = OriginOf(Layout.Part);

    /// <summary>Vertices, the skirt's included.</summary>
    public int VertexCount => Offsets.Length / 3;

    /// <summary>Triangles, the skirt's included.</summary>
    public int FaceCount => Faces.Length / 3;

    /// <summary>Vertices and triangles of the mesh of a layout, the skirt's included.</summary>
    public static (int Vertices, int Faces) CountsOf(TileMeshLayout layout)
    {
        int edges = layout.HasSkirt ? Skirt.Edges(layout) : 0;
        return (layout.VertexCount + edges, layout.FaceCount + (2 * edges));
    }

    /// <summary>
    /// The lattice point nearest to the part's middle on the sphere of the reference radius; it does not depend on the heights.
    /// </summary>
    public static LatticePoint OriginOf(SurfacePart part)
    {
        int halves = 2 * part.Subdivisions; // the middles of parts are odd multiples of half a part
        int north = part.Tile.SouthDegrees + TileId.SizeDegrees;
        return LatticePoint.Nearest(
            MoonConstants.ReferenceRadius,
            SineCosine.OfDegrees((halves * north) - (TileId.SizeDegrees * ((2 * part.Row) + 1)), halves),
            SineCosine.OfDegrees((halves * part.Tile.WestDegrees) + (TileId.SizeDegrees * ((2 * part.Column) + 1)), halves));
    }

    /// <summary>A vertex's place on the whole Moon's lattice.</summary>
    /// <param name="vertex">Number of the vertex, from 0.</param>
    public LatticePoint Vertex(int vertex) => new(
        Origin.X + Offsets[3 * vertex], Origin.Y + Offsets[(3 * vertex) + 1], Origin.Z + Offsets[(3 * vertex) + 2]);
}
