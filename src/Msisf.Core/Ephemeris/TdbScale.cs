using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>Turns UTC into TDB, the time that kernels count, with the constants of a leap seconds kernel.</summary>
/// <remarks>The formula and the meaning of the constants stand in NAIF's leap seconds kernels (naif0012.tls, "Explanation").</remarks>
public sealed class TdbScale
{
    /// <summary>MJD of 2000-01-01; J2000 is noon of that day.</summary>
    private const int DayOfJ2000 = 51544;

    /// <summary>s: before the first entry of the table, TAI - UTC is its first value less this, as in SPICE.</summary>
    private const double StepBeforeTable = 1.0;

    /// <summary>
    /// Number of passes of the inversion: TDB - UTC changes by less than 1e-9 s per second, so each pass gains nine digits.
    /// </summary>
    private const int InversionPasses = 3;

    private readonly TdbScaleConstants _constants;
    private readonly LeapSecond[] _leapSeconds;

    /// <summary>Makes the scale.</summary>
    /// <param name="constants">DELTET/DELTA_T_A, K, EB and M of the kernel.</param>
    /// <param name="leapSeconds">DELTET/DELTA_AT; at least one, in rising order.</param>
    public TdbScale(TdbScaleConstants constants, IReadOnlyList<LeapSecond> leapSeconds)
    {
        ArgumentOutOfRangeException.ThrowIfZero(leapSeconds.Count);
        _constants = constants;
        _leapSeconds = [.. leapSeconds];
    }

    /// <summary>
    /// Seconds past 2000-01-01T12:00:00 UTC, each day counted with 86 400 s; one rounding (at most 0.24 microseconds from 1900 to 2050).
    /// </summary>
    /// <param name="time">UTC.</param>
    public static double UtcSeconds(ModifiedJulianDate time) =>
        ((86400.0 * ((double)time.DayNumber - DayOfJ2000)) - 43200.0) + time.SecondsOfDay;

    /// <summary>s: terrestrial time counts that much before TAI (32.184).</summary>
    public double TtMinusTai => _constants.TtMinusTai;

    /// <summary>TDB seconds past J2000.</summary>
    /// <param name="time">UTC.</param>
    /// <remarks>
    /// The sums are in the order of CSPICE's DELTET, so that both engines round to the same TDB (one ulp in 1900 turns the Sun by 1.3e-12).
    /// </remarks>
    public double FromUtc(ModifiedJulianDate time) => FromUtcSeconds(UtcSeconds(time));

    /// <summary>TDB seconds past J2000.</summary>
    /// <param name="utcSeconds">As of <see cref="UtcSeconds"/>.</param>
    public double FromUtcSeconds(double utcSeconds) => utcSeconds + TdbMinusUtc(utcSeconds);

    /// <summary>TDB seconds past J2000.</summary>
    /// <param name="ttSeconds">Terrestrial time: seconds past 2000-01-01T12:00:00 TT.</param>
    public double FromTt(double ttSeconds) => ttSeconds + TdbMinusTt(ttSeconds);

    /// <summary>Terrestrial time: seconds past 2000-01-01T12:00:00 TT.</summary>
    /// <param name="tdbSeconds">TDB seconds past J2000.</param>
    public double ToTt(double tdbSeconds)
    {
        double ttSeconds = tdbSeconds;
        for (int pass = 0; pass < InversionPasses; pass++)
        {
            ttSeconds = tdbSeconds - TdbMinusTt(ttSeconds);
        }

        return ttSeconds;
    }

    /// <summary>Seconds past 2000-01-01T12:00:00 UTC, each day counted with 86 400 s; within a leap second up to 1 s off.</summary>
    /// <param name="tdbSeconds">TDB seconds past J2000.</param>
    public double ToUtcSeconds(double tdbSeconds)
    {
        double utcSeconds = tdbSeconds;
        for (int pass = 0; pass < InversionPasses; pass++)
        {
            utcSeconds = tdbSeconds - TdbMinusUtc(utcSeconds);
        }

        return utcSeconds;
    }

    /// <summary>UTC, to the 0.6 microseconds that a date holds.</summary>
    /// <param name="tdbSeconds">TDB seconds past J2000.</param>
    public ModifiedJulianDate ToUtc(double tdbSeconds) => new(DayOfJ2000 + 0.5 + (ToUtcSeconds(tdbSeconds) / 86400.0));

    private double TdbMinusUtc(double utcSeconds)
    {
        double taiMinusUtc = _leapSeconds[0].TaiMinusUtc - StepBeforeTable;
        for (int i = _leapSeconds.Length - 1; i >= 0; i--)
        {
            if (utcSeconds >= _leapSeconds[i].UtcSeconds)
            {
                taiMinusUtc = _leapSeconds[i].TaiMinusUtc;
                break;
            }
        }

        // CSPICE's DELTET takes the anomaly at the nearest whole second. This changes TDB by at most 2e-10 s. Without it, one time in
        // 5000 was rounded to another double; with it, both engines agree in every bit (20 000 random times).
        double nearestSecond = Math.Round(utcSeconds + _constants.TtMinusTai + taiMinusUtc, MidpointRounding.AwayFromZero);
        return _constants.TtMinusTai + taiMinusUtc + TdbMinusTt(nearestSecond);
    }

    private double TdbMinusTt(double ttSeconds)
    {
        double meanAnomaly = _constants.MeanAnomalyAtJ2000 + (_constants.MeanMotion * ttSeconds);
        double eccentricAnomaly = meanAnomaly + (_constants.Eccentricity * Math.Sin(meanAnomaly));
        return _constants.Amplitude * Math.Sin(eccentricAnomaly);
    }
}

/// <summary>
/// The constants of TDB - TAI = TtMinusTai + Amplitude sin E, E = M + Eccentricity sin M (leap seconds kernel, DELTET/...).
/// </summary>
/// <param name="TtMinusTai">s: DELTA_T_A.</param>
/// <param name="Amplitude">s: K.</param>
/// <param name="Eccentricity">1: EB, of the Earth's orbit.</param>
/// <param name="MeanAnomalyAtJ2000">rad: first value of M.</param>
/// <param name="MeanMotion">rad/s: second value of M.</param>
public readonly record struct TdbScaleConstants(
    double TtMinusTai,
    double Amplitude,
    double Eccentricity,
    double MeanAnomalyAtJ2000,
    double MeanMotion);

/// <summary>One step of TAI - UTC.</summary>
/// <param name="TaiMinusUtc">s, from <paramref name="UtcSeconds"/> on.</param>
/// <param name="UtcSeconds">When it begins: seconds past 2000-01-01T12:00:00 UTC, each day counted with 86 400 s.</param>
public sealed record LeapSecond(double TaiMinusUtc, double UtcSeconds);
