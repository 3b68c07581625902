using System.Collections;

namespace Msisf.Core.Time;

/// <summary>
/// The times of [start:step:end], as MATLAB's colon counts them: start + k step for k = 0, 1, ... up to the end, which is included when a
/// whole number of steps reaches it. Steps are those of the clock: a day has 86 400 s of them, with a leap second too. May be empty.
/// Immutable; a time is computed when it is asked for, without rounding.
/// </summary>
public sealed class TimeInterval : IReadOnlyList<CalendarTime>
{
    /// <summary>Maximum number of times, above the number of frames of any real run; a larger number is a mistake in the step.</summary>
    public const int MaxTimes = 10_000_000;

    /// <summary>steps: how far an end that was typed as an MJD may be rounded away from a step at most.</summary>
    private const double MostRounding = 1e-3;

    private readonly CalendarTime _start;

    /// <summary>Counts the times.</summary>
    /// <param name="start">First time, UTC.</param>
    /// <param name="step">From one time to the next; negative counts down.</param>
    /// <param name="end">Bound of the last time, UTC.</param>
    /// <exception cref="BadInputException">
    /// The step is zero, there are more than <see cref="MaxTimes"/> times, or the start is in a leap second.
    /// </exception>
    public TimeInterval(CalendarTime start, Duration step, CalendarTime end)
    {
        if (step == default)
        {
            throw new BadInputException("The step of the time interval is 0 days; give one that leads from the start to the end.");
        }

        if (start.IsLeapSecond)
        {
            throw new BadInputException(
                $"The time interval begins in a leap second, {start}, which the days that are counted from it do not have. Begin a second "
                    + "before or after it.");
        }

        (_start, Step, Length) = (start, step, end - start);
        Count = CountTimes(end);
    }

    /// <summary>From one time to the next.</summary>
    public Duration Step { get; }

    /// <summary>From the start to the end that was given; negative if the end lies before the start.</summary>
    public Duration Length { get; }

    /// <summary>How many times there are, 0 if the step leads away from the end.</summary>
    public int Count { get; }

    /// <summary>start + index * step.</summary>
    /// <param name="index">From 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">Not in [0, <see cref="Count"/>).</exception>
    public CalendarTime this[int index]
    {
        get
        {
            ArgumentOutOfRangeException.ThrowIfNegative(index);
            ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(index, Count);
            return _start + (index * Step);
        }
    }

    /// <inheritdoc/>
    public IEnumerator<CalendarTime> GetEnumerator()
    {
        for (int index = 0; index < Count; index++)
        {
            yield return this[index];
        }
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    private int CountTimes(CalendarTime end)
    {
        double steps = Length / Step;
        if (steps < 0.0)
        {
            return 0;
        }

        // An end as typed may be rounded to a double of MJD; MATLAB allows for that too.
        double largest = Math.Max(Math.Abs(_start.Mjd), Math.Abs(end.Mjd));
        double spacing = (Math.BitIncrement(largest) - largest) * Duration.Day.TotalSeconds;
        double tolerance = Math.Max(Tolerances.IntervalSteps, Math.Min(MostRounding, spacing / Math.Abs(Step.TotalSeconds)));
        double nearest = Math.Round(steps);
        double last = Math.Abs(steps - nearest) <= tolerance ? nearest : Math.Floor(steps);
        if (last >= MaxTimes)
        {
            throw new BadInputException(Invariant(
                $"The time interval from {_start} to {end} has {Math.Floor(last) + 1.0:R} times, at most {MaxTimes} can be asked for. "
                    + $"Check the step, which is {Step.TotalSeconds:R} s; a number without a unit is one of days."));
        }

        return (int)last + 1;
    }
}
