using Msisf.Core.Time;

namespace Msisf.Core.Ephemeris;

/// <summary>The times for which data exist: disjoint intervals in rising order.</summary>
public sealed class TdbCover
{
    private TdbCover(IReadOnlyList<TdbInterval> intervals) => Intervals = intervals;

    /// <summary>s: how near to an instant a time must be to mean it, because people write times to the millisecond.</summary>
    public const double InstantTolerance = 1e-3;

    /// <summary>No time at all.</summary>
    public static TdbCover Empty { get; } = new([]);

    /// <summary>All times.</summary>
    public static TdbCover Everything { get; } = new([new TdbInterval(double.NegativeInfinity, double.PositiveInfinity)]);

    /// <summary>Disjoint, in rising order.</summary>
    public IReadOnlyList<TdbInterval> Intervals { get; }

    /// <summary>The union of intervals; those that touch or overlap become one.</summary>
    /// <param name="intervals">In any order.</param>
    public static TdbCover Union(IEnumerable<TdbInterval> intervals)
    {
        List<TdbInterval> merged = [];
        foreach (TdbInterval interval in intervals.OrderBy(interval => interval.Start))
        {
            if (merged.Count > 0 && interval.Start <= merged[^1].End)
            {
                merged[^1] = new TdbInterval(merged[^1].Start, Math.Max(merged[^1].End, interval.End));
            }
            else
            {
                merged.Add(interval);
            }
        }

        return new TdbCover(merged);
    }

    /// <summary>The times that both covers hold.</summary>
    public TdbCover Intersect(TdbCover other) => Union(
        from a in Intervals
        from b in other.Intervals
        let both = new TdbInterval(Math.Max(a.Start, b.Start), Math.Min(a.End, b.End))
        where both.Start <= both.End
        select both);

    /// <summary>Whether data exist at a time.</summary>
    public bool Contains(TdbTime time) => Intervals.Any(interval => interval.Contains(time));

    /// <summary>The single instant with data that is meant by a time; null if there is none, or the time is inside an interval.</summary>
    /// <param name="tdbSeconds">TDB seconds past J2000, at most <see cref="InstantTolerance"/> from the instant.</param>
    public double? InstantNear(double tdbSeconds)
    {
        if (Intervals.Count == 0)
        {
            return null;
        }

        TdbInterval nearest = Intervals.MinBy(interval => Math.Max(interval.Start - tdbSeconds, tdbSeconds - interval.End));
        return nearest.IsInstant && Math.Abs(tdbSeconds - nearest.Start) <= InstantTolerance ? nearest.Start : null;
    }
}

/// <summary>
/// A closed stretch of time in TDB seconds past J2000 (2000-01-01T12:00:00 TDB), as kernels count it; <c>default</c> is J2000 alone.
/// </summary>
/// <param name="Start">TDB seconds past J2000.</param>
/// <param name="End">TDB seconds past J2000, not before <paramref name="Start"/>.</param>
public readonly record struct TdbInterval(double Start, double End)
{
    /// <summary>Whether it is a single instant.</summary>
    public bool IsInstant => Start == End;

    /// <summary>Whether a time, rounded to a double as the ends are, is in the interval; both ends belong to it.</summary>
    public bool Contains(TdbTime time) => time.Seconds >= Start && time.Seconds <= End;
}
