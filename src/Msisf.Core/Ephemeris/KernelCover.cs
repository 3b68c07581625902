using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>The times that the loaded kernels cover; the message for a time outside the cover is made from it.</summary>
/// <param name="Scale">Turns the cover's TDB into UTC.</param>
/// <param name="Times">Times at which the Sun, the body and the body's orientation are all known.</param>
public sealed record KernelCover(TdbScale Scale, TdbCover Times)
{
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

    /// <summary>The cover in UTC to the second, rounded inwards: "1899-12-31T23:59:19Z to 2050-12-31T23:58:50Z".</summary>
    public string Describe() => Times.Intervals.Count == 0
        ? Invariant(
            $"no time at all, because they do not have all of Sun (10), {Body.Name} ({Body.NaifNumber}) and the orientation of "
                + $"{Body.Frame}")
        : string.Join(" and ", Times.Intervals.Select(interval =>
            $"{Text(Math.Ceiling(Scale.ToUtcSeconds(interval.Start)))} to {Text(Math.Floor(Scale.ToUtcSeconds(interval.End)))}"));

    private static string Text(double utcSeconds)
    {
        // Long-term kernels go past the years that a calendar date can name.
        double earliest = (DateTime.MinValue - J2000Utc).TotalSeconds;
        double latest = (new DateTime(9999, 12, 31, 23, 59, 59, DateTimeKind.Utc) - J2000Utc).TotalSeconds;
        return J2000Utc.AddSeconds(Math.Clamp(utcSeconds, earliest, latest)).ToString(
            "yyyy-MM-dd'T'HH:mm:ss'Z'", CultureInfo.InvariantCulture);
    }
}
