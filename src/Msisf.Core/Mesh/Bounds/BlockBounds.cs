namespace Msisf.Core.Mesh.Bounds;

/// <summary>Bounds of a block of the mesh, its border vertices included; floats that were rounded outwards.</summary>
/// <param name="Min">m: minimum vertex radius.</param>
/// <param name="Max">m: maximum vertex radius.</param>
/// <param name="MaxSlope">Tangent of an angle that no facet's slope exceeds.</param>
internal readonly record struct BlockBounds(float Min, float Max, float MaxSlope)
{
    public static BlockBounds Union(BlockBounds a, BlockBounds b) =>
        new(Math.Min(a.Min, b.Min), Math.Max(a.Max, b.Max), Math.Max(a.MaxSlope, b.MaxSlope));
}
