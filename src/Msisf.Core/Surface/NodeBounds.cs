namespace Msisf.Core.Surface;

/// <summary>Bounds of the facets of a node, including its border vertices, as floats that are rounded outwards.</summary>
/// <param name="Min">m: minimum vertex radius, not lowered by the vertex lattice.</param>
/// <param name="Max">m: maximum vertex radius, not raised by the vertex lattice.</param>
/// <param name="MaxSlope">Upper bound of the tangent of the facets' slopes.</param>
internal readonly record struct NodeBounds(float Min, float Max, float MaxSlope)
{
    /// <summary>The bounds of no facets, which leave any bounds unchanged in a union.</summary>
    public static NodeBounds Empty => new(float.PositiveInfinity, float.NegativeInfinity, 0.0F);

    /// <summary>The bounds of facets of which nothing is known but limits of their vertices' radii, m.</summary>
    public static NodeBounds Within((double Min, double Max) limits) =>
        new(MathF.BitDecrement((float)limits.Min), MathF.BitIncrement((float)limits.Max), float.PositiveInfinity);

    /// <summary>The bounds of the facets of two nodes together.</summary>
    public static NodeBounds Union(NodeBounds a, NodeBounds b) =>
        new(Math.Min(a.Min, b.Min), Math.Max(a.Max, b.Max), Math.Max(a.MaxSlope, b.MaxSlope));
}
