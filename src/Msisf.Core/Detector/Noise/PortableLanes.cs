using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Detector.Noise;

/// <summary>
/// Elementary functions of four numbers at once, of exact operations only (+ - * / and fused multiply-add), so that every machine gets the
/// same bits.
/// </summary>
internal static class PortableLanes
{
    private const double InverseLn2 = 1.4426950408889634;
    private const double Ln2 = 0.69314718055994530942;
    private const double Ln2Upper = 6.93147180369123816490e-01; // the upper 33 bits: their product with a small whole number is exact
    private const double Ln2Lower = 1.90821492927058770002e-10;

    private const long Bias = 1023;
    private const int MantissaBits = 52;
    private const long RootOfHalf = 0x3FE6_A09E_667F_3BCD; // bits of sqrt(1/2)

    /// <summary>Bits of 2^52; with a small whole number in the last bits they are 2^52 plus that number.</summary>
    private const long WholeNumber = 0x4330_0000_0000_0000;
    private const double WholeNumberValue = 1L << MantissaBits;

    /// <summary>e^x; relative error under 1e-15.</summary>
    /// <param name="x">-700 to 700.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<double> Exp(Vector256<double> x)
    {
        Vector256<double> doublings = Vector256.Floor((x * Vector256.Create(InverseLn2)) + Vector256.Create(0.5));
        Vector256<double> rest = x - (doublings * Vector256.Create(Ln2Upper)) - (doublings * Vector256.Create(Ln2Lower));

        // Added to 2^52 and the exponent's bias, the number of doublings stands in the last bits.
        Vector256<long> exponent = (doublings + Vector256.Create(WholeNumberValue + Bias)).AsInt64() << MantissaBits;

        // Sum of x^n / n! up to n = 13: for arguments up to ln 2 / 2 the next term is below 2^-53.
        Vector256<double> upper = Polynomial(
            rest, 1.0 / 6227020800, 1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720);
        Vector256<double> sum = Next(upper, rest, 1.0 / 120);
        sum = Next(sum, rest, 1.0 / 24);
        sum = Next(sum, rest, 1.0 / 6);
        sum = Next(sum, rest, 0.5);
        sum = Next(sum, rest, 1.0);
        return Next(sum, rest, 1.0) * exponent.AsDouble();
    }

    /// <summary>Natural logarithm; absolute error under 1e-15 for numbers near 1.</summary>
    /// <param name="x">Positive, normal numbers.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<double> Log(Vector256<double> x)
    {
        // The exponent for which the mantissa lies between sqrt(1/2) and sqrt(2), plus the bias.
        Vector256<long> shifted = x.AsInt64() - Vector256.Create(RootOfHalf - (Bias << MantissaBits));
        Vector256<long> exponent = shifted >>> MantissaBits;
        Vector256<double> mantissa = (x.AsInt64() - ((exponent - Vector256.Create(Bias)) << MantissaBits)).AsDouble();
        Vector256<double> doublings = (exponent | Vector256.Create(WholeNumber)).AsDouble() - Vector256.Create(WholeNumberValue + Bias);

        // ln m = 2 artanh t, t = (m - 1) / (m + 1) up to 0.172; the sum of t^n / n for odd n up to 21 leaves less than 2^-53.
        Vector256<double> t = (mantissa - Vector256<double>.One) / (mantissa + Vector256<double>.One);
        Vector256<double> square = t * t;
        Vector256<double> upper = Polynomial(square, 1.0 / 21, 1.0 / 19, 1.0 / 17, 1.0 / 15, 1.0 / 13, 1.0 / 11, 1.0 / 9, 1.0 / 7);
        Vector256<double> sum = Next(upper, square, 1.0 / 5);
        sum = Next(sum, square, 1.0 / 3);
        sum = Next(sum, square, 1.0);
        return (doublings * Vector256.Create(Ln2)) + ((t + t) * sum);
    }

    /// <summary>A polynomial of degree 7, its highest coefficient first.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<double> Polynomial(
        Vector256<double> x, double c7, double c6, double c5, double c4, double c3, double c2, double c1, double c0)
    {
        Vector256<double> sum = Next(Vector256.Create(c7), x, c6);
        sum = Next(sum, x, c5);
        sum = Next(sum, x, c4);
        sum = Next(sum, x, c3);
        sum = Next(sum, x, c2);
        sum = Next(sum, x, c1);
        return Next(sum, x, c0);
    }

    /// <summary>One step of Horner's rule.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<double> Next(Vector256<double> sum, Vector256<double> x, double coefficient) =>
        Vector256.FusedMultiplyAdd(sum, x, Vector256.Create(coefficient));
}
