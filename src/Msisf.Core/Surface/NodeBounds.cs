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

/// <summary>Bounding volumes of the facets of a node: a cap of directions and a box.</summary>
/// <param name="Up">Direction of the node's middle, body-fixed, length 1.</param>
/// <param name="CapRadius">Angle around <paramref name="Up"/> that contains the directions of the facets.</param>
/// <param name="Box">Box that contains the facets, body-fixed; its axes point up and along the grid at the middle of the node.</param>
internal readonly record struct NodeBox(Vector3D Up, SineCosine CapRadius, OrientedBox Box);

/// <summary>Neighbouring nodes of one level.</summary>
/// <param name="FirstRow">Northernmost row.</param>
/// <param name="EndRow">One past the southernmost row.</param>
/// <param name="FirstColumn">Westernmost column.</param>
/// <param name="EndColumn">One past the easternmost column.</param>
internal readonly record struct NodeRange(int FirstRow, int EndRow, int FirstColumn, int EndColumn);

/// <summary>All directions within an angle of a centre direction.</summary>
/// <param name="Centre">Unit vector, body-fixed.</param>
/// <param name="CosRadius">Cosine of the angle.</param>
/// <param name="SinRadius">Sine of the angle, which is below pi.</param>
internal readonly record struct SphericalCap(Vector3D Centre, double CosRadius, double SinRadius);
