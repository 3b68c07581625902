namespace Msisf.Core.Blocks;

/// <summary>The facets of a <see cref="SceneBlock"/>, with vertices on a lattice.</summary>
/// <param name="LatticeExponent">k: the lattice has steps of 2^-k m.</param>
/// <param name="Origin">The point to which the vertices are relative, in steps, MOON_ME.</param>
/// <param name="Offsets">x, y, z of each vertex from the origin, in steps; each below <see cref="OffsetLimit"/> in size.</param>
/// <param name="Faces">Three vertex numbers a facet, counter-clockwise seen from outside.</param>
public sealed record BlockMesh(int LatticeExponent, (long X, long Y, long Z) Origin, int[] Offsets, int[] Faces)
{
    /// <summary>Steps: whole numbers below this are exact as 32-bit floats, which POV-Ray keeps.</summary>
    public const int OffsetLimit = 1 << 24;

    /// <summary>Number of vertices.</summary>
    public int VertexCount => Offsets.Length / 3;

    /// <summary>Number of facets.</summary>
    public int FaceCount => Faces.Length / 3;
}
