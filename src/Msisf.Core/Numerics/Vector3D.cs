using System.Runtime.CompilerServices;

namespace Msisf.Core.Numerics;

/// <summary>
/// A vector of three doubles; <c>default</c> is the zero vector. Unit and frame are in the name of the variable that holds it.
/// </summary>
/// <param name="X">First component.</param>
/// <param name="Y">Second component.</param>
/// <param name="Z">Third component.</param>
public readonly record struct Vector3D(double X, double Y, double Z)
{
    /// <summary>(1, 0, 0).</summary>
    public static Vector3D UnitX => new(1.0, 0.0, 0.0);

    /// <summary>(0, 1, 0).</summary>
    public static Vector3D UnitY => new(0.0, 1.0, 0.0);

    /// <summary>(0, 0, 1).</summary>
    public static Vector3D UnitZ => new(0.0, 0.0, 1.0);

    /// <summary>Euclidean length, without overflow or underflow on the way.</summary>
    public double Length => double.Hypot(double.Hypot(X, Y), Z);

    /// <summary>Dot product with itself; may overflow above 1e154.</summary>
    public double LengthSquared => Dot(this, this);

    /// <summary>All three components are finite.</summary>
    public bool IsFinite => double.IsFinite(X) && double.IsFinite(Y) && double.IsFinite(Z);

    /// <summary>Sum, component by component.</summary>
    public static Vector3D operator +(Vector3D u, Vector3D v) => new(u.X + v.X, u.Y + v.Y, u.Z + v.Z);

    /// <summary>Difference, component by component.</summary>
    public static Vector3D operator -(Vector3D u, Vector3D v) => new(u.X - v.X, u.Y - v.Y, u.Z - v.Z);

    /// <summary>The opposite vector.</summary>
    public static Vector3D operator -(Vector3D v) => new(-v.X, -v.Y, -v.Z);

    /// <summary>Multiple of a vector.</summary>
    public static Vector3D operator *(double factor, Vector3D v) => new(factor * v.X, factor * v.Y, factor * v.Z);

    /// <summary>Multiple of a vector.</summary>
    public static Vector3D operator *(Vector3D v, double factor) => factor * v;

    /// <summary>Each component divided by a number.</summary>
    public static Vector3D operator /(Vector3D v, double divisor) => new(v.X / divisor, v.Y / divisor, v.Z / divisor);

    /// <summary>Dot product.</summary>
    public static double Dot(Vector3D u, Vector3D v) => (u.X * v.X) + (u.Y * v.Y) + (u.Z * v.Z);

    /// <summary>
    /// Cross product, right-handed; each component with one rounding (<see cref="Stable.DifferenceOfProducts(double, double, double,
    /// double)"/>).
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3D Cross(Vector3D u, Vector3D v) => new(
        Stable.DifferenceOfProducts(u.Y, v.Z, u.Z, v.Y),
        Stable.DifferenceOfProducts(u.Z, v.X, u.X, v.Z),
        Stable.DifferenceOfProducts(u.X, v.Y, u.Y, v.X));

    /// <summary>Angle between two vectors in rad, [0, pi], right to the last digits at 0 and pi too.</summary>
    /// <remarks>W. Kahan, "How futile are mindless assessments of roundoff in floating-point computation?", section 12.</remarks>
    public static double AngleBetween(Vector3D u, Vector3D v) => AngleBetween(u, u.Length, v, v.Length);

    /// <summary>The same, for a caller that knows the lengths.</summary>
    internal static double AngleBetween(Vector3D u, double uLength, Vector3D v, double vLength)
    {
        Vector3D a = vLength * u;
        Vector3D b = uLength * v;
        return 2.0 * Trigonometry.Atan2((a - b).Length, (a + b).Length);
    }

    /// <summary>"(1.5, -2, 0)", to the last digit, whatever the culture.</summary>
    public override string ToString() => Invariant($"({X:R}, {Y:R}, {Z:R})");

    /// <summary>The vector of length 1 in the same direction.</summary>
    /// <exception cref="InvalidOperationException">The vector is zero, or its length is not finite.</exception>
    public Vector3D Normalized()
    {
        double length = Length;
        return length > 0.0 && double.IsFinite(length)
            ? this / length
            : throw new InvalidOperationException($"The vector {this} has no direction.");
    }
}
