using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Numerics;

/// <summary>Lengths of vectors, eight at a time, with the bits of <see cref="Vector3D.Length"/> and <see cref="double.Hypot"/>.</summary>
internal static class LaneHypot
{
    /// <summary>The larger number lies between these: nothing overflows or loses digits; others are left to the library.</summary>
    private const double MaxOrdinary = 1e150;

    private const double MinOrdinary = 1e-130;

    /// <summary>Powers of two between two numbers beyond which the smaller one does not count, as in the library.</summary>
    private const long MaxExponents = 54;

    /// <summary>Keeps the upper half of a significand, so that its square is exact.</summary>
    private const long HeadMask = unchecked((long)0xFFFF_FFFF_F800_0000);

    /// <summary>Finds the lengths of a row's vectors.</summary>
    /// <param name="lengths">Receives their lengths, and up to seven numbers after them.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // otherwise it would run with unoptimised vectors at first
    public static void Lengths(VectorRow vectors, int count, double[] lengths)
    {
        for (int i = 0; i < count; i += Vector512<double>.Count)
        {
            LaneVector eight = LaneVector.Load(vectors, i);
            LaneVector.Store(Of(Of(eight.X, eight.Y), eight.Z), lengths, i);
        }
    }

    /// <summary>Finds the distances of a row's points from the third axis.</summary>
    /// <param name="distances">Receives their distances, and up to seven numbers after them.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static void AxisDistances(VectorRow vectors, int count, double[] distances)
    {
        for (int i = 0; i < count; i += Vector512<double>.Count)
        {
            LaneVector.Store(Of(LaneVector.Load(vectors.X, i), LaneVector.Load(vectors.Y, i)), distances, i);
        }
    }

    /// <summary>The square root of the sum of two squares.</summary>
    /// <remarks>
    /// The algorithm of <see cref="double.Hypot"/>, which is that of AMD's AOCL-LibM: the larger square with twice the digits.
    /// </remarks>
    public static Vector512<double> Of(Vector512<double> x, Vector512<double> y)
    {
        Vector512<double> a = Vector512.Abs(x);
        Vector512<double> b = Vector512.Abs(y);
        Vector512<double> max = Vector512.ConditionalSelect(Vector512.LessThan(a, b), b, a);
        Vector512<double> min = Vector512.ConditionalSelect(Vector512.LessThan(a, b), a, b);
        Vector512<double> isOrdinary =
            Vector512.LessThan(max, Vector512.Create(MaxOrdinary)) & Vector512.GreaterThan(max, Vector512.Create(MinOrdinary));
        if (isOrdinary.ExtractMostSignificantBits() != 0xff)
        {
            return OfAny(x, y);
        }

        Vector512<long> exponents = Vector512.ShiftRightLogical(max.AsInt64(), 52) - Vector512.ShiftRightLogical(min.AsInt64(), 52);
        Vector512<double> square = max * max;
        Vector512<double> otherSquare = min * min;
        Vector512<double> sum = square + otherSquare;
        Vector512<double> rest = (square - sum) + otherSquare + RestOfSquare(max, square);
        Vector512<double> isSameExponent = Vector512.Equals(exponents, Vector512<long>.Zero).AsDouble();
        rest = Vector512.ConditionalSelect(isSameExponent, rest + RestOfSquare(min, otherSquare), rest);
        return Vector512.ConditionalSelect(
            Vector512.GreaterThan(exponents, Vector512.Create(MaxExponents)).AsDouble(), max + min, Vector512.Sqrt(sum + rest));
    }

    /// <summary>What rounding took from a square.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> RestOfSquare(Vector512<double> number, Vector512<double> square)
    {
        Vector512<double> head = (number.AsInt64() & Vector512.Create(HeadMask)).AsDouble();
        Vector512<double> tail = number - head;
        return ((head * head) - square) + (Vector512.Create(2.0) * head * tail) + (tail * tail);
    }

    private static Vector512<double> OfAny(Vector512<double> x, Vector512<double> y)
    {
        Vector512<double> lengths = x;
        for (int lane = 0; lane < Vector512<double>.Count; lane++)
        {
            lengths = lengths.WithElement(lane, double.Hypot(x[lane], y[lane]));
        }

        return lengths;
    }
}
