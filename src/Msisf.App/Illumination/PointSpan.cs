using Msisf.Core.Time;

namespace Msisf.App.Illumination;

/// <summary>A time in which a point is lit, or dark, without a break.</summary>
/// <param name="IsLit">Whether it is lit.</param>
internal readonly record struct PointSpan(bool IsLit, Instant Start, Instant End)
{
    /// <summary>Its length.</summary>
    public double Hours => End.SecondsSince(Start) / 3600.0;

    /// <summary>The spans of an interval, in order.</summary>
    /// <param name="times">The interval.</param>
    /// <param name="isLit">Whether the point is lit at its start.</param>
    /// <param name="events">Sunrises and sunsets in turn.</param>
    public static PointSpan[] Of(IReadOnlyList<Instant> times, bool isLit, IReadOnlyList<(bool IsRise, Instant Time)> events)
    {
        Instant[] borders = [times[0], .. events.Select(at => at.Time), times[^1]];
        return [.. borders.Zip(borders.Skip(1), (start, end) => (start, end)).Select(
            (span, number) => new PointSpan(isLit == (number % 2 == 0), span.start, span.end))];
    }

    /// <summary>The longest one with or without light, the first of several; null if there is none.</summary>
    public static PointSpan? LongestOf(IReadOnlyList<PointSpan> spans, bool isLit) => spans.Where(span => span.IsLit == isLit)
        .Select(span => (PointSpan?)span).MaxBy(span => span!.Value.Hours);
}
