namespace Msisf.Core.Numerics;

/// <summary>
/// A number as the unevaluated sum of two doubles, about 106 bits; <c>default</c> is zero. Only +, - and * of doubles are
/// used, no fused multiply-add, so that another language gets the same bits (docs/pattern-format.md).
/// </summary>
/// <param name="High">The sum, rounded to a double.</param>
/// <param name="Low">What the rounding lost.</param>
/// <remarks>
/// M. Joldes, J.-M. Muller, V. Popescu, "Tight and rigorous error bounds for basic building blocks of double-word arithmetic", ACM TOMS 44
/// (2017), algorithms 6 and 11.
/// </remarks>
internal readonly record struct DoubleDouble(double High, double Low)
{
    /// <summary>2^27 + 1: cuts a double into two halves of 26 bits.</summary>
    private const double Splitter = 134217729.0;

    /// <summary>The quotient of two whole numbers below 2^53.</summary>
    public static DoubleDouble Quotient(double numerator, double denominator)
    {
        double high = numerator / denominator;
        DoubleDouble product = Product(high, denominator);
        return new DoubleDouble(high, (numerator - product.High - product.Low) / denominator);
    }

    /// <summary>Sum, within 3 units of the 106th bit.</summary>
    public static DoubleDouble operator +(DoubleDouble a, DoubleDouble b)
    {
        DoubleDouble high = Sum(a.High, b.High);
        DoubleDouble low = Sum(a.Low, b.Low);
        DoubleDouble sum = SumOfOrdered(high.High, high.Low + low.High);
        return SumOfOrdered(sum.High, low.Low + sum.Low);
    }

    /// <summary>Product, within 5 units of the 106th bit.</summary>
    public static DoubleDouble operator *(DoubleDouble a, DoubleDouble b)
    {
        DoubleDouble product = Product(a.High, b.High);
        double cross = (a.High * b.Low) + (a.Low * b.High);
        return SumOfOrdered(product.High, product.Low + cross);
    }

    /// <summary>a + b exactly.</summary>
    private static DoubleDouble Sum(double a, double b)
    {
        double sum = a + b;
        double bRounded = sum - a;
        double aRounded = sum - bRounded;
        return new DoubleDouble(sum, (a - aRounded) + (b - bRounded));
    }

    /// <summary>a + b exactly, for |a| >= |b|.</summary>
    private static DoubleDouble SumOfOrdered(double a, double b)
    {
        double sum = a + b;
        return new DoubleDouble(sum, b - (sum - a));
    }

    /// <summary>a * b exactly (T. J. Dekker, Numer. Math. 18 (1971)).</summary>
    private static DoubleDouble Product(double a, double b)
    {
        (double aHigh, double aLow) = Split(a);
        (double bHigh, double bLow) = Split(b);
        double product = a * b;
        double error = (((aHigh * bHigh) - product) + (aHigh * bLow) + (aLow * bHigh)) + (aLow * bLow);
        return new DoubleDouble(product, error);
    }

    private static (double High, double Low) Split(double a)
    {
        double scaled = Splitter * a;
        double high = scaled - (scaled - a);
        return (high, a - high);
    }
}
