namespace Msisf.Stress.Reference;

/// <summary>Sines and cosines to some 30 digits.</summary>
public static class PreciseTrigonometry
{
    /// <summary>Halvings of the angle before the series.</summary>
    private const int Halvings = 3;

    /// <summary>x^2 up to 0.01: the next term is below 1e-34.</summary>
    private const int Terms = 11;

    /// <summary>pi/2 in three parts, to 160 bits (mpmath, 60 digits).</summary>
    private const double QuarterHigh = 1.5707963267948966;
    private const double QuarterMiddle = 6.123233995736766e-17;
    private const double QuarterLow = -1.4973849048591698e-33;

    private static readonly DoubleWord[] InverseFactorials = MakeInverseFactorials();

    /// <summary>rad: one degree.</summary>
    public static DoubleWord Degree { get; } = new DoubleWord(QuarterHigh, QuarterMiddle) / 90.0;

    /// <summary>Sine and cosine of an angle.</summary>
    /// <param name="angle">rad, at most a few turns.</param>
    public static (DoubleWord Sine, DoubleWord Cosine) SinCos(DoubleWord angle)
    {
        double quarters = Math.Round(angle.High / QuarterHigh);
        DoubleWord rest = angle - (new DoubleWord(QuarterHigh, 0.0) * quarters) - (new DoubleWord(QuarterMiddle, QuarterLow) * quarters);
        (DoubleWord sine, DoubleWord cosine) = NearZero(rest);
        return ((int)quarters & 3) switch
        {
            0 => (sine, cosine),
            1 => (cosine, -sine),
            2 => (-sine, -cosine),
            _ => (-cosine, sine),
        };
    }

    /// <summary>How far an angle is from that of a vector, rad, [-pi, pi]; right to all digits when it is small.</summary>
    /// <param name="angle">rad.</param>
    /// <param name="x">Component along angle 0.</param>
    /// <param name="y">Component along angle pi/2.</param>
    public static double AngleError(DoubleWord angle, DoubleWord x, DoubleWord y)
    {
        (DoubleWord sine, DoubleWord cosine) = SinCos(angle);
        return Math.Atan2(((x * sine) - (y * cosine)).High, ((x * cosine) + (y * sine)).High);
    }

    /// <summary>Up to pi/4: the series of the eighth of the angle, then doubled three times.</summary>
    private static (DoubleWord Sine, DoubleWord Cosine) NearZero(DoubleWord angle)
    {
        double part = 1.0 / (1 << Halvings);
        DoubleWord x = new(angle.High * part, angle.Low * part);
        DoubleWord square = x * x;
        DoubleWord sine = default;
        DoubleWord versine = default; // 1 - cosine, which keeps its digits
        for (int term = Terms; term > 0; term--)
        {
            sine = InverseFactorials[(2 * term) - 1] - (sine * square);
            versine = InverseFactorials[2 * term] - (versine * square);
        }

        sine *= x;
        versine *= square;
        for (int doubling = 0; doubling < Halvings; doubling++)
        {
            (sine, versine) = ((DoubleWord)2.0 * sine * (1.0 - versine), (DoubleWord)2.0 * sine * sine);
        }

        return (sine, 1.0 - versine);
    }

    private static DoubleWord[] MakeInverseFactorials()
    {
        DoubleWord[] inverse = new DoubleWord[(2 * Terms) + 1];
        inverse[0] = 1.0;
        for (int n = 1; n < inverse.Length; n++)
        {
            inverse[n] = inverse[n - 1] / n;
        }

        return inverse;
    }
}
