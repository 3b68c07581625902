using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>The times that the loaded kernels cover; the message for a time outside the cover is made from it.</summary>
/// <param name="Scale">Turns the cover's TDB into UTC.</param>
/// <param name="Times">Times at which the Sun, the body and the body's orientation are all known.</param>
public sealed record KernelCover(TdbScale Scale, TdbCover Times)
{
    /// <summary>Intervals that a text names.</summary>
    private const int MaxIntervals = 6;

    private const double Microseconds = 1e6; // a second

    private static readonly DateTime J2000Utc = new(2000, 1, 1, 12, 0, 0, DateTimeKind.Utc);

    /// <summary>The body.</summary>
    public CelestialBody Body { get; init; } = CelestialBody.Moon;

    /// <summary>Whether the kernels cover a time.</summary>
    /// <param name="time">UTC.</param>
    public bool Contains(ModifiedJulianDate time) => Times.Contains(Scale.FromUtc(time));

    /// <summary>The failure for a time inside the cover whose sunlight left the Sun before the cover begins.</summary>
    /// <param name="time">UTC, when the light arrives.</param>
    public SpiceException LightFromOutside(ModifiedJulianDate time) => new(Invariant(
        $"The sunlight of {time.ToIsoUtc()} (MJD {time.Days:R}) left the Sun some 500 s earlier, outside the kernels' cover: "
            + $"the kernels cover {Describe()}. Choose a later time, other kernels, or --aberration none."));

    /// <summary>The failure for a time outside the cover.</summary>
    /// <param name="time">UTC.</param>
    /// <param name="inner">The engine's exception, if there is one.</param>
    public SpiceException Outside(ModifiedJulianDate time, Exception? inner = null) => new(
        Invariant(
            $"{time.ToIsoUtc()} (MJD {time.Days:R}) is outside the kernels' cover: the kernels cover {Describe()}. "
                + $"Choose a time inside, or other kernels."),
        inner);

    /// <summary>
    /// The cover in UTC to the second, rounded inwards: "1899-12-31T23:59:19Z to 2050-12-31T23:58:50Z". What lies within a second is given
    /// to the microsecond, and of many intervals the first ones and the last.
    /// </summary>
    public string Describe()
    {
        IReadOnlyList<TdbInterval> intervals = Times.Intervals;
        int left = intervals.Count > MaxIntervals ? intervals.Count - MaxIntervals : 0;
        return intervals.Count == 0
            ? Invariant(
                $"no time at all, because they do not have all of Sun (10), {Body.Name} ({Body.NaifNumber}) and the orientation of "
                    + $"{Body.Frame}")
            : string.Join(
                " and ",
                [
                    .. intervals.Take(MaxIntervals - 1).Select(Text),
                    .. left > 0 ? [Invariant($"{left} more")] : Array.Empty<string>(),
                    .. intervals.Skip(MaxIntervals - 1).TakeLast(1).Select(Text),
                ]);
    }

    private string Text(TdbInterval interval)
    {
        (double start, double end) = (Scale.ToUtcSeconds(interval.Start), Scale.ToUtcSeconds(interval.End));
        return Math.Ceiling(start) < Math.Floor(end) ? $"{Text(Math.Ceiling(start))} to {Text(Math.Floor(end))}"
            : Math.Ceiling(start * Microseconds) < Math.Floor(end * Microseconds)
                ? $"{Text(Math.Ceiling(start * Microseconds) / Microseconds)} to {Text(Math.Floor(end * Microseconds) / Microseconds)}"
            : Text(0.5 * (start + end));
    }

    private static string Text(double utcSeconds)
    {
        // Long-term kernels go past the years that a calendar date can name.
        double earliest = (DateTime.MinValue - J2000Utc).TotalSeconds;
        double latest = (new DateTime(9999, 12, 31, 23, 59, 59, DateTimeKind.Utc) - J2000Utc).TotalSeconds;
        double microseconds = Math.Round(Math.Clamp(utcSeconds, earliest, latest) * Microseconds);
        return J2000Utc.AddTicks((long)microseconds * TimeSpan.TicksPerMicrosecond).ToString(
            "yyyy-MM-dd'T'HH:mm:ss.FFFFFF'Z'", CultureInfo.InvariantCulture);
    }
}
