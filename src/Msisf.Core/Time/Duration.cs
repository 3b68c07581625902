namespace Msisf.Core.Time;

/// <summary>A length of time in SI seconds, exact to an attosecond (1e-18 s); <c>default</c> is 0. May be negative. Immutable.</summary>
public readonly record struct Duration : IComparable<Duration>
{
    /// <summary>Attoseconds of a second.</summary>
    internal const long PerSecond = 1_000_000_000_000_000_000;

    /// <summary>s: up to here a count of attoseconds, and the sum of a thousand such counts, is far from an overflow.</summary>
    private const double Longest = 1e16;

    internal Duration(Int128 attoseconds) => Attoseconds = attoseconds;

    /// <summary>A day of 86 400 s.</summary>
    public static Duration Day { get; } = OfSeconds(86_400);

    internal Int128 Attoseconds { get; }

    /// <summary>The nearest double, s.</summary>
    public double TotalSeconds
    {
        get
        {
            long whole = (long)(Attoseconds / PerSecond);
            return whole + ((long)(Attoseconds - ((Int128)whole * PerSecond)) / (double)PerSecond);
        }
    }

    /// <summary>Whole seconds.</summary>
    public static Duration OfSeconds(long seconds) => new((Int128)seconds * PerSecond);

    /// <summary>Seconds as a sum or measurement gives them, to an attosecond or the 54th binary digit of their fraction.</summary>
    /// <exception cref="BadInputException">Not finite, or longer than 300 million years.</exception>
    public static Duration OfSeconds(double seconds)
    {
        if (!(Math.Abs(seconds) <= Longest))
        {
            throw new BadInputException(Invariant($"{seconds:R} s is no length of time that can be counted; at most 1e16 s are possible."));
        }

        double whole = Math.Truncate(seconds);
        return new(((Int128)(long)whole * PerSecond) + (long)Math.Round((seconds - whole) * PerSecond));
    }

    /// <summary>Seconds as a text writes them, to an attosecond.</summary>
    public static Duration OfSeconds(decimal seconds)
    {
        decimal whole = decimal.Truncate(seconds);
        return new(((Int128)whole * PerSecond) + (Int128)decimal.Round((seconds - whole) * PerSecond));
    }

    /// <summary>Seconds that stand for a decimal number: 0.1 is a tenth of a second, not the double next to it.</summary>
    /// <exception cref="BadInputException">Not finite, or longer than 300 million years.</exception>
    public static Duration OfDecimal(double seconds) => Math.Abs(seconds) <= Longest ? OfSeconds(DecimalOf(seconds)) : OfSeconds(seconds);

    /// <summary>A decimal number of units.</summary>
    /// <param name="count">As of <see cref="OfDecimal(double)"/>.</param>
    /// <param name="unit">s.</param>
    /// <exception cref="BadInputException">Not finite, or longer than 300 million years.</exception>
    public static Duration OfDecimal(double count, decimal unit)
    {
        double seconds = count * (double)unit;
        return Math.Abs(seconds) <= Longest ? OfSeconds(DecimalOf(count) * unit) : OfSeconds(seconds);
    }

    /// <summary>Adds.</summary>
    public static Duration operator +(Duration a, Duration b) => new(a.Attoseconds + b.Attoseconds);

    /// <summary>Subtracts.</summary>
    public static Duration operator -(Duration a, Duration b) => new(a.Attoseconds - b.Attoseconds);

    /// <summary>The same length back in time.</summary>
    public static Duration operator -(Duration a) => new(-a.Attoseconds);

    /// <summary>So many of them, exactly.</summary>
    public static Duration operator *(long count, Duration a) => new(count * a.Attoseconds);

    /// <summary>How many of another one it is.</summary>
    public static double operator /(Duration a, Duration b) => a.TotalSeconds / b.TotalSeconds;

    /// <summary>Compares.</summary>
    public static bool operator <(Duration a, Duration b) => a.Attoseconds < b.Attoseconds;

    /// <summary>Compares.</summary>
    public static bool operator >(Duration a, Duration b) => a.Attoseconds > b.Attoseconds;

    /// <summary>Compares.</summary>
    public static bool operator <=(Duration a, Duration b) => a.Attoseconds <= b.Attoseconds;

    /// <summary>Compares.</summary>
    public static bool operator >=(Duration a, Duration b) => a.Attoseconds >= b.Attoseconds;

    /// <inheritdoc/>
    public int CompareTo(Duration other) => Attoseconds.CompareTo(other.Attoseconds);

    /// <summary>The decimal number of seconds, rounded to so many decimals.</summary>
    public decimal ToDecimalSeconds(int decimals)
    {
        (Int128 whole, Int128 rest) = Int128.DivRem(Attoseconds, PerSecond);
        return (decimal)whole + decimal.Round((decimal)rest / PerSecond, decimals, MidpointRounding.AwayFromZero);
    }

    /// <summary>Rounds to the nearest multiple of a length, halves up.</summary>
    internal Duration RoundedTo(Duration unit)
    {
        Int128 half = unit.Attoseconds / 2;
        return new(FloorDivide(Attoseconds + half, unit.Attoseconds) * unit.Attoseconds);
    }

    /// <summary>The quotient rounded down, for a divisor above 0.</summary>
    internal static Int128 FloorDivide(Int128 dividend, Int128 divisor)
    {
        (Int128 quotient, Int128 rest) = Int128.DivRem(dividend, divisor);
        return rest < 0 ? quotient - 1 : quotient;
    }

    /// <summary>The shortest decimal number that a double stands for.</summary>
    internal static decimal DecimalOf(double number) =>
        decimal.Parse(number.ToString("R", CultureInfo.InvariantCulture), NumberStyles.Float, CultureInfo.InvariantCulture);
}
