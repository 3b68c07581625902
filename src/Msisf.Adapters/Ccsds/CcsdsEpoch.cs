using Msisf.Core.Time;

namespace Msisf.Adapters.Ccsds;

/// <summary>
/// Times as CCSDS files write them: 2022-11-16T08:44:51.150 or 2022-320T08:44:51.150, with or without Z, in any time system.
/// </summary>
internal static class CcsdsEpoch
{
    /// <summary>What a time looks like, for messages.</summary>
    public const string ValidValues = "2024-01-19T12:00:00.000 or 2024-019T12:00:00.000";

    private const int DateLength = 10; // of YYYY-MM-DD
    private const int DayOfYearLength = 8; // of YYYY-DDD

    /// <summary>The time systems that are known, by their names.</summary>
    public static IReadOnlyList<(string Name, TimeSystem System)> Systems { get; } =
        [("UTC", TimeSystem.Utc), ("TAI", TimeSystem.Tai), ("TT", TimeSystem.Tt), ("TDB", TimeSystem.Tdb), ("GPS", TimeSystem.Gps)];

    /// <summary>Reads a time.</summary>
    /// <param name="text">Its characters alone.</param>
    /// <returns>False if it is not a time.</returns>
    public static bool TryParse(ReadOnlySpan<char> text, out CalendarTime time)
    {
        time = default;
        text = text is [.., 'Z' or 'z'] ? text[..^1] : text;
        int separator = text.IndexOfAny('T', 't');
        if (separator is not (DateLength or DayOfYearLength) || !TryParseDate(text[..separator], out DateOnly day))
        {
            return false;
        }

        ReadOnlySpan<char> clock = text[(separator + 1)..];
        if (clock.Length < 5 || clock[2] != ':' || (clock.Length > 5 && (clock.Length < 8 || clock[5] != ':'))
            || !TryParseDigits(clock[..2], out int hour) || !TryParseDigits(clock[3..5], out int minute))
        {
            return false;
        }

        decimal second = 0m;
        if (clock.Length > 5 && !(TryParseDigits(clock[6..8], out _)
            && (clock.Length == 8 || (clock[8] == '.' && !clock[9..].ContainsAnyExceptInRange('0', '9')))
            && decimal.TryParse(clock[6..], NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out second)))
        {
            return false;
        }

        bool isLeapSecond = hour == 23 && minute == 59 && second is >= 60m and < 61m;
        CalendarTime atMinute = CalendarTime.Of(day, 60 * ((60 * hour) + minute));
        time = isLeapSecond
            ? CalendarTime.InLeapSecond(atMinute.DayNumber, Duration.OfSeconds(second - 60m))
            : atMinute + Duration.OfSeconds(second);
        return hour <= 23 && minute <= 59 && (second < 60m || isLeapSecond);
    }

    private static bool TryParseDate(ReadOnlySpan<char> date, out DateOnly day)
    {
        day = default;
        if (date[4] != '-' || !TryParseDigits(date[..4], out int year) || year == 0)
        {
            return false;
        }

        if (date.Length == DayOfYearLength)
        {
            bool isDay = TryParseDigits(date[5..], out int dayOfYear) && dayOfYear >= 1
                && dayOfYear <= (DateTime.IsLeapYear(year) ? 366 : 365);
            day = isDay ? new DateOnly(year, 1, 1).AddDays(dayOfYear - 1) : default;
            return isDay;
        }

        if (date[7] != '-' || !TryParseDigits(date[5..7], out int month) || !TryParseDigits(date[8..], out int dayOfMonth)
            || month is < 1 or > 12 || dayOfMonth < 1 || dayOfMonth > DateTime.DaysInMonth(year, month))
        {
            return false;
        }

        day = new DateOnly(year, month, dayOfMonth);
        return true;
    }

    private static bool TryParseDigits(ReadOnlySpan<char> text, out int number) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out number);
}
