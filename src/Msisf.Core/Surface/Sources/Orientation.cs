namespace Msisf.Core.Surface.Sources;

/// <summary>Tells exactly in which order three points of the surface lie as seen from outside.</summary>
internal static class Orientation
{
    /// <summary>Relative rounding error of the determinant in doubles, whose differences and products of differences are exact.</summary>
    private const double Rounding = 8.0 / (1L << 53);

    /// <summary>Steps a metre of the finest lattice that any model has (2^-16 m); all vertices are whole numbers of them.</summary>
    private const double Steps = 1 << 16;

    /// <summary>
    /// Sign of det(a, b, c): above 0 if they are counter-clockwise as seen from outside, 0 if the plane through two of them and the Moon's
    /// centre holds the third.
    /// </summary>
    /// <param name="a">m, body-fixed, on a lattice.</param>
    /// <param name="b">The same.</param>
    /// <param name="c">The same.</param>
    public static int Of(Vector3D a, Vector3D b, Vector3D c)
    {
        Vector3D normal = Vector3D.Cross(b - a, c - a);
        double value = Vector3D.Dot(a, normal);
        double size = Math.Abs(a.X * normal.X) + Math.Abs(a.Y * normal.Y) + Math.Abs(a.Z * normal.Z);
        Vector3D ab = b - a;
        Vector3D ac = c - a;
        double products = (Size(ab) * Size(ac)) * Size(a);
        return Math.Abs(value) > Rounding * (size + products) ? Math.Sign(value) : Exactly(a, b, c);
    }

    private static double Size(Vector3D v) => Math.Abs(v.X) + Math.Abs(v.Y) + Math.Abs(v.Z);

    private static int Exactly(Vector3D a, Vector3D b, Vector3D c)
    {
        (Int128 ax, Int128 ay, Int128 az) = (Whole(a.X), Whole(a.Y), Whole(a.Z));
        (Int128 bx, Int128 by, Int128 bz) = (Whole(b.X), Whole(b.Y), Whole(b.Z));
        (Int128 cx, Int128 cy, Int128 cz) = (Whole(c.X), Whole(c.Y), Whole(c.Z));

        // Numbers below 2^37: minors below 2^75, the sum of their products below 2^114.
        return Int128.Sign((ax * ((by * cz) - (bz * cy))) + (ay * ((bz * cx) - (bx * cz))) + (az * ((bx * cy) - (by * cx))));
    }

    private static long Whole(double metres) => (long)(metres * Steps);
}
