using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Numerics;

/// <summary>Eight vectors of three doubles. Each operation has the bits of the one of <see cref="Vector3D"/>.</summary>
/// <param name="X">First components.</param>
/// <param name="Y">Second components.</param>
/// <param name="Z">Third components.</param>
internal readonly record struct LaneVector(Vector512<double> X, Vector512<double> Y, Vector512<double> Z)
{
    /// <summary>Eight times the same vector.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static LaneVector All(Vector3D vector) =>
        new(Vector512.Create(vector.X), Vector512.Create(vector.Y), Vector512.Create(vector.Z));

    /// <summary>Reads eight vectors of a row, without range checks.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static LaneVector Load(VectorRow row, int first) => new(Load(row.X, first), Load(row.Y, first), Load(row.Z, first));

    /// <summary>Reads eight numbers, without range checks.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<double> Load(double[] values, int first) =>
        ArrayLanes.Load(values, first);

    /// <summary>Writes eight numbers, without range checks.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Store(Vector512<double> numbers, double[] values, int first) =>
        numbers.StoreTo(values, first);

    /// <summary>Writes the vectors, without range checks.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Store(VectorRow row, int first)
    {
        Store(X, row.X, first);
        Store(Y, row.Y, first);
        Store(Z, row.Z, first);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static LaneVector operator +(LaneVector u, LaneVector v) => new(u.X + v.X, u.Y + v.Y, u.Z + v.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static LaneVector operator -(LaneVector u, LaneVector v) => new(u.X - v.X, u.Y - v.Y, u.Z - v.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static LaneVector operator *(Vector512<double> factor, LaneVector v) => new(factor * v.X, factor * v.Y, factor * v.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static LaneVector operator /(LaneVector v, Vector512<double> divisor) => new(v.X / divisor, v.Y / divisor, v.Z / divisor);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<double> Dot(LaneVector u, LaneVector v) => (u.X * v.X) + (u.Y * v.Y) + (u.Z * v.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static LaneVector Cross(LaneVector u, LaneVector v) => new(
        Stable.DifferenceOfProducts(u.Y, v.Z, u.Z, v.Y),
        Stable.DifferenceOfProducts(u.Z, v.X, u.X, v.Z),
        Stable.DifferenceOfProducts(u.X, v.Y, u.Y, v.X));
}

/// <summary>
/// Vectors with one array for each component. Each array has room for seven numbers after the last vector, so that eight can be read and
/// written from any vector on.
/// </summary>
/// <param name="X">First components.</param>
/// <param name="Y">Second components.</param>
/// <param name="Z">Third components.</param>
internal sealed record VectorRow(double[] X, double[] Y, double[] Z)
{
    /// <summary>Makes room for vectors.</summary>
    /// <param name="length">Length of the arrays.</param>
    public static VectorRow OfLength(int length) => new(new double[length], new double[length], new double[length]);

    /// <summary>One vector.</summary>
    public Vector3D this[int index] => new(X[index], Y[index], Z[index]);
}
