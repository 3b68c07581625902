using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tiles;

/// <summary>The surface of one tile as triangles on the lattice of <see cref="LatticePoint"/>. Treat the arrays as read-only.</summary>
/// <param name="Layout">Which samples are joined, and the order of the vertices.</param>
/// <param name="Radii">m, one a vertex; a pole's is the mean of the line beside it.</param>
/// <param name="Offsets">x, y, z of each vertex in lattice steps from <see cref="Origin"/>, MOON_ME axes, each below 2^24 in size.</param>
/// <param name="Faces">Three vertex numbers a triangle (<see cref="TileMeshLayout.CreateFaces"/>).</param>
public sealed record TileMesh(TileMeshLayout Layout, double[] Radii, int[] Offsets, int[] Faces)
{
    /// <summary>From this size on an offset would not be exact as a 32-bit float, which is how POV-Ray keeps vertices.</summary>
    public const int OffsetLimit = 1 << 24;

    /// <summary>The point from which the offsets count.</summary>
    public LatticePoint Origin { get; } = OriginOf(Layout.Tile);

    /// <summary>The lattice point nearest to the tile's middle on the sphere of the reference radius; the heights play no part in it.</summary>
    public static LatticePoint OriginOf(TileId tile) => LatticePoint.Nearest(
        MoonConstants.ReferenceRadius,
        SineCosine.OfDegrees((2 * tile.SouthDegrees) + TileId.SizeDegrees, 2),
        SineCosine.OfDegrees((2 * tile.WestDegrees) + TileId.SizeDegrees, 2));

    /// <summary>A vertex's place on the whole Moon's lattice.</summary>
    /// <param name="vertex">Number of the vertex, from 0.</param>
    public LatticePoint Vertex(int vertex) => new(
        Origin.X + Offsets[3 * vertex], Origin.Y + Offsets[(3 * vertex) + 1], Origin.Z + Offsets[(3 * vertex) + 2]);
}
