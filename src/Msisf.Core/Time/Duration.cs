namespace Msisf.Core.Time;

/// <summary>A length of time in SI seconds, exact to an attosecond (1e-18 s); <c>default</c> is 0. May be negative. Immutable.</summary>
/// <remarks>
/// It is two longs and no Int128: a compiler ahead of time (ReadyToRun) leaves every method that touches an Int128 to the start of the
/// program.
/// </remarks>
public readonly record struct Duration : IComparable<Duration>
{
    /// <summary>Attoseconds of a second.</summary>
    internal const long PerSecond = 1_000_000_000_000_000_000;

    /// <summary>s: up to here the sum of some hundred lengths is far from an overflow.</summary>
    private const double Longest = 1e16;

    /// <param name="wholeSeconds">Whole seconds, rounded down.</param>
    /// <param name="attoseconds">What is left of a second: from 0 to below <see cref="PerSecond"/>.</param>
    internal Duration(long wholeSeconds, long attoseconds) => (WholeSeconds, Attoseconds) = (wholeSeconds, attoseconds);

    /// <summary>A day of 86 400 s.</summary>
    public static Duration Day { get; } = OfSeconds(86_400);

    /// <summary>Whole seconds, rounded down.</summary>
    internal long WholeSeconds { get; }

    /// <summary>Attoseconds after the whole seconds, from 0 to below a second's.</summary>
    internal long Attoseconds { get; }

    /// <summary>The nearest double, s.</summary>
    public double TotalSeconds
    {
        get
        {
            (long whole, long rest) = TowardsZero;
            return whole + (rest / (double)PerSecond);
        }
    }

    /// <summary>Whole seconds and attoseconds of one sign: near 0 a double has no digits for the sum of two signs.</summary>
    private (long Seconds, long Remainder) TowardsZero =>
        WholeSeconds < 0 && Attoseconds > 0 ? (WholeSeconds + 1, Attoseconds - PerSecond) : (WholeSeconds, Attoseconds);

    /// <summary>Whole seconds.</summary>
    public static Duration OfSeconds(long seconds) => new(seconds, 0);

    /// <summary>Seconds as a sum or measurement gives them, to an attosecond or the 54th binary digit of their fraction.</summary>
    /// <exception cref="BadInputException">Not finite, or longer than 300 million years.</exception>
    public static Duration OfSeconds(double seconds)
    {
        if (!(Math.Abs(seconds) <= Longest))
        {
            throw new BadInputException(Invariant($"{seconds:R} s is not a length of time; at most 1e16 s are possible."));
        }

        double whole = Math.Truncate(seconds);
        return Sum((long)whole, (long)Math.Round((seconds - whole) * PerSecond));
    }

    /// <summary>Seconds as a text writes them, to an attosecond.</summary>
    public static Duration OfSeconds(decimal seconds)
    {
        decimal whole = decimal.Truncate(seconds);
        return Sum((long)whole, (long)decimal.Round((seconds - whole) * PerSecond));
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
    public static Duration operator +(Duration a, Duration b) =>
        Sum(checked(a.WholeSeconds + b.WholeSeconds), a.Attoseconds + b.Attoseconds);

    /// <summary>Subtracts.</summary>
    public static Duration operator -(Duration a, Duration b) =>
        Sum(checked(a.WholeSeconds - b.WholeSeconds), a.Attoseconds - b.Attoseconds);

    /// <summary>The same length back in time.</summary>
    public static Duration operator -(Duration a) => default(Duration) - a;

    /// <summary>So many of them, exactly.</summary>
    public static Duration operator *(long count, Duration a) =>
        OfSeconds(checked(count * a.WholeSeconds)) + (a.Attoseconds == 0 ? default : Parts(count, a.Attoseconds));

    /// <summary>How many of another one it is.</summary>
    public static double operator /(Duration a, Duration b) => a.TotalSeconds / b.TotalSeconds;

    /// <summary>Compares.</summary>
    public static bool operator <(Duration a, Duration b) => a.CompareTo(b) < 0;

    /// <summary>Compares.</summary>
    public static bool operator >(Duration a, Duration b) => a.CompareTo(b) > 0;

    /// <summary>Compares.</summary>
    public static bool operator <=(Duration a, Duration b) => a.CompareTo(b) <= 0;

    /// <summary>Compares.</summary>
    public static bool operator >=(Duration a, Duration b) => a.CompareTo(b) >= 0;

    /// <inheritdoc/>
    public int CompareTo(Duration other) => WholeSeconds != other.WholeSeconds
        ? WholeSeconds.CompareTo(other.WholeSeconds)
        : Attoseconds.CompareTo(other.Attoseconds);

    /// <summary>The decimal number of seconds, rounded to so many decimals.</summary>
    public decimal ToDecimalSeconds(int decimals)
    {
        (long whole, long rest) = TowardsZero;
        return whole + decimal.Round((decimal)rest / PerSecond, decimals, MidpointRounding.AwayFromZero);
    }

    /// <summary>Rounds to the nearest multiple of a length, halves up.</summary>
    /// <param name="unit">A second, or a length of which a whole number makes one.</param>
    internal Duration RoundedTo(Duration unit)
    {
        long step = unit == OfSeconds(1) ? PerSecond : unit.Attoseconds;
        return Sum(WholeSeconds, (Attoseconds + (step / 2)) / step * step);
    }

    /// <summary>The shortest decimal number that a double stands for.</summary>
    internal static decimal DecimalOf(double number) =>
        decimal.Parse(number.ToString("R", CultureInfo.InvariantCulture), NumberStyles.Float, CultureInfo.InvariantCulture);

    /// <summary>Seconds and less than two seconds of attoseconds, of any signs.</summary>
    private static Duration Sum(long wholeSeconds, long attoseconds) => attoseconds switch
    {
        < 0 => new(wholeSeconds - 1, attoseconds + PerSecond),
        >= PerSecond => new(wholeSeconds + 1, attoseconds - PerSecond),
        _ => new(wholeSeconds, attoseconds),
    };

    private static Duration Parts(long count, long attoseconds)
    {
        (Int128 whole, Int128 rest) = Int128.DivRem((Int128)count * attoseconds, PerSecond);
        return Sum((long)whole, (long)rest);
    }
}
