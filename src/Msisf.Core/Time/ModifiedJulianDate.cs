namespace Msisf.Core.Time;

/// <summary>
/// A time as Modified Julian Date in UTC days of 86 400 s; <c>default</c> is 1858-11-17T00:00:00Z. A leap second itself
/// (23:59:60) has no such date: the second before it and the one after it do.
/// </summary>
public readonly record struct ModifiedJulianDate
{
    /// <summary>MJD of 0001-01-01, the first day that a calendar date can name.</summary>
    private const double FirstDay = -678575.0;

    /// <summary>MJD of 9999-12-31 24:00, past the last day that a calendar date can name.</summary>
    private const double EndOfLastDay = 2973484.0;

    private static readonly DateTime DayZero = new(1858, 11, 17, 0, 0, 0, DateTimeKind.Utc);

    /// <summary>Checks a date.</summary>
    /// <param name="days">Days since 1858-11-17T00:00:00 UTC. A double holds today's dates to 0.6 microseconds.</param>
    /// <exception cref="BadInputException">Not finite, or outside the years 1 to 9999.</exception>
    public ModifiedJulianDate(double days)
    {
        if (!(days >= FirstDay && days < EndOfLastDay))
        {
            throw new BadInputException(Invariant(
                $"The MJD {days:R} is not a date; a number from {FirstDay:R} (year 1) to below {EndOfLastDay:R} (year 10000) is needed."));
        }

        // Just before midnight the fraction of the day may round to 1; the date is then set to the next midnight.
        double midnight = Math.Floor(days);
        Days = days - midnight < 1.0 ? days : midnight + 1.0;
    }

    /// <summary>The days of an MJD for a date and time of the calendar.</summary>
    /// <param name="date">UTC.</param>
    /// <param name="secondsOfDay">Seconds since the day began; less than 0 and more than 86400 lead into other days.</param>
    /// <returns>The nearest double.</returns>
    public static double DaysOf(DateOnly date, decimal secondsOfDay)
    {
        // A decimal has 28 digits; its conversion to a double is rounded twice, that of its text once.
        decimal days = date.DayNumber - DateOnly.FromDateTime(DayZero).DayNumber + (secondsOfDay / 86400m);
        return double.Parse(days.ToString(CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
    }

    /// <summary>Days since 1858-11-17T00:00:00 UTC.</summary>
    public double Days { get; }

    /// <summary>Whole days since 1858-11-17.</summary>
    public int DayNumber => (int)Math.Floor(Days);

    /// <summary>Seconds since the day began, [0, 86400); exact, as the fraction of a double is.</summary>
    public double SecondsOfDay => (Days - Math.Floor(Days)) * 86400.0;

    /// <summary>Seconds from <paramref name="epoch"/> to this time, leap seconds left out (thesis eq. 6.1).</summary>
    public double SecondsSince(ModifiedJulianDate epoch) =>
        (86400.0 * ((double)DayNumber - epoch.DayNumber)) + (SecondsOfDay - epoch.SecondsOfDay);

    /// <summary>The time some seconds later, leap seconds left out.</summary>
    public ModifiedJulianDate After(double seconds) => new(Days + (seconds / 86400.0));

    /// <summary>The nearest whole second, as far as a double can hold it.</summary>
    public ModifiedJulianDate ToNearestSecond() => new(Math.Round(Days * 86400.0) / 86400.0);

    /// <summary>ISO 8601 with as many decimals of a second as the time needs, at most 6: "2010-04-03T00:00:00Z".</summary>
    public string ToIsoUtc()
    {
        long microseconds = (long)Math.Round(SecondsOfDay * 1e6, MidpointRounding.AwayFromZero);
        DateTime time = DayZero.AddDays(DayNumber).AddTicks(microseconds * TimeSpan.TicksPerMicrosecond);
        return time.ToString("yyyy-MM-dd'T'HH:mm:ss.FFFFFF'Z'", CultureInfo.InvariantCulture);
    }
}
