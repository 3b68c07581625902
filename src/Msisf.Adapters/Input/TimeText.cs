using System.Text.RegularExpressions;
using Msisf.Core.Time;

namespace Msisf.Adapters.Input;

/// <summary>Reads times: Modified Julian Dates (UTC), or dates and times of the calendar with their zone, as ISO 8601 has them.</summary>
public static partial class TimeText
{
    /// <summary>Name of a field that holds a time, in lists and messages.</summary>
    public const string Field = "MJD";

    /// <summary>What a time may look like, for messages.</summary>
    public const string ValidValues = "an MJD (UTC), or ISO 8601 with its zone, e.g. 2024-01-19T12:00:00Z";

    /// <summary>days: a Julian Date begins at noon 4713 BC, a Modified Julian Date at 1858-11-17T00:00:00.</summary>
    private const double JulianDateOfMjdZero = 2_400_000.5;

    /// <summary>Julian Date of the year 10000, past the last date.</summary>
    private const double EndOfJulianDates = 5_373_484.5;

    private static readonly Duration LastMinute = Duration.OfSeconds(86_340);

    /// <summary>Reads a time.</summary>
    /// <param name="text">The characters of the time alone.</param>
    /// <param name="time">UTC.</param>
    /// <returns>False if it is not a time: <see cref="ProblemWith"/> says why.</returns>
    public static bool TryParse(ReadOnlySpan<char> text, out CalendarTime time) => Read(text, out time) is null;

    /// <summary>Why <see cref="TryParse"/> refuses a text, and what to write.</summary>
    /// <param name="text">The refused characters.</param>
    public static string ProblemWith(ReadOnlySpan<char> text) => Read(text, out _) ?? string.Empty;

    /// <summary>Reads a time.</summary>
    /// <param name="text">The characters of the time alone.</param>
    /// <returns>UTC.</returns>
    /// <exception cref="BadInputException">It is not a time.</exception>
    public static CalendarTime Parse(ReadOnlySpan<char> text) =>
        Read(text, out CalendarTime time) is { } problem ? throw new BadInputException($"{problem}.") : time;

    /// <summary>The text of a moment that <see cref="Parse"/> reads as the same one: its MJD if that names it, or ISO 8601.</summary>
    public static string Of(Instant moment)
    {
        CalendarTime time = moment.Utc;
        double mjd = time.Mjd;
        return CalendarTime.OfMjd(mjd) == time ? mjd.ToString("R", CultureInfo.InvariantCulture) : $"{time.ToExactText()}Z";
    }

    /// <summary>The length of the ISO time at a place of a text, up to the colon after it or the end; 0 if there is none.</summary>
    internal static int LengthOfIsoTime(string text, int start) =>
        IsoTimeInList().Match(text, start) is { Success: true } match ? match.Length : 0;

    private static string? Read(ReadOnlySpan<char> text, out CalendarTime time)
    {
        time = default;
        try
        {
            return IsLikeCalendar(text) ? ReadIso(text, out time) : ReadMjd(text, out time);
        }
        catch (BadInputException outside)
        {
            return outside.Message.TrimEnd('.');
        }
    }

    private static string? ReadMjd(ReadOnlySpan<char> text, out CalendarTime time)
    {
        time = default;
        if (!NumberText.TryParse(text, out double mjd))
        {
            return $"{NumberText.ProblemWith(text)}; a time is {ValidValues}";
        }

        if (mjd is >= JulianDateOfMjdZero and < EndOfJulianDates)
        {
            return Invariant(
                $"{NumberText.Shown(text)} looks like a Julian Date; its MJD is {mjd - JulianDateOfMjdZero:R} (MJD = JD - 2400000.5)");
        }

        time = CalendarTime.OfMjd(mjd);
        return null;
    }

    /// <summary>Whether a text can only be meant as a calendar date: a year with a dash behind it, or a colon.</summary>
    private static bool IsLikeCalendar(ReadOnlySpan<char> text) =>
        text.Contains(':') || (text.Length > 5 && text[4] == '-' && !text[..4].ContainsAnyExceptInRange('0', '9'));

    private static string? ReadIso(ReadOnlySpan<char> text, out CalendarTime time)
    {
        time = default;
        string shown = NumberText.Shown(text);
        if (IsoTime().Match(text.ToString()) is not { Success: true } iso)
        {
            return $"{shown} is not a time; write ISO 8601, e.g. 2024-01-19T12:00:00Z or 2024-019T14:00:00.5+02:00, or an MJD";
        }

        if (!iso.Groups["hour"].Success)
        {
            return $"{shown} has no time of day; write e.g. {text}T00:00:00Z";
        }

        if (!iso.Groups["zone"].Success)
        {
            return $"{shown} has no time zone; add Z for UTC, or an offset such as +02:00";
        }

        decimal second = iso.Groups["second"].Success ? decimal.Parse(iso.Groups["second"].Value, CultureInfo.InvariantCulture) : 0m;
        int hour = Number(iso, "hour");
        int minute = Number(iso, "minute");
        int zoneHour = Number(iso, "zoneHour");
        int zoneMinute = Number(iso, "zoneMinute");
        if (DateOf(iso) is not { } date)
        {
            return $"{shown}: there is no such day in the calendar";
        }

        int zoneSeconds = 60 * ((60 * zoneHour) + zoneMinute) * (iso.Groups["zone"].Value[0] == '-' ? -1 : 1);
        CalendarTime atMinute = CalendarTime.Of(date, (60 * ((60 * hour) + minute)) - zoneSeconds);
        bool isLeapSecond = second is >= 60m and < 61m && atMinute.SinceMidnight == LastMinute;
        if (hour > 23 || minute > 59 || (second >= 60m && !isLeapSecond) || zoneHour > 23 || zoneMinute > 59)
        {
            return $"{shown}: hours are 00 to 23, minutes and seconds 00 to 59, but for a leap second, 23:59:60 UTC";
        }

        time = isLeapSecond
            ? CalendarTime.InLeapSecond(atMinute.DayNumber, Duration.OfSeconds(second - 60m))
            : atMinute + Duration.OfSeconds(second);
        return null;
    }

    private static DateOnly? DateOf(Match iso)
    {
        int year = Number(iso, "year");
        int dayOfYear = Number(iso, "dayOfYear");
        int month = Number(iso, "month");
        int day = Number(iso, "day");
        if (year == 0)
        {
            return null;
        }

        if (iso.Groups["dayOfYear"].Success)
        {
            return dayOfYear >= 1 && dayOfYear <= (DateTime.IsLeapYear(year) ? 366 : 365)
                ? new DateOnly(year, 1, 1).AddDays(dayOfYear - 1)
                : null;
        }

        return month is >= 1 and <= 12 && day >= 1 && day <= DateTime.DaysInMonth(year, month) ? new DateOnly(year, month, day) : null;
    }

    private static int Number(Match iso, string group) =>
        iso.Groups[group].Success ? int.Parse(iso.Groups[group].Value, CultureInfo.InvariantCulture) : 0;

    [GeneratedRegex(
        @"^(?<year>[0-9]{4})-((?<month>[0-9]{2})-(?<day>[0-9]{2})|(?<dayOfYear>[0-9]{3}))"
            + @"([Tt](?<hour>[0-9]{2}):(?<minute>[0-9]{2})(:(?<second>[0-9]{2}(\.[0-9]{1,18})?))?"
            + @"(?<zone>[Zz]|[+-](?<zoneHour>[0-9]{2}):?(?<zoneMinute>[0-9]{2}))?)?$",
        RegexOptions.ExplicitCapture)]
    private static partial Regex IsoTime();

    [GeneratedRegex(@"\G\s*[0-9]{4}-[0-9-]+[Tt][0-9:.]+([Zz]|[+-][0-9]{2}:?[0-9]{2})(?=\s*(:|$))", RegexOptions.ExplicitCapture)]
    private static partial Regex IsoTimeInList();
}
