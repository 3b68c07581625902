namespace Msisf.Stress.Reference;

/// <summary>
/// The functions of angles that the references need, to some 30 digits; the stress test "reference" holds them against mpmath.
/// </summary>
public static class PreciseMath
{
    /// <summary>2 pi in three doubles, 160 bits (mpmath, 80 digits).</summary>
    private static readonly double[] Turn = [6.283185307179586, 2.4492935982947064e-16, -5.989539619436679e-33];

    /// <summary>1 / n!; the last one leaves out terms below 1e-33 at a quarter of pi.</summary>
    private static readonly DoubleWord[] InverseFactorials = MakeInverseFactorials(30);

    /// <summary>rad: one degree.</summary>
    public static DoubleWord Degree { get; } = new DoubleWord(Turn[0], Turn[1]) / 360.0;

    /// <summary>The same direction within half a turn of 0, for up to 2^40 turns.</summary>
    public static DoubleWord ToHalfTurn(DoubleWord angle) => Less(angle, Math.Round(angle.High / Turn[0]), 1.0);

    /// <summary>Sine and cosine.</summary>
    /// <param name="angle">rad, at most a few turns.</param>
    public static (DoubleWord Sin, DoubleWord Cos) SinCos(DoubleWord angle)
    {
        int quarters = (int)Math.Round(angle.High / (Turn[0] / 4.0));
        DoubleWord rest = Less(angle, quarters, 1.0 / 4.0);
        DoubleWord sin = Series(rest, 1);
        DoubleWord cos = Series(rest, 0);
        return (quarters & 3) switch
        {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        };
    }

    /// <summary>x - sin x, with all digits for small x too.</summary>
    public static DoubleWord MinusSine(DoubleWord x) => Math.Abs(x.High) < Turn[0] / 8.0 ? -Series(x, 3) : x - SinCos(x).Sin;

    /// <summary>1 - cos x, with all digits for small x too.</summary>
    public static DoubleWord MinusCosine(DoubleWord x)
    {
        DoubleWord sinHalf = SinCos(0.5 * x).Sin;
        return 2.0 * sinHalf * sinHalf;
    }

    /// <summary>How far an angle is from that of a vector, rad, [-pi, pi]; right to all digits when it is small.</summary>
    /// <param name="angle">rad.</param>
    /// <param name="x">Component along angle 0.</param>
    /// <param name="y">Component along angle pi/2.</param>
    public static double AngleError(DoubleWord angle, DoubleWord x, DoubleWord y)
    {
        (DoubleWord sin, DoubleWord cos) = SinCos(angle);
        return Math.Atan2(((x * sin) - (y * cos)).High, ((x * cos) + (y * sin)).High);
    }

    /// <summary>An angle less a number of parts of a turn.</summary>
    /// <param name="angle">rad.</param>
    /// <param name="count">Whole.</param>
    /// <param name="part">Of a turn, a power of 2.</param>
    private static DoubleWord Less(DoubleWord angle, double count, double part) =>
        angle - ((DoubleWord)count * (Turn[0] * part)) - ((DoubleWord)count * (Turn[1] * part)) - (count * (Turn[2] * part));

    /// <summary>The Taylor series of the sine or cosine from the term x^first on, |x| up to a quarter of pi.</summary>
    private static DoubleWord Series(DoubleWord x, int first)
    {
        DoubleWord square = x * x;
        DoubleWord sum = default;
        int last = InverseFactorials.Length - 2 + (first & 1);
        for (int n = last; n >= first; n -= 2)
        {
            bool isMinus = (n & 2) != 0;
            sum = (sum * square) + (isMinus ? -InverseFactorials[n] : InverseFactorials[n]);
        }

        DoubleWord power = (first & 1) != 0 ? x : 1.0;
        return first >= 2 ? sum * power * square : sum * power;
    }

    private static DoubleWord[] MakeInverseFactorials(int count)
    {
        DoubleWord[] inverses = new DoubleWord[count];
        inverses[0] = 1.0;
        for (int n = 1; n < count; n++)
        {
            inverses[n] = inverses[n - 1] / n;
        }

        return inverses;
    }
}
