using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ccsds;

/// <summary>
/// A time as CCSDS files write it: 2022-11-16T08:44:51.150 or 2022-320T08:44:51.150, with or without Z, in any time system.
/// </summary>
/// <param name="DayNumber">Days since 1858-11-17, as in an MJD.</param>
/// <param name="SecondsOfDay">s; 86400 and more in a leap second.</param>
internal readonly record struct CcsdsEpoch(int DayNumber, double SecondsOfDay)
{
    /// <summary>What a time looks like, for messages.</summary>
    public const string ValidValues = "2024-01-19T12:00:00.000 or 2024-019T12:00:00.000";

    private const int DateLength = 10; // of YYYY-MM-DD
    private const int DayOfYearLength = 8; // of YYYY-DDD

    private static readonly int DayZero = new DateOnly(1858, 11, 17).DayNumber;

    /// <summary>Reads a time.</summary>
    /// <param name="text">Its characters alone.</param>
    /// <returns>False if it is no time.</returns>
    public static bool TryParse(ReadOnlySpan<char> text, out CcsdsEpoch epoch)
    {
        epoch = default;
        text = text is [.., 'Z' or 'z'] ? text[..^1] : text;
        int separator = text.IndexOfAny('T', 't');
        if (separator is not (DateLength or DayOfYearLength) || !TryParseDate(text[..separator], out int day))
        {
            return false;
        }

        ReadOnlySpan<char> time = text[(separator + 1)..];
        if (time.Length < 5 || time[2] != ':' || (time.Length > 5 && (time.Length < 8 || time[5] != ':'))
            || !TryParseDigits(time[..2], out int hour) || !TryParseDigits(time[3..5], out int minute))
        {
            return false;
        }

        double second = 0.0;
        if (time.Length > 5 && !(TryParseDigits(time[6..8], out _)
            && (time.Length == 8 || (time[8] == '.' && !time[9..].ContainsAnyExceptInRange('0', '9')))
            && double.TryParse(time[6..], NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out second)))
        {
            return false;
        }

        bool isLeapSecond = hour == 23 && minute == 59 && second is >= 60.0 and < 61.0;
        epoch = new CcsdsEpoch(day, (60 * ((60 * hour) + minute)) + second);
        return hour <= 23 && minute <= 59 && (second < 60.0 || isLeapSecond);
    }

    private static bool TryParseDate(ReadOnlySpan<char> date, out int day)
    {
        day = 0;
        if (date[4] != '-' || !TryParseDigits(date[..4], out int year) || year == 0)
        {
            return false;
        }

        if (date.Length == DayOfYearLength)
        {
            bool isDay = TryParseDigits(date[5..], out int dayOfYear) && dayOfYear >= 1
                && dayOfYear <= (DateTime.IsLeapYear(year) ? 366 : 365);
            day = isDay ? new DateOnly(year, 1, 1).DayNumber + dayOfYear - 1 - DayZero : 0;
            return isDay;
        }

        if (date[7] != '-' || !TryParseDigits(date[5..7], out int month) || !TryParseDigits(date[8..], out int dayOfMonth)
            || month is < 1 or > 12 || dayOfMonth < 1 || dayOfMonth > DateTime.DaysInMonth(year, month))
        {
            return false;
        }

        day = new DateOnly(year, month, dayOfMonth).DayNumber - DayZero;
        return true;
    }

    private static bool TryParseDigits(ReadOnlySpan<char> text, out int number) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out number);
}

/// <summary>Turns the times of a file into TDB.</summary>
internal sealed class CcsdsTimeSystem
{
    private const double TaiMinusGps = 19.0; // s, by definition

    /// <summary>MJD of 2000-01-01; J2000 is noon of that day.</summary>
    private const int DayOfJ2000 = 51544;

    private readonly string _name;
    private readonly TdbScale _scale;

    private CcsdsTimeSystem(string name, TdbScale scale) => (_name, _scale) = (name, scale);

    /// <summary>The time systems that are known.</summary>
    public static IReadOnlyList<string> Names { get; } = ["UTC", "TAI", "TT", "TDB", "GPS"];

    /// <summary>The time system of a file.</summary>
    /// <param name="name">The value of TIME_SYSTEM.</param>
    /// <param name="scale">From the leap seconds kernel.</param>
    /// <returns>Null if it is not known.</returns>
    public static CcsdsTimeSystem? Of(string name, TdbScale scale) =>
        Names.FirstOrDefault(known => known.Equals(name, StringComparison.OrdinalIgnoreCase)) is { } found
            ? new CcsdsTimeSystem(found, scale)
            : null;

    /// <summary>TDB seconds past J2000; null for a leap second that there was not.</summary>
    public double? ToTdbSeconds(CcsdsEpoch epoch)
    {
        if (_name == "UTC")
        {
            return OfUtc(epoch);
        }

        if (epoch.SecondsOfDay >= 86400.0)
        {
            return null;
        }

        double seconds = SecondsPastJ2000(epoch);
        return _name switch
        {
            "TDB" => seconds,
            "TT" => _scale.FromTt(seconds),
            "TAI" => _scale.FromTt(seconds + _scale.TtMinusTai),
            _ => _scale.FromTt(seconds + TaiMinusGps + _scale.TtMinusTai),
        };
    }

    private double? OfUtc(CcsdsEpoch epoch)
    {
        if (epoch.SecondsOfDay < 86400.0)
        {
            return _scale.FromUtcSeconds(SecondsPastJ2000(epoch));
        }

        // In a leap second: counted on from a second before it.
        double before = _scale.FromUtcSeconds(SecondsPastJ2000(epoch with { SecondsOfDay = epoch.SecondsOfDay - 1.0 }));
        double midnight = _scale.FromUtcSeconds(SecondsPastJ2000(new CcsdsEpoch(epoch.DayNumber + 1, 0.0)));
        return before + 1.0 < midnight ? before + 1.0 : null;
    }

    private static double SecondsPastJ2000(CcsdsEpoch epoch) =>
        ((86400.0 * ((double)epoch.DayNumber - DayOfJ2000)) - 43200.0) + epoch.SecondsOfDay;
}
