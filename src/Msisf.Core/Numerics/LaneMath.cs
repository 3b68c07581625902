using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Numerics;

/// <summary>
/// Elementary functions of eight numbers at once. They are made of exact operations only (+ - * / sqrt, fused multiply-add), so every
/// machine and every vector width gets the same bits.
/// </summary>
internal static class LaneMath
{
    private const double Log2E = 1.4426950408889634;

    // ln 2 in two parts: the first has 32 bits, so its product with an exponent is exact.
    private const double Ln2High = 0.6931471803691238;
    private const double Ln2Low = 1.9082149292705877e-10;

    /// <summary>Adding it to a number below 2^51 leaves the rounded number in the last bits of the sum.</summary>
    private const double RoundingShift = 6755399441055744.0;

    /// <summary>Numbers below this count as this: e^x is 1e-304 then, nothing beside 1 and no subnormal number.</summary>
    private const double MinExponent = -700.0;

    /// <summary>Bits of sqrt(1/2), less an exponent of 0, so that a logical shift gives exponents counted from 1023.</summary>
    private const long MantissaShift = 0x3FE6A09E667F3BCD - (1023L << 52);

    /// <summary>Bits of 2^52; with a whole number in the last bits they are 2^52 plus that number.</summary>
    private const long WholeNumberBits = 0x4330000000000000;

    private const double Sqrt2 = 1.4142135623730951;

    /// <summary>e^x for x from minus infinity to 0; relative error under 1e-15 where the result is above 1e-304.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<double> ExpOfNegative(Vector512<double> x)
    {
        Vector512<double> held = Vector512.MaxNative(x, Vector512.Create(MinExponent));
        Vector512<double> shifted = Vector512.FusedMultiplyAdd(held, Vector512.Create(Log2E), Vector512.Create(RoundingShift));
        Vector512<double> exponent = shifted - Vector512.Create(RoundingShift);
        Vector512<double> rest = Vector512.FusedMultiplyAdd(exponent, Vector512.Create(-Ln2High), held);
        rest = Vector512.FusedMultiplyAdd(exponent, Vector512.Create(-Ln2Low), rest);
        Vector512<double> mantissa = ExpNearZero(rest);
        return (mantissa.AsInt64() + Vector512.ShiftLeft(shifted.AsInt64(), 52)).AsDouble();
    }

    /// <summary>ln((1 + a) / a) and ln((1 + b) / b) for a and b from 1e-300 to 1; relative error under 1e-15.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void LogOfOnePlusInverse(
        Vector512<double> a, Vector512<double> b, out Vector512<double> logA, out Vector512<double> logB)
    {
        Split(a, out Vector512<double> numeratorA, out Vector512<double> mantissaA, out Vector512<double> exponentA);
        Split(b, out Vector512<double> numeratorB, out Vector512<double> mantissaB, out Vector512<double> exponentB);

        // One division for both: ln(n / m) = 2 artanh((n - m) / (n + m)).
        Vector512<double> sumA = numeratorA + mantissaA;
        Vector512<double> sumB = numeratorB + mantissaB;
        Vector512<double> inverse = Vector512<double>.One / (sumA * sumB);
        logA = LogFrom((numeratorA - mantissaA) * (sumB * inverse), exponentA);
        logB = LogFrom((numeratorB - mantissaB) * (sumA * inverse), exponentB);
    }

    /// <summary>arcsin(s) / s of x = s^2 from 0 to 1/2; relative error under 1e-15.</summary>
    /// <remarks>Coefficients: tests/reference/lane_math.py; their own relative error is 1.6e-16.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<double> ArcsinOverSine(Vector512<double> x)
    {
        Vector512<double> square = x * x;
        Vector512<double> even = Vector512.Create(-2.4213345116985456);
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(-3.974232006625551));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(-1.3361380175788322));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(-0.12408231204352452));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.007444628520337835));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.01731559954431618));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.03038186720347429));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.07499999997954958));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.9999999999999999));
        Vector512<double> odd = Vector512.Create(0.7052735073244606);
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(3.9651660247789384));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(2.733327968715509));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.4950065878219168));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.03675841815436629));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.014425198539078435));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.022374245713577247));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.04464285887635292));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.166666666666762));
        return Vector512.FusedMultiplyAdd(odd, x, even);
    }

    /// <summary>Writes (1 + a) / a as n / (m 2^k), with n and m between sqrt(1/2) and sqrt(2).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Split(
        Vector512<double> a, out Vector512<double> numerator, out Vector512<double> mantissa, out Vector512<double> exponent)
    {
        Vector512<double> sum = Vector512<double>.One + a;
        Vector512<double> isLarge = Vector512.GreaterThan(sum, Vector512.Create(Sqrt2));
        numerator = Vector512.ConditionalSelect(isLarge, Vector512.Create(0.5) * sum, sum);
        Vector512<long> biased = Vector512.ShiftRightLogical(a.AsInt64() - Vector512.Create(MantissaShift), 52);
        Vector512<double> biasedNumber = (biased | Vector512.Create(WholeNumberBits)).AsDouble();
        mantissa = (a.AsInt64() - Vector512.ShiftLeft(biased - Vector512.Create(1023L), 52)).AsDouble();
        exponent = (biasedNumber - Vector512.Create(BitConverter.Int64BitsToDouble(WholeNumberBits) + 1023.0))
            - (isLarge & Vector512<double>.One);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> LogFrom(Vector512<double> s, Vector512<double> exponent)
    {
        Vector512<double> log = s * TwiceArtanhOver(s * s);
        log = Vector512.FusedMultiplyAdd(exponent, Vector512.Create(-Ln2Low), log);
        return Vector512.FusedMultiplyAdd(exponent, Vector512.Create(-Ln2High), log);
    }

    /// <summary>2 artanh(s) / s of x = s^2 from 0 to 1/9.</summary>
    /// <remarks>Coefficients: tests/reference/lane_math.py; their own relative error is 2.4e-18.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> TwiceArtanhOver(Vector512<double> x)
    {
        Vector512<double> square = x * x;
        Vector512<double> even = Vector512.Create(0.17044163562781398);
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.12110168728069218));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.1538661404230401));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.22222224080747674));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.4000000000018575));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(2.0));
        Vector512<double> odd = Vector512.Create(0.0832450651186082);
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.13300374032674625));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.18181740832504806));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.28571428545454114));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.6666666666666615));
        return Vector512.FusedMultiplyAdd(odd, x, even);
    }

    /// <summary>e^x on [-ln 2 / 2, ln 2 / 2] by its series; the first term left out is below 2e-16.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> ExpNearZero(Vector512<double> x)
    {
        Vector512<double> square = x * x;
        Vector512<double> even = Vector512.Create(1.0 / 479001600);
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(1.0 / 3628800));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(1.0 / 40320));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(1.0 / 720));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(1.0 / 24));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.5));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(1.0));
        Vector512<double> odd = Vector512.Create(1.0 / 39916800);
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(1.0 / 362880));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(1.0 / 5040));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(1.0 / 120));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(1.0 / 6));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(1.0));
        return Vector512.FusedMultiplyAdd(odd, x, even);
    }
}
