using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Detector.Noise;

/// <summary>
/// Elementary functions of eight numbers at once, of exact operations only (+ - * / and fused multiply-add), so that every machine gets the
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
    public static Vector512<double> Exp(Vector512<double> x)
    {
        Vector512<double> doublings = Vector512.Floor((x * Vector512.Create(InverseLn2)) + Vector512.Create(0.5));
        Vector512<double> rest = x - (doublings * Vector512.Create(Ln2Upper)) - (doublings * Vector512.Create(Ln2Lower));

        // Added to 2^52 and the exponent's bias, the number of doublings is in the last bits.
        Vector512<long> exponent = (doublings + Vector512.Create(WholeNumberValue + Bias)).AsInt64() << MantissaBits;

        // Sum of x^n / n! up to n = 13: for arguments up to ln 2 / 2 the next term is below 2^-53.
        Vector512<double> upper = Polynomial(
            rest, 1.0 / 6227020800, 1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720);
        Vector512<double> sum = Next(upper, rest, 1.0 / 120);
        sum = Next(sum, rest, 1.0 / 24);
        sum = Next(sum, rest, 1.0 / 6);
        sum = Next(sum, rest, 0.5);
        sum = Next(sum, rest, 1.0);
        return Next(sum, rest, 1.0) * exponent.AsDouble();
    }

    /// <summary>Natural logarithm; absolute error under 1e-15 for numbers near 1.</summary>
    /// <param name="x">Positive, normal numbers.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<double> Log(Vector512<double> x)
    {
        // The exponent for which the mantissa lies between sqrt(1/2) and sqrt(2), plus the bias.
        Vector512<long> shifted = x.AsInt64() - Vector512.Create(RootOfHalf - (Bias << MantissaBits));
        Vector512<long> exponent = shifted >>> MantissaBits;
        Vector512<double> mantissa = (x.AsInt64() - ((exponent - Vector512.Create(Bias)) << MantissaBits)).AsDouble();
        Vector512<double> doublings = (exponent | Vector512.Create(WholeNumber)).AsDouble() - Vector512.Create(WholeNumberValue + Bias);

        // ln m = 2 artanh t, t = (m - 1) / (m + 1) up to 0.172; the sum of t^n / n for odd n up to 21 leaves less than 2^-53.
        Vector512<double> t = (mantissa - Vector512<double>.One) / (mantissa + Vector512<double>.One);
        Vector512<double> square = t * t;
        Vector512<double> upper = Polynomial(square, 1.0 / 21, 1.0 / 19, 1.0 / 17, 1.0 / 15, 1.0 / 13, 1.0 / 11, 1.0 / 9, 1.0 / 7);
        Vector512<double> sum = Next(upper, square, 1.0 / 5);
        sum = Next(sum, square, 1.0 / 3);
        sum = Next(sum, square, 1.0);
        return (doublings * Vector512.Create(Ln2)) + ((t + t) * sum);
    }

    /// <summary>A polynomial of degree 7, its highest coefficient first.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<double> Polynomial(
        Vector512<double> x, double c7, double c6, double c5, double c4, double c3, double c2, double c1, double c0)
    {
        Vector512<double> sum = Next(Vector512.Create(c7), x, c6);
        sum = Next(sum, x, c5);
        sum = Next(sum, x, c4);
        sum = Next(sum, x, c3);
        sum = Next(sum, x, c2);
        sum = Next(sum, x, c1);
        return Next(sum, x, c0);
    }

    /// <summary>One step of Horner's rule.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Next(Vector512<double> sum, Vector512<double> x, double coefficient) =>
        Vector512.FusedMultiplyAdd(sum, x, Vector512.Create(coefficient));
}
