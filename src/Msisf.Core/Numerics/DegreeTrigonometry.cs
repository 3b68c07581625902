namespace Msisf.Core.Numerics;

/// <summary>
/// Sine and cosine of a whole number of parts of a degree, rounded to the nearest double and the same on every machine and
/// in every language with IEEE doubles: <see cref="Math.Sin"/> may differ in the last bit between C libraries.
/// </summary>
/// <remarks>
/// The symmetries hold bit for bit: sin(180 - a) = sin a, cos(90 - a) = sin a, sin(-a) = -sin a; and sin 0 = 0,
/// sin 30 = 0.5, sin 90 = 1. Zero is never negative. The algorithm is written down in docs/pattern-format.md;
/// tests/reference/degree_trigonometry.py checks it against mpmath.
/// </remarks>
public static class DegreeTrigonometry
{
    private static readonly DoubleDouble RadiansPerDegree = new(0.017453292519943295, 2.9486522708701687e-19);

    // (-1)^k / (2k + 1)!: sin x = x * sum of coefficient k times x^(2k). The next term is below 2^-112 up to 45 degrees.
    private static readonly DoubleDouble[] SineSeries =
    [
        new(1.0, 0.0),
        new(-0.16666666666666666, -9.25185853854297e-18),
        new(0.008333333333333333, 1.1564823173178714e-19),
        new(-0.0001984126984126984, -1.7209558293420705e-22),
        new(2.7557319223985893e-06, -1.858393274046472e-22),
        new(-2.505210838544172e-08, 1.448814070935912e-24),
        new(1.6059043836821613e-10, 1.2585294588752098e-26),
        new(-7.647163731819816e-13, -7.03872877733453e-30),
        new(2.8114572543455206e-15, 1.6508842730861433e-31),
        new(-8.22063524662433e-18, -2.2141894119604265e-34),
        new(1.9572941063391263e-20, -1.3643503830087908e-36),
        new(-3.868170170630684e-23, 8.843177655482344e-40),
        new(6.446950284384474e-26, -1.9330404233703465e-42),
        new(-9.183689863795546e-29, -1.4303150396787322e-45),
    ];

    // (-1)^k / (2k)!: cos x = sum of coefficient k times x^(2k).
    private static readonly DoubleDouble[] CosineSeries =
    [
        new(1.0, 0.0),
        new(-0.5, 0.0),
        new(0.041666666666666664, 2.3129646346357427e-18),
        new(-0.001388888888888889, 5.300543954373577e-20),
        new(2.48015873015873e-05, 2.1511947866775882e-23),
        new(-2.755731922398589e-07, -2.3767714622250297e-23),
        new(2.08767569878681e-09, -1.20734505911326e-25),
        new(-1.1470745597729725e-11, -2.0655512752830745e-28),
        new(4.779477332387385e-14, 4.399205485834081e-31),
        new(-1.5619206968586225e-16, -1.1910679660273754e-32),
        new(4.110317623312165e-19, 1.4412973378659527e-36),
        new(-8.896791392450574e-22, 7.911402614872376e-38),
        new(1.6117375710961184e-24, -3.6846573564509766e-41),
        new(-2.4795962632247976e-27, 1.2953730964765229e-43),
        new(3.279889237069838e-30, 1.5117542744029879e-46),
    ];

    /// <summary>Sine of <paramref name="numerator"/> / <paramref name="denominator"/> degrees.</summary>
    /// <param name="numerator">Any whole number.</param>
    /// <param name="denominator">Parts of a degree, 1 to 2^40.</param>
    public static double Sin(long numerator, long denominator)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(denominator, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(denominator, 1L << 40);
        long quarter = 90 * denominator;
        long angle = numerator % (4 * quarter);
        if (angle < 0)
        {
            angle += 4 * quarter;
        }

        long rest = angle % quarter;
        return (angle / quarter) switch
        {
            0 => FirstQuarterSine(rest, denominator),
            1 => FirstQuarterSine(quarter - rest, denominator),
            2 => 0.0 - FirstQuarterSine(rest, denominator),
            _ => 0.0 - FirstQuarterSine(quarter - rest, denominator),
        };
    }

    /// <summary>Cosine of <paramref name="numerator"/> / <paramref name="denominator"/> degrees.</summary>
    /// <param name="numerator">Any whole number that leaves room for 90 degrees more.</param>
    /// <param name="denominator">Parts of a degree, 1 to 2^40.</param>
    public static double Cos(long numerator, long denominator) => Sin(numerator + (90 * denominator), denominator);

    private static double FirstQuarterSine(long angle, long denominator) => angle <= 45 * denominator
        ? (Radians(angle, denominator) * Sum(SineSeries, Radians(angle, denominator))).High
        : Sum(CosineSeries, Radians((90 * denominator) - angle, denominator)).High;

    private static DoubleDouble Radians(long angle, long denominator) =>
        DoubleDouble.Quotient(angle, denominator) * RadiansPerDegree;

    private static DoubleDouble Sum(DoubleDouble[] series, DoubleDouble x)
    {
        DoubleDouble square = x * x;
        DoubleDouble sum = series[^1];
        for (int k = series.Length - 2; k >= 0; k--)
        {
            sum = (sum * square) + series[k];
        }

        return sum;
    }
}

/// <summary>Sine and cosine of one angle; <c>default</c> is not an angle.</summary>
public readonly record struct SineCosine(double Sine, double Cosine)
{
    /// <summary>Sine and cosine of numerator / denominator degrees, by <see cref="DegreeTrigonometry"/>.</summary>
    public static SineCosine OfDegrees(long numerator, long denominator) =>
        new(DegreeTrigonometry.Sin(numerator, denominator), DegreeTrigonometry.Cos(numerator, denominator));
}
