using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ccsds;

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
