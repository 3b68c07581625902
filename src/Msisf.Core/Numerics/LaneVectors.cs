using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Numerics;

/// <summary>Four vectors, with the operations and the bits of <see cref="Vector3D"/>.</summary>
internal readonly struct LaneVectors(Vector256<double> x, Vector256<double> y, Vector256<double> z)
{
    /// <summary>First components.</summary>
    public Vector256<double> X { get; } = x;

    /// <summary>Second components.</summary>
    public Vector256<double> Y { get; } = y;

    /// <summary>Third components.</summary>
    public Vector256<double> Z { get; } = z;

    /// <summary>Four times the same vector.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static LaneVectors Of(Vector3D vector) =>
        new(Vector256.Create(vector.X), Vector256.Create(vector.Y), Vector256.Create(vector.Z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static LaneVectors operator +(LaneVectors u, LaneVectors v) => new(u.X + v.X, u.Y + v.Y, u.Z + v.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static LaneVectors operator -(LaneVectors u, LaneVectors v) => new(u.X - v.X, u.Y - v.Y, u.Z - v.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static LaneVectors operator *(Vector256<double> factor, LaneVectors v) => new(factor * v.X, factor * v.Y, factor * v.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static LaneVectors operator /(LaneVectors v, Vector256<double> divisor) =>
        new(v.X / divisor, v.Y / divisor, v.Z / divisor);

    /// <inheritdoc cref="Vector3D.Dot"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<double> Dot(LaneVectors u, LaneVectors v) => (u.X * v.X) + (u.Y * v.Y) + (u.Z * v.Z);

    /// <inheritdoc cref="Vector3D.Cross"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static LaneVectors Cross(LaneVectors u, LaneVectors v) => new(
        Stable.DifferenceOfProducts(u.Y, v.Z, u.Z, v.Y),
        Stable.DifferenceOfProducts(u.Z, v.X, u.X, v.Z),
        Stable.DifferenceOfProducts(u.X, v.Y, u.Y, v.X));
}
