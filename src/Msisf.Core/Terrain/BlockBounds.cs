namespace Msisf.Core.Terrain;

/// <summary>Bounds of a block of the mesh, its border vertices included; floats that were rounded outwards.</summary>
/// <param name="Least">m: least vertex radius.</param>
/// <param name="Greatest">m: greatest vertex radius.</param>
/// <param name="Steepness">Tangent of an angle that no facet's slope exceeds.</param>
internal readonly record struct BlockBounds(float Least, float Greatest, float Steepness)
{
    public static BlockBounds Union(BlockBounds a, BlockBounds b) =>
        new(Math.Min(a.Least, b.Least), Math.Max(a.Greatest, b.Greatest), Math.Max(a.Steepness, b.Steepness));
}
