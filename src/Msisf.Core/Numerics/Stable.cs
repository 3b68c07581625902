using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Numerics;

/// <summary>Sums and products that keep their digits where the plain formula cancels.</summary>
public static class Stable
{
    /// <summary>a * b - c * d within 1.5 units in the last place, for any cancellation.</summary>
    /// <remarks>Kahan's algorithm; C.-P. Jeannerod, N. Louvet, J.-M. Muller, Math. Comp. 82 (2013).</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double DifferenceOfProducts(double a, double b, double c, double d)
    {
        double cd = c * d;
        double error = Math.FusedMultiplyAdd(-c, d, cd);
        double difference = Math.FusedMultiplyAdd(a, b, -cd);
        return difference + error;
    }

    /// <summary>Eight numbers at a time, with the bits of <see cref="DifferenceOfProducts(double, double, double, double)"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static Vector512<double> DifferenceOfProducts(
        Vector512<double> a, Vector512<double> b, Vector512<double> c, Vector512<double> d)
    {
        Vector512<double> cd = c * d;
        Vector512<double> error = Vector512.FusedMultiplyAdd(-c, d, cd);
        Vector512<double> difference = Vector512.FusedMultiplyAdd(a, b, -cd);
        return difference + error;
    }

    /// <summary>Four numbers at a time, with the same bits.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static Vector256<double> DifferenceOfProducts(
        Vector256<double> a, Vector256<double> b, Vector256<double> c, Vector256<double> d)
    {
        Vector256<double> cd = c * d;
        Vector256<double> error = Vector256.FusedMultiplyAdd(-c, d, cd);
        Vector256<double> difference = Vector256.FusedMultiplyAdd(a, b, -cd);
        return difference + error;
    }

    /// <summary>The point origin + parameter * direction; each coordinate is rounded once, at the end.</summary>
    public static Vector3D PointAlong(Vector3D origin, double parameter, Vector3D direction) => new(
        Along(origin.X, parameter, direction.X), Along(origin.Y, parameter, direction.Y), Along(origin.Z, parameter, direction.Z));

    /// <summary>origin + parameter * direction with one rounding at the end: the low parts of product and sum are exact.</summary>
    public static double Along(double origin, double parameter, double direction)
    {
        double product = parameter * direction;
        double productRest = Math.FusedMultiplyAdd(parameter, direction, -product);
        double sum = origin + product;
        double added = sum - origin;
        return sum + (((origin - (sum - added)) + (product - added)) + productRest);
    }

    /// <summary>Eight numbers at a time, with the bits of <see cref="Along(double, double, double)"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static Vector512<double> Along(Vector512<double> origin, Vector512<double> parameter, Vector512<double> direction)
    {
        Vector512<double> product = parameter * direction;
        Vector512<double> productRest = Vector512.FusedMultiplyAdd(parameter, direction, -product);
        Vector512<double> sum = origin + product;
        Vector512<double> added = sum - origin;
        return sum + (((origin - (sum - added)) + (product - added)) + productRest);
    }
}
