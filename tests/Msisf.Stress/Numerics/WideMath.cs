using Msisf.Core.Numerics;

namespace Msisf.Stress.Numerics;

/// <summary>
/// The functions that the references need, to about 100 bits; the stress test "reference" holds them against mpmath. They share
/// nothing with the program but sum and product.
/// </summary>
internal static class WideMath
{
    /// <summary>2 pi in three doubles, 160 bits (mpmath, 80 digits).</summary>
    private static readonly double[] Turn = [6.283185307179586, 2.4492935982947064e-16, -5.989539619436679e-33];

    /// <summary>1 / n!; the last one leaves out terms below 1e-33 at a quarter of pi.</summary>
    private static readonly DoubleDouble[] InverseFactorials = MakeInverseFactorials(30);

    /// <summary>2 pi.</summary>
    public static DoubleDouble FullTurn { get; } = new(Turn[0], Turn[1]);

    public static DoubleDouble Of(double value) => new(value, 0.0);

    public static DoubleDouble Negate(DoubleDouble a) => new(-a.High, -a.Low);

    public static DoubleDouble Subtract(DoubleDouble a, DoubleDouble b) => a + Negate(b);

    public static DoubleDouble Multiply(double a, DoubleDouble b) => Of(a) * b;

    /// <summary>Long division with digits of 53 bits.</summary>
    public static DoubleDouble Divide(DoubleDouble a, DoubleDouble b)
    {
        double first = a.High / b.High;
        DoubleDouble left = Subtract(a, Multiply(first, b));
        double second = left.High / b.High;
        left = Subtract(left, Multiply(second, b));
        return Of(first) + Of(second) + Of(left.High / b.High);
    }

    /// <summary>Of a number above 0: one step of Heron's method.</summary>
    public static DoubleDouble SquareRoot(DoubleDouble a)
    {
        double root = Math.Sqrt(a.High);
        return Of(root) + Of(Subtract(a, Of(root) * Of(root)).High / (2.0 * root));
    }

    /// <summary>The same direction within half a turn of 0, for up to 2^40 turns.</summary>
    public static DoubleDouble ToHalfTurn(DoubleDouble angle)
    {
        double turns = Math.Round(angle.High / Turn[0]);
        DoubleDouble rest = Subtract(angle, Of(turns) * Of(Turn[0]));
        return Subtract(Subtract(rest, Of(turns) * Of(Turn[1])), Of(turns * Turn[2]));
    }

    /// <summary>Sine and cosine, for angles of a few turns.</summary>
    public static (DoubleDouble Sin, DoubleDouble Cos) SinCos(DoubleDouble angle)
    {
        int quarters = (int)Math.Round(angle.High / (Turn[0] / 4.0));
        DoubleDouble rest = Subtract(angle, Of(quarters) * Of(Turn[0] / 4.0));
        rest = Subtract(Subtract(rest, Of(quarters) * Of(Turn[1] / 4.0)), Of(quarters * (Turn[2] / 4.0)));
        DoubleDouble sin = Series(rest, 1);
        DoubleDouble cos = Series(rest, 0);
        return (quarters & 3) switch
        {
            0 => (sin, cos),
            1 => (cos, Negate(sin)),
            2 => (Negate(sin), Negate(cos)),
            _ => (Negate(cos), sin),
        };
    }

    /// <summary>x - sin x, with all digits for small x too.</summary>
    public static DoubleDouble MinusSine(DoubleDouble x) =>
        Math.Abs(x.High) < Turn[0] / 8.0 ? Negate(Series(x, 3)) : Subtract(x, SinCos(x).Sin);

    /// <summary>1 - cos x, with all digits for small x too.</summary>
    public static DoubleDouble MinusCosine(DoubleDouble x)
    {
        DoubleDouble sinHalf = SinCos(Multiply(0.5, x)).Sin;
        return Multiply(2.0, sinHalf * sinHalf);
    }

    /// <summary>The Taylor series of the sine or cosine from the term x^first on, |x| up to a quarter of pi.</summary>
    private static DoubleDouble Series(DoubleDouble x, int first)
    {
        DoubleDouble square = x * x;
        DoubleDouble sum = default;
        int last = InverseFactorials.Length - 2 + (first & 1);
        for (int n = last; n >= first; n -= 2)
        {
            bool isMinus = (n & 2) != 0;
            sum = (sum * square) + (isMinus ? Negate(InverseFactorials[n]) : InverseFactorials[n]);
        }

        DoubleDouble power = (first & 1) != 0 ? x : Of(1.0);
        return first >= 2 ? sum * power * square : sum * power;
    }

    private static DoubleDouble[] MakeInverseFactorials(int count)
    {
        DoubleDouble[] inverses = new DoubleDouble[count];
        inverses[0] = Of(1.0);
        for (int n = 1; n < count; n++)
        {
            inverses[n] = Divide(inverses[n - 1], Of(n));
        }

        return inverses;
    }
}
