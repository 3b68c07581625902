using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tiles;

/// <summary>The surface of one tile as triangles on the lattice of <see cref="LatticePoint"/>. Treat the arrays as read-only.</summary>
/// <param name="Layout">Which samples are joined, and the order of the vertices.</param>
/// <param name="Radii">m, one a vertex; a pole's is the mean of the line beside it.</param>
/// <param name="Offsets">
/// x, y, z of each vertex in lattice steps from <see cref="Origin"/>, body-fixed axes, each below 2^24 in size.
/// </param>
/// <param name="Faces">Three vertex numbers a triangle (<see cref="TileMeshLayout.CreateFaces"/>).</param>
public sealed record TileMesh(TileMeshLayout Layout, double[] Radii, int[] Offsets, int[] Faces)
{
    /// <summary>Offsets must be smaller than this in size to be exact as 32-bit floats, in which POV-Ray stores vertices.</summary>
    public const int OffsetLimit = 1 << 24;

    /// <summary>The point from which the offsets count.</summary>
    public LatticePoint Origin { get; } = OriginOf(Layout.Tile);

    /// <summary>Number of vertices.</summary>
    public int VertexCount => Offsets.Length / 3;

    /// <summary>Number of triangles.</summary>
    public int FaceCount => Faces.Length / 3;

    /// <summary>
    /// The lattice point nearest to the tile's middle on the sphere of the reference radius; it does not depend on the heights.
    /// </summary>
    public static LatticePoint OriginOf(TileId tile) => LatticePoint.Nearest(
        MoonConstants.ReferenceRadius,
        SineCosine.OfDegrees((2 * tile.SouthDegrees) + TileId.SizeDegrees, 2), // the middles are odd multiples of half a tile
        SineCosine.OfDegrees((2 * tile.WestDegrees) + TileId.SizeDegrees, 2));

    /// <summary>A vertex's place on the whole Moon's lattice.</summary>
    /// <param name="vertex">Number of the vertex, from 0.</param>
    public LatticePoint Vertex(int vertex) => new(
        Origin.X + Offsets[3 * vertex], Origin.Y + Offsets[(3 * vertex) + 1], Origin.Z + Offsets[(3 * vertex) + 2]);
}
