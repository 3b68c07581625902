using Msisf.Core.Time;

namespace Msisf.App.Illumination;

/// <summary>A time in which a point is lit, or dark, without a break.</summary>
/// <param name="IsLit">Whether it is lit.</param>
/// <param name="Start">MJD.</param>
/// <param name="End">MJD.</param>
internal readonly record struct PointSpan(bool IsLit, double Start, double End)
{
    /// <summary>Its length.</summary>
    public double Hours => 24.0 * (End - Start);

    /// <summary>The spans of an interval, in order.</summary>
    /// <param name="times">The interval.</param>
    /// <param name="isLit">Whether the point is lit at its start.</param>
    /// <param name="events">Sunrises and sunsets in turn.</param>
    public static PointSpan[] Of(TimeInterval times, bool isLit, IReadOnlyList<(bool IsRise, ModifiedJulianDate Time)> events)
    {
        double[] borders = [times[0].Days, .. events.Select(at => at.Time.Days), times[times.Count - 1].Days];
        return [.. borders.Zip(borders.Skip(1), (start, end) => (start, end)).Select(
            (span, number) => new PointSpan(isLit == (number % 2 == 0), span.start, span.end))];
    }

    /// <summary>The longest one with or without light, the first of several; null if there is none.</summary>
    public static PointSpan? LongestOf(IReadOnlyList<PointSpan> spans, bool isLit) => spans.Where(span => span.IsLit == isLit)
        .Select(span => (PointSpan?)span).MaxBy(span => span!.Value.Hours);
}
