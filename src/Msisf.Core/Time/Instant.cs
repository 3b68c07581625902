namespace Msisf.Core.Time;

/// <summary>
/// A moment, exact to an attosecond, with the <see cref="TimeScale"/> that gives its names in UTC and TDB. Differences are SI seconds.
/// Immutable. <c>default</c> is not a moment: it has no scale and names nothing.
/// </summary>
/// <remarks>It counts TAI since 2000-01-01T12:00:00 TAI. Two moments are equal if their counts are, whatever their scales.</remarks>
public readonly record struct Instant : IComparable<Instant>
{
    private readonly TimeScale? _scale;

    internal Instant(Duration tai, TimeScale scale) => (Tai, _scale) = (tai, scale);

    /// <summary>TAI since 2000-01-01T12:00:00 TAI.</summary>
    public Duration Tai { get; }

    /// <summary>The leap seconds and constants by which it has its names.</summary>
    public TimeScale Scale => _scale ?? throw new InvalidOperationException("This moment was never set.");

    /// <summary>Its date and time of day in UTC.</summary>
    public CalendarTime Utc => Scale.CalendarOf(this, TimeSystem.Utc);

    /// <summary>The nearest Modified Julian Date, UTC; in a leap second the last one of the day.</summary>
    public double Mjd => Utc.Mjd;

    /// <summary>TDB seconds past J2000.</summary>
    public TdbTime Tdb => Scale.TdbOf(this);

    /// <summary>The moment some time later.</summary>
    public static Instant operator +(Instant a, Duration later) => new(a.Tai + later, a.Scale);

    /// <summary>The moment some time earlier.</summary>
    public static Instant operator -(Instant a, Duration earlier) => new(a.Tai - earlier, a.Scale);

    /// <summary>The time from one moment to another.</summary>
    public static Duration operator -(Instant a, Instant b) => a.Tai - b.Tai;

    /// <summary>Compares.</summary>
    public static bool operator <(Instant a, Instant b) => a.Tai < b.Tai;

    /// <summary>Compares.</summary>
    public static bool operator >(Instant a, Instant b) => a.Tai > b.Tai;

    /// <summary>Compares.</summary>
    public static bool operator <=(Instant a, Instant b) => a.Tai <= b.Tai;

    /// <summary>Compares.</summary>
    public static bool operator >=(Instant a, Instant b) => a.Tai >= b.Tai;

    /// <summary>The moment some SI seconds later.</summary>
    public Instant After(double seconds) => this + Duration.OfSeconds(seconds);

    /// <summary>SI seconds from another moment to this one, rounded once.</summary>
    public double SecondsSince(Instant epoch) => (Tai - epoch.Tai).TotalSeconds;

    /// <summary>ISO 8601 in UTC with as many decimals of a second as the time needs, at most 9: "2010-04-03T00:00:00Z".</summary>
    public string ToIsoUtc() => $"{Utc}Z";

    /// <inheritdoc/>
    public bool Equals(Instant other) => Tai == other.Tai;

    /// <inheritdoc/>
    public override int GetHashCode() => Tai.GetHashCode();

    /// <inheritdoc/>
    public int CompareTo(Instant other) => Tai.CompareTo(other.Tai);

    /// <inheritdoc/>
    public override string ToString() => _scale is null ? "no moment" : ToIsoUtc();
}
