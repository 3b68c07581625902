using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>The times that the loaded kernels cover; the message for a time outside the cover is made from it.</summary>
/// <param name="Scale">Turns the cover's TDB into UTC.</param>
/// <param name="Times">Times at which the Sun, the body and the body's orientation are all known.</param>
public sealed record KernelCover(TimeScale Scale, TdbCover Times)
{
    /// <summary>Intervals that a text names.</summary>
    private const int MaxIntervals = 6;

    private static readonly Duration Second = Duration.OfSeconds(1);
    private static readonly Duration Microsecond = Duration.OfSeconds(0.000_001m);

    /// <summary>The body.</summary>
    public CelestialBody Body { get; init; } = CelestialBody.Moon;

    /// <summary>Whether the kernels cover a time.</summary>
    public bool Contains(Instant time) => Times.Contains(time.Tdb);

    /// <summary>The failure for a time inside the cover whose sunlight left the Sun before the cover begins.</summary>
    /// <param name="time">When the light arrives.</param>
    public SpiceException LightFromOutside(Instant time) => new(Invariant(
        $"The sunlight of {time.ToIsoUtc()} (MJD {time.Mjd:R}) left the Sun some 500 s earlier, outside the kernels' cover: "
            + $"the kernels cover {Describe()}. Choose a later time, other kernels, or --aberration none."));

    /// <summary>The failure for a time outside the cover.</summary>
    /// <param name="inner">The engine's exception, if there is one.</param>
    public SpiceException Outside(Instant time, Exception? inner = null) => new(
        Invariant(
            $"{time.ToIsoUtc()} (MJD {time.Mjd:R}) is outside the kernels' cover: the kernels cover {Describe()}. "
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
        (CalendarTime start, CalendarTime end) = (UtcOf(interval.Start), UtcOf(interval.End));
        foreach (Duration unit in (Duration[])[Second, Microsecond])
        {
            (CalendarTime first, CalendarTime last) = (start.RoundedTo(unit), end.RoundedTo(unit));
            first = first < start ? first + unit : first;
            last = last > end ? last + -unit : last;
            if (first < last)
            {
                return $"{first}Z to {last}Z";
            }
        }

        return $"{UtcOf(0.5 * (interval.Start + interval.End)).RoundedTo(Microsecond)}Z";
    }

    /// <summary>Long-term kernels go past the years that a calendar date can name.</summary>
    private CalendarTime UtcOf(double tdbSeconds) =>
        tdbSeconds <= Scale.InstantOf(CalendarTime.First).Tdb.Seconds ? CalendarTime.First
        : tdbSeconds >= Scale.InstantOf(CalendarTime.LastSecond).Tdb.Seconds ? CalendarTime.LastSecond
        : Scale.InstantOf(tdbSeconds).Utc;
}
