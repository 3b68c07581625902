namespace Msisf.Stress.Reference;

/// <summary>
/// A number of some 32 digits as the unevaluated sum of two doubles; <c>default</c> is zero. By fused multiply-add and so no relative of
/// the program's own <c>DoubleDouble</c>; held against mpmath by tests/golden/stress_pixels.tsv and tests/golden/stress.
/// </summary>
/// <param name="High">The sum, rounded to a double.</param>
/// <param name="Low">What the rounding lost.</param>
/// <remarks>M. Joldes, J.-M. Muller, V. Popescu, ACM TOMS 44 (2017), algorithms 6, 12 and 17.</remarks>
public readonly record struct DoubleWord(double High, double Low)
{
    /// <summary>Exact.</summary>
    public static implicit operator DoubleWord(double value) => new(value, 0.0);

    public static DoubleWord operator -(DoubleWord a) => new(-a.High, -a.Low);

    public static DoubleWord operator +(DoubleWord a, DoubleWord b)
    {
        DoubleWord high = ExactSum(a.High, b.High);
        DoubleWord low = ExactSum(a.Low, b.Low);
        DoubleWord sum = Renormalized(high.High, high.Low + low.High);
        return Renormalized(sum.High, low.Low + sum.Low);
    }

    public static DoubleWord operator -(DoubleWord a, DoubleWord b) => a + -b;

    public static DoubleWord operator *(DoubleWord a, DoubleWord b)
    {
        double high = a.High * b.High;
        double lost = Math.FusedMultiplyAdd(a.High, b.High, -high);
        double cross = Math.FusedMultiplyAdd(a.Low, b.High, Math.FusedMultiplyAdd(a.High, b.Low, a.Low * b.Low));
        return Renormalized(high, lost + cross);
    }

    public static DoubleWord operator /(DoubleWord a, DoubleWord b)
    {
        double first = a.High / b.High;
        DoubleWord rest = a - (b * first);
        double second = rest.High / b.High;
        double third = (rest - (b * second)).High / b.High;
        return Renormalized(first, second) + third;
    }

    public static bool operator <(DoubleWord a, DoubleWord b) => (a - b).High < 0.0;

    public static bool operator >(DoubleWord a, DoubleWord b) => b < a;

    /// <summary>The square root: one step of Newton's from the double.</summary>
    /// <param name="value">Not below 0.</param>
    public static DoubleWord Sqrt(DoubleWord value)
    {
        double root = Math.Sqrt(value.High);
        return root == 0.0 ? default : Renormalized(root, (value - ((DoubleWord)root * root)).High / (2.0 * root));
    }

    /// <summary>a + b exactly.</summary>
    private static DoubleWord ExactSum(double a, double b)
    {
        double sum = a + b;
        double part = sum - a;
        return new DoubleWord(sum, (a - (sum - part)) + (b - part));
    }

    /// <summary>a + b exactly, for |a| >= |b|.</summary>
    private static DoubleWord Renormalized(double a, double b)
    {
        double sum = a + b;
        return new DoubleWord(sum, b - (sum - a));
    }
}
