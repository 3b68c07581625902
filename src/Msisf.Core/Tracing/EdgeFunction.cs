namespace Msisf.Core.Tracing;

/// <summary>
/// Computes on which side of a ray an edge of the mesh passes. The sign is never wrong: the two facets of an edge always agree, and the
/// facets around a vertex leave no gap.
/// </summary>
/// <remarks>
/// The volume det(direction, b - origin, a - origin), twice, as direction . ((b - a) x (a + b - 2 origin)): b - a is exact for points of
/// the lattice, and swapping a and b turns the sign of each step exactly, as in Embree's robust triangle test (see T. Davidovic et al., "3D
/// rasterization: a bridge between rasterization and ray casting", Graphics Interface 2012). Where rounding could turn
/// the sign it is computed again in <see cref="DoubleDouble"/>.
/// </remarks>
internal readonly struct EdgeFunction
{
    /// <summary>Relative rounding error of the result in double: seven roundings of 2^-53, and one more as a margin.</summary>
    private const double DoubleRounding = 8.0 / (1L << 53);

    /// <summary>
    /// Relative rounding error of the result with 106 bits, with a margin of about a factor of 100; a smaller result counts as zero.
    /// </summary>
    private const double DoubleDoubleRounding = 1024.0 / (1L << 53) / (1L << 53);

    private readonly Vector3D _origin;
    private readonly Vector3D _direction;
    private readonly double _directionSize;

    public EdgeFunction(Vector3D origin, Vector3D direction)
    {
        _origin = origin;
        _direction = direction;
        _directionSize = Size(direction);
    }

    /// <summary>
    /// Above 0 if a ray that enters the ground passes on the left side of the edge from a to b as seen from outside, where it may hit the
    /// facet on that side; 0 if the ray meets the edge's line.
    /// </summary>
    /// <param name="a">m, body-fixed, on the lattice.</param>
    /// <param name="b">m, body-fixed, on the lattice.</param>
    public double Of(Vector3D a, Vector3D b)
    {
        Vector3D fromA = a - _origin;
        Vector3D fromB = b - _origin;
        Vector3D edge = b - a;
        Vector3D sum = fromA + fromB;
        double value = (_direction.X * ((edge.Y * sum.Z) - (edge.Z * sum.Y)))
            + (_direction.Y * ((edge.Z * sum.X) - (edge.X * sum.Z)))
            + (_direction.Z * ((edge.X * sum.Y) - (edge.Y * sum.X)));
        double size = _directionSize * Size(edge) * (Size(fromA) + Size(fromB));
        return Math.Abs(value) > DoubleRounding * size ? value : Precisely(a, b, edge, size);
    }

    private static double Size(Vector3D v) => Math.Abs(v.X) + Math.Abs(v.Y) + Math.Abs(v.Z);

    private static DoubleDouble Minor(double u, DoubleDouble a, double v, DoubleDouble b) =>
        (new DoubleDouble(u, 0.0) * a) + (new DoubleDouble(-v, 0.0) * b);

    /// <summary>a + b - 2 origin, one component.</summary>
    private static DoubleDouble Sum(double a, double b, double origin) =>
        new DoubleDouble(a, 0.0) + new DoubleDouble(b, 0.0) + new DoubleDouble(-2.0 * origin, 0.0);

    private double Precisely(Vector3D a, Vector3D b, Vector3D edge, double size)
    {
        DoubleDouble x = Sum(a.X, b.X, _origin.X);
        DoubleDouble y = Sum(a.Y, b.Y, _origin.Y);
        DoubleDouble z = Sum(a.Z, b.Z, _origin.Z);
        DoubleDouble value = (new DoubleDouble(_direction.X, 0.0) * Minor(edge.Y, z, edge.Z, y))
            + (new DoubleDouble(_direction.Y, 0.0) * Minor(edge.Z, x, edge.X, z))
            + (new DoubleDouble(_direction.Z, 0.0) * Minor(edge.X, y, edge.Y, x));
        return Math.Abs(value.High) > DoubleDoubleRounding * size ? value.High : 0.0;
    }
}
