namespace Msisf.Core.Time;

/// <summary>
/// A date of the calendar and a time of day, exact to an attosecond; UTC, unless another system is named. It names a moment only together
/// with a <see cref="TimeScale"/>. <c>default</c> is 1858-11-17T00:00:00, the zero of MJD.
/// </summary>
/// <remarks>
/// An MJD is read as the decimal number that it prints: 55197.1 is 02:24:00. It can't name a leap second (23:59:60), which prints as the
/// last MJD of its day.
/// </remarks>
public readonly record struct CalendarTime : IComparable<CalendarTime>
{
    /// <summary>MJD of 0001-01-01, the first day that a calendar date can name.</summary>
    private const int FirstDay = -678575;

    /// <summary>MJD of 10000-01-01, the first day that it can't.</summary>
    private const int EndOfDays = 2973484;

    /// <summary>Decimals of a second at most, if a text is not asked for others.</summary>
    private const int Decimals = 9;

    /// <summary>Decimals of a second in attoseconds.</summary>
    private const int AllDecimals = 18;

    private const int SecondsPerDay = 86_400;

    private static readonly DateTime DayZero = new(1858, 11, 17, 0, 0, 0, DateTimeKind.Utc);

    /// <summary>Takes a date and a time of day.</summary>
    /// <param name="dayNumber">Days since 1858-11-17.</param>
    /// <param name="sinceMidnight">A time before 00:00:00, or past 24:00:00 and the leap second after it, is one of another day.</param>
    /// <exception cref="BadInputException">Outside the years 1 to 9999.</exception>
    public CalendarTime(int dayNumber, Duration sinceMidnight)
        : this(dayNumber, sinceMidnight, mayBeLeapSecond: false)
    {
    }

    private CalendarTime(long dayNumber, Duration sinceMidnight, bool mayBeLeapSecond)
    {
        bool isLeapSecond = mayBeLeapSecond && sinceMidnight >= Duration.Day && sinceMidnight < Duration.Day + Duration.OfSeconds(1);
        (long days, long rest) = isLeapSecond ? (0L, 0L) : Math.DivRem(sinceMidnight.WholeSeconds, SecondsPerDay);
        days -= rest < 0 ? 1 : 0;
        long day = dayNumber + days;
        if (day < FirstDay || day >= EndOfDays)
        {
            throw new BadInputException("The time is outside the years 1 to 9999, which a date of the calendar can name.");
        }

        DayNumber = (int)day;
        SinceMidnight = sinceMidnight - (days * Duration.Day);
    }

    /// <summary>0001-01-01T00:00:00, the first time that a date of the calendar can name.</summary>
    public static CalendarTime First { get; } = new(FirstDay, default);

    /// <summary>9999-12-31T23:59:59.</summary>
    public static CalendarTime LastSecond { get; } = new(EndOfDays - 1, Duration.Day - Duration.OfSeconds(1));

    /// <summary>Days since 1858-11-17.</summary>
    public int DayNumber { get; }

    /// <summary>Since the day began: from 0 to below 86 400 s; more in a leap second.</summary>
    public Duration SinceMidnight { get; }

    /// <summary>Whether it is in a leap second, 23:59:60.</summary>
    public bool IsLeapSecond => SinceMidnight >= Duration.Day;

    /// <summary>The nearest MJD; in a leap second the last one of the day. A double holds today's dates to 0.6 microseconds.</summary>
    public double Mjd
    {
        get
        {
            if (IsLeapSecond)
            {
                return Math.BitDecrement(DayNumber + 1.0);
            }

            // The part of the day to twice the digits of a double, so the sum is rounded once. It can't be a tie: half a step of a double
            // is 675 s over a power of 2 of at least 30, which has more decimals than attoseconds.
            double seconds = SinceMidnight.WholeSeconds;
            double part = seconds / SecondsPerDay;
            double below = SinceMidnight.Attoseconds / (double)Duration.PerSecond;
            double rest = (Math.FusedMultiplyAdd(-part, SecondsPerDay, seconds) + below) / SecondsPerDay;
            double sum = DayNumber + part;
            return sum + (part - (sum - DayNumber) + rest);
        }
    }

    /// <summary>A time within a leap second.</summary>
    /// <param name="dayNumber">The day that it ends.</param>
    /// <param name="since">Since its begin, from 0 to below 1 s.</param>
    public static CalendarTime InLeapSecond(int dayNumber, Duration since) =>
        new(dayNumber, Duration.Day + since, mayBeLeapSecond: true);

    /// <summary>The time of an MJD.</summary>
    /// <param name="days">Days since 1858-11-17T00:00:00; the shortest decimal number that the double stands for is meant.</param>
    /// <exception cref="BadInputException">Not finite, or outside the years 1 to 9999.</exception>
    public static CalendarTime OfMjd(double days)
    {
        if (!(days >= FirstDay && days < EndOfDays))
        {
            throw new BadInputException(Invariant(
                $"The MJD {days:R} is not a date; a number from {FirstDay} (year 1) to below {EndOfDays} (year 10000) is needed."));
        }

        decimal number = Duration.DecimalOf(days);
        decimal day = decimal.Floor(number);
        return new CalendarTime((int)day, Duration.OfSeconds((number - day) * 86_400m));
    }

    /// <summary>A date of the calendar and the seconds since its day began.</summary>
    public static CalendarTime Of(DateOnly date, decimal secondsOfDay) =>
        new(date.DayNumber - DateOnly.FromDateTime(DayZero).DayNumber, Duration.OfSeconds(secondsOfDay));

    /// <summary>A time on the clock some time later, each day counted with 86 400 s. A leap second counts as the one after it.</summary>
    public static CalendarTime operator +(CalendarTime time, Duration later) => new(time.DayNumber, time.SinceMidnight + later);

    /// <summary>What the clock has moved on, each day counted with 86 400 s.</summary>
    public static Duration operator -(CalendarTime a, CalendarTime b) =>
        (((long)a.DayNumber - b.DayNumber) * Duration.Day) + (a.SinceMidnight - b.SinceMidnight);

    /// <summary>Compares.</summary>
    public static bool operator <(CalendarTime a, CalendarTime b) => a.CompareTo(b) < 0;

    /// <summary>Compares.</summary>
    public static bool operator >(CalendarTime a, CalendarTime b) => a.CompareTo(b) > 0;

    /// <summary>Compares.</summary>
    public static bool operator <=(CalendarTime a, CalendarTime b) => a.CompareTo(b) <= 0;

    /// <summary>Compares.</summary>
    public static bool operator >=(CalendarTime a, CalendarTime b) => a.CompareTo(b) >= 0;

    /// <inheritdoc/>
    public int CompareTo(CalendarTime other) => DayNumber != other.DayNumber
        ? DayNumber.CompareTo(other.DayNumber)
        : SinceMidnight.CompareTo(other.SinceMidnight);

    /// <summary>The nearest multiple of a part of the day; no part of a leap second becomes one of the day after it.</summary>
    /// <param name="unit">A whole number of them makes a second.</param>
    public CalendarTime RoundedTo(Duration unit)
    {
        Duration rounded = SinceMidnight.RoundedTo(unit);
        return IsLeapSecond && rounded < Duration.Day + Duration.OfSeconds(1)
            ? InLeapSecond(DayNumber, rounded - Duration.Day)
            : new CalendarTime(DayNumber, IsLeapSecond ? rounded - Duration.OfSeconds(1) : rounded);
    }

    /// <summary>ISO 8601 with as many decimals of a second as the time needs, at most 9: "2010-04-03T00:00:00".</summary>
    public override string ToString() => Text(Decimals, isPadded: false);

    /// <summary>ISO 8601 with all nine decimals of a second: "2010-04-03T00:00:00.000000000".</summary>
    public string ToNanoseconds() => Text(Decimals, isPadded: true);

    /// <summary>ISO 8601 with as many decimals of a second as the time needs, up to all 18 that it has.</summary>
    public string ToExactText() => Text(AllDecimals, isPadded: false);

    private string Text(int length, bool isPadded)
    {
        CalendarTime rounded = RoundedTo(new Duration(0, (long)Math.Pow(10.0, AllDecimals - length)));
        (long second, long fraction) = (rounded.SinceMidnight.WholeSeconds, rounded.SinceMidnight.Attoseconds);
        (long hour, long minute) = rounded.IsLeapSecond ? (23, 59) : (second / 3600, second / 60 % 60);
        string decimals = fraction.ToString("D18", CultureInfo.InvariantCulture)[..length];
        decimals = isPadded ? decimals : decimals.TrimEnd('0');
        return Invariant(
            $"{DayZero.AddDays(rounded.DayNumber):yyyy-MM-dd}T{hour:00}:{minute:00}:{second - (3600 * hour) - (60 * minute):00}")
            + (decimals.Length == 0 ? string.Empty : $".{decimals}");
    }
}
