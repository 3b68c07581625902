namespace Msisf.Core.Time;

/// <summary>
/// Turns UTC, TAI, TT, TDB and GPS time into each other, with the leap seconds and constants of a leap seconds kernel. Immutable.
/// </summary>
/// <remarks>
/// The formula of TDB and the meaning of the constants are in NAIF's leap seconds kernels (naif0012.tls, "Explanation"). Before the first
/// leap second TAI - UTC is the table's first value less 1 s, as in CSPICE; the drifting UTC of 1960 to 1971 is not known.
/// </remarks>
public sealed class TimeScale
{
    /// <summary>MJD of 2000-01-01; J2000 is noon of that day.</summary>
    private const int DayOfJ2000 = 51544;

    /// <summary>
    /// Number of passes of the inversion: TDB - TT changes by less than 1e-9 s per second, so each pass gains nine digits.
    /// </summary>
    private const int InversionPasses = 3;

    private static readonly Duration HalfDay = Duration.OfSeconds(43_200);
    private static readonly Duration StepBeforeTable = Duration.OfSeconds(1);
    private static readonly Duration TaiMinusGps = Duration.OfSeconds(19); // by definition
    private static readonly Duration Attosecond = new(0, 1);

    private readonly TdbConstants _constants;
    private readonly Duration _ttMinusTai;
    private readonly Step[] _steps;

    /// <summary>Makes the scale.</summary>
    /// <param name="constants">DELTET/DELTA_T_A, K, EB and M of the kernel.</param>
    /// <param name="leapSeconds">DELTET/DELTA_AT; at least one, in rising order.</param>
    public TimeScale(TdbConstants constants, IReadOnlyList<LeapSecond> leapSeconds)
    {
        ArgumentOutOfRangeException.ThrowIfZero(leapSeconds.Count);
        _constants = constants;
        _ttMinusTai = Duration.OfDecimal(constants.TtMinusTai);
        _steps = [.. leapSeconds.Select(leap => new Step(Duration.OfDecimal(leap.UtcSeconds), Duration.OfDecimal(leap.TaiMinusUtc)))];
    }

    /// <summary>The moment of a date and time of day.</summary>
    /// <param name="time">In UTC.</param>
    /// <exception cref="BadInputException">It is in a leap second that there was not.</exception>
    public Instant InstantOf(CalendarTime time) => InstantOf(time, TimeSystem.Utc);

    /// <summary>The moment of a date and time of day.</summary>
    /// <param name="time">In a system.</param>
    /// <exception cref="BadInputException">It is in a leap second that there was not, or in one of a system without them.</exception>
    public Instant InstantOf(CalendarTime time, TimeSystem system)
    {
        Duration midnight = MidnightOf(time);
        Duration count = midnight + time.SinceMidnight;
        if (!HasMoment(time, system))
        {
            throw new BadInputException($"{time}: there was no leap second then. Take the second before or after it.");
        }

        return new Instant(
            system switch
            {
                TimeSystem.Utc => count + OffsetAt(time.IsLeapSecond ? midnight + Duration.Day - Attosecond : count),
                TimeSystem.Tai => count,
                TimeSystem.Tt => count - _ttMinusTai,
                TimeSystem.Gps => count + TaiMinusGps,
                TimeSystem.Tdb => TtOfTdb(count) - _ttMinusTai,
                _ => throw new ArgumentOutOfRangeException(nameof(system)),
            },
            this);
    }

    /// <summary>Whether there is such a moment: not every day has a leap second, and no day of a system other than UTC.</summary>
    public bool HasMoment(CalendarTime time, TimeSystem system)
    {
        Duration end = MidnightOf(time) + Duration.Day;
        return !time.IsLeapSecond
            || (system == TimeSystem.Utc && time.SinceMidnight - Duration.Day < OffsetAt(end) - OffsetAt(end - Attosecond));
    }

    /// <summary>The moment of an MJD.</summary>
    /// <param name="mjd">Days since 1858-11-17T00:00:00 UTC, as <see cref="CalendarTime.OfMjd"/> takes them.</param>
    /// <exception cref="BadInputException">Not finite, or outside the years 1 to 9999.</exception>
    public Instant InstantOfMjd(double mjd) => InstantOf(CalendarTime.OfMjd(mjd));

    /// <summary>The moment of a kernel's time.</summary>
    public Instant InstantOf(TdbTime time) =>
        new(TtOfTdb(Duration.OfSeconds(time.Seconds) + Duration.OfSeconds(time.Rest)) - _ttMinusTai, this);

    /// <summary>The date and time of day of a moment.</summary>
    /// <exception cref="BadInputException">It is outside the years 1 to 9999.</exception>
    public CalendarTime CalendarOf(Instant moment, TimeSystem system)
    {
        Duration tai = moment.Tai;
        if (system != TimeSystem.Utc)
        {
            return OfCount(system switch
            {
                TimeSystem.Tai => tai,
                TimeSystem.Tt => tai + _ttMinusTai,
                TimeSystem.Gps => tai - TaiMinusGps,
                TimeSystem.Tdb => tai + _ttMinusTai + TdbMinusTt(tai + _ttMinusTai),
                _ => throw new ArgumentOutOfRangeException(nameof(system)),
            });
        }

        int last = _steps.Length - 1;
        while (last >= 0 && tai < _steps[last].Utc + _steps[last].TaiMinusUtc)
        {
            last--;
        }

        Duration count = tai - (last < 0 ? _steps[0].TaiMinusUtc - StepBeforeTable : _steps[last].TaiMinusUtc);
        return last + 1 < _steps.Length && count >= _steps[last + 1].Utc
            ? CalendarTime.InLeapSecond(OfCount(_steps[last + 1].Utc).DayNumber - 1, count - _steps[last + 1].Utc)
            : OfCount(count);
    }

    /// <summary>A moment as kernels count it.</summary>
    public TdbTime TdbOf(Instant moment)
    {
        Duration tt = moment.Tai + _ttMinusTai;
        Duration tdb = tt + TdbMinusTt(tt);
        double seconds = tdb.TotalSeconds;
        return new TdbTime(seconds, (tdb - Duration.OfSeconds(seconds)).TotalSeconds);
    }

    /// <summary>TDB seconds past J2000.</summary>
    /// <param name="ttSeconds">Terrestrial time: seconds past 2000-01-01T12:00:00 TT.</param>
    public double TdbOfTt(double ttSeconds) => ttSeconds + Periodic(ttSeconds);

    /// <summary>Terrestrial time: seconds past 2000-01-01T12:00:00 TT.</summary>
    /// <param name="tdbSeconds">TDB seconds past J2000.</param>
    public double TtOfTdb(double tdbSeconds)
    {
        double ttSeconds = tdbSeconds;
        for (int pass = 0; pass < InversionPasses; pass++)
        {
            ttSeconds = tdbSeconds - Periodic(ttSeconds);
        }

        return ttSeconds;
    }

    private Duration TtOfTdb(Duration tdb)
    {
        Duration tt = tdb;
        for (int pass = 0; pass < InversionPasses; pass++)
        {
            tt = tdb - TdbMinusTt(tt);
        }

        return tt;
    }

    private static Duration MidnightOf(CalendarTime time) => (((long)time.DayNumber - DayOfJ2000) * Duration.Day) - HalfDay;

    private static CalendarTime OfCount(Duration sinceJ2000) => new CalendarTime(DayOfJ2000, HalfDay) + sinceJ2000;

    /// <summary>TAI - UTC at a count of UTC.</summary>
    private Duration OffsetAt(Duration utc)
    {
        for (int i = _steps.Length - 1; i >= 0; i--)
        {
            if (utc >= _steps[i].Utc)
            {
                return _steps[i].TaiMinusUtc;
            }
        }

        return _steps[0].TaiMinusUtc - StepBeforeTable;
    }

    private Duration TdbMinusTt(Duration tt) => Duration.OfSeconds(Periodic(tt.TotalSeconds));

    /// <summary>s: TDB - TT.</summary>
    private double Periodic(double ttSeconds)
    {
        double meanAnomaly = _constants.MeanAnomalyAtJ2000 + (_constants.MeanMotion * ttSeconds);
        double eccentricAnomaly = meanAnomaly + (_constants.Eccentricity * Trigonometry.Sin(meanAnomaly));
        return _constants.Amplitude * Trigonometry.Sin(eccentricAnomaly);
    }

    /// <param name="Utc">When it begins: since 2000-01-01T12:00:00 UTC, each day counted with 86 400 s.</param>
    private readonly record struct Step(Duration Utc, Duration TaiMinusUtc);
}

/// <summary>
/// The constants of TDB - TAI = TtMinusTai + Amplitude sin E, E = M + Eccentricity sin M (leap seconds kernel, DELTET/...).
/// </summary>
/// <param name="TtMinusTai">s: DELTA_T_A.</param>
/// <param name="Amplitude">s: K.</param>
/// <param name="Eccentricity">1: EB, of the Earth's orbit.</param>
/// <param name="MeanAnomalyAtJ2000">rad: first value of M.</param>
/// <param name="MeanMotion">rad/s: second value of M.</param>
public readonly record struct TdbConstants(
    double TtMinusTai,
    double Amplitude,
    double Eccentricity,
    double MeanAnomalyAtJ2000,
    double MeanMotion);

/// <summary>One step of TAI - UTC.</summary>
/// <param name="TaiMinusUtc">s, from <paramref name="UtcSeconds"/> on.</param>
/// <param name="UtcSeconds">When it begins: seconds past 2000-01-01T12:00:00 UTC, each day counted with 86 400 s.</param>
public sealed record LeapSecond(double TaiMinusUtc, double UtcSeconds);
