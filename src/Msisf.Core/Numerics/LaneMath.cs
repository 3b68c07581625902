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

    /// <summary>Bits of 2^52; with a whole number in the last bits they are 2^52 plus that number.</summary>
    private const long WholeNumberBits = 0x4330000000000000;

    /// <summary>Half a step of the exponent's bits.</summary>
    private const long HalfExponent = 1L << 51;

    /// <summary>Less half the bits of x they are those of 1 / sqrt(x), to 3.5 % (C. Lomont, Fast inverse square root, 2003).</summary>
    private const long InverseSqrtBits = 0x5FE6EB50C7B537A9;

    /// <summary>e^x - 1 for x from minus infinity to 0; relative error under 2e-15, also beside 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<double> ExpMinusOne(Vector512<double> x)
    {
        Vector512<double> held = Vector512.MaxNative(x, Vector512.Create(MinExponent));
        Vector512<double> shifted = Vector512.FusedMultiplyAdd(held, Vector512.Create(Log2E), Vector512.Create(RoundingShift));
        Vector512<double> exponent = shifted - Vector512.Create(RoundingShift);
        Vector512<double> rest = Vector512.FusedMultiplyAdd(exponent, Vector512.Create(-Ln2High), held);
        rest = Vector512.FusedMultiplyAdd(exponent, Vector512.Create(-Ln2Low), rest);
        Vector512<double> ofRest = Vector512.FusedMultiplyAdd(rest * rest, ExpSeriesRest(rest), rest);
        Vector512<double> power = (Vector512<double>.One.AsInt64() + Vector512.ShiftLeft(shifted.AsInt64(), 52)).AsDouble();
        return Vector512.FusedMultiplyAdd(power, ofRest, power - Vector512<double>.One);
    }

    /// <summary>1 / sqrt(x) for x from 1e-300 to 1e300; relative error under 2e-15.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<double> InverseSqrt(Vector512<double> x)
    {
        Vector512<double> y = (Vector512.Create(InverseSqrtBits) - Vector512.ShiftRightLogical(x.AsInt64(), 1)).AsDouble();

        // y (1 + e)^(-1/2) with e = x y^2 - 1, which is below 0.07 at first and below 2e-5 then.
        Vector512<double> e = Vector512.FusedMultiplyAdd(x * y, y, Vector512.Create(-1.0));
        Vector512<double> series = Vector512.FusedMultiplyAdd(e, Vector512.Create(-5.0 / 16.0), Vector512.Create(3.0 / 8.0));
        series = Vector512.FusedMultiplyAdd(series, e, Vector512.Create(-0.5));
        y = Vector512.FusedMultiplyAdd(y * e, series, y);
        e = Vector512.FusedMultiplyAdd(x * y, y, Vector512.Create(-1.0));
        series = Vector512.FusedMultiplyAdd(e, Vector512.Create(3.0 / 8.0), Vector512.Create(-0.5));
        return Vector512.FusedMultiplyAdd(y * e, series, y);
    }

    /// <summary>Replaces numbers by <see cref="InverseSqrt(Vector512{double})"/> of them.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be computed with unoptimised vectors
    public static void InverseSqrt(Span<Vector512<double>> values)
    {
        for (int i = 0; i < values.Length; i++)
        {
            values[i] = InverseSqrt(values[i]);
        }
    }

    /// <summary>Replaces numbers by <see cref="ExpMinusOne(Vector512{double})"/> of them.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static void ExpMinusOne(Span<Vector512<double>> values)
    {
        for (int i = 0; i < values.Length; i++)
        {
            values[i] = ExpMinusOne(values[i]);
        }
    }

    /// <summary>
    /// Writes (1 + a) / a and (1 + b) / b as 2^k (1 + s) / (1 - s), for <see cref="LogOf"/>; a and b from 1e-300 to 1.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void SplitOnePlusInverse(
        Vector512<double> a, Vector512<double> b, out Vector512<double> exponentA, out Vector512<double> exponentB,
        out Vector512<double> sA, out Vector512<double> sB)
    {
        Split(a, out Vector512<double> numeratorA, out Vector512<double> mantissaA, out exponentA);
        Split(b, out Vector512<double> numeratorB, out Vector512<double> mantissaB, out exponentB);

        // One division for both: ln(n / m) = 2 artanh((n - m) / (n + m)).
        Vector512<double> sumA = numeratorA + mantissaA;
        Vector512<double> sumB = numeratorB + mantissaB;
        Vector512<double> inverse = Vector512<double>.One / (sumA * sumB);
        sA = (numeratorA - mantissaA) * (sumB * inverse);
        sB = (numeratorB - mantissaB) * (sumA * inverse);
    }

    /// <summary>The natural logarithm of what <see cref="SplitOnePlusInverse"/> wrote; relative error under 1e-15.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<double> LogOf(Vector512<double> exponent, Vector512<double> s)
    {
        Vector512<double> log = s * TwiceArtanhOver(s * s);
        log = Vector512.FusedMultiplyAdd(exponent, Vector512.Create(Ln2Low), log);
        return Vector512.FusedMultiplyAdd(exponent, Vector512.Create(Ln2High), log);
    }

    /// <summary>arcsin(s) / (s sqrt(1 - s^2)) of x = s^2 from 0 to 1/2; relative error under 1e-14.</summary>
    /// <remarks>Coefficients: tests/reference/lane_math.py; their own relative error is 7.3e-15.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<double> ArcsinOverSineCosine(Vector512<double> x)
    {
        Vector512<double> square = x * x;
        Vector512<double> even = Vector512.Create(-184.94940831731762);
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(-307.0988630422838));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(-104.12120171400481));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(-10.071371328258081));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(-0.022007468616265572));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.3380771356205644));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.4063431400782681));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.5333333317261315));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.9999999999999942));
        Vector512<double> odd = Vector512.Create(53.162629498686755);
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(304.62238702232503));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(211.6646838644962));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(38.25880142525491));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(2.394602021792187));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.3543384070528501));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.36957215748462824));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.45714299334129277));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.6666666666741589));
        return Vector512.FusedMultiplyAdd(odd, x, even);
    }

    /// <summary>Writes (1 + a) / a as 2^k n / m, with n / m between 2^-0.59 and 2^0.59.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Split(
        Vector512<double> a, out Vector512<double> numerator, out Vector512<double> mantissa, out Vector512<double> exponent)
    {
        // The bits of a number are its logarithm to base 2, linear between the powers: by up to 0.086 too small.
        numerator = Vector512<double>.One + a;
        Vector512<long> difference = numerator.AsInt64() - a.AsInt64();
        Vector512<long> whole = Vector512.ShiftRightLogical(difference + Vector512.Create(HalfExponent), 52);
        mantissa = (a.AsInt64() + Vector512.ShiftLeft(whole, 52)).AsDouble();
        exponent = (whole | Vector512.Create(WholeNumberBits)).AsDouble()
            - Vector512.Create(BitConverter.Int64BitsToDouble(WholeNumberBits));
    }

    /// <summary>2 artanh(s) / s of x = s^2 from 0 to 0.0403.</summary>
    /// <remarks>Coefficients: tests/reference/lane_math.py; their own relative error is 2.9e-17.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> TwiceArtanhOver(Vector512<double> x)
    {
        Vector512<double> square = x * x;
        Vector512<double> even = Vector512.Create(0.15245163774292927);
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.22222130456872752));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.399999999952224));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(2.0));
        Vector512<double> odd = Vector512.Create(0.15403791448885612);
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.18186638534914787));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.28571429517186914));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.6666666666667584));
        return Vector512.FusedMultiplyAdd(odd, x, even);
    }

    /// <summary>(e^x - 1 - x) / x^2 on [-ln 2 / 2, ln 2 / 2].</summary>
    /// <remarks>Coefficients: tests/reference/lane_math.py; their own error is 7.3e-15.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> ExpSeriesRest(Vector512<double> x)
    {
        Vector512<double> square = x * x;
        Vector512<double> even = Vector512.Create(2.761379555451986e-07);
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(2.4801536409064087e-05));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.0013888888905871347));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.041666666666651364));
        even = Vector512.FusedMultiplyAdd(even, square, Vector512.Create(0.5));
        Vector512<double> odd = Vector512.Create(2.7625102005388108e-06);
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.0001984120875699232));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.008333333353717156));
        odd = Vector512.FusedMultiplyAdd(odd, square, Vector512.Create(0.16666666666648303));
        return Vector512.FusedMultiplyAdd(odd, x, even);
    }
}
