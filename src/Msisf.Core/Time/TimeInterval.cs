using System.Collections;

namespace Msisf.Core.Time;

/// <summary>
/// The times of [start:step:end], as MATLAB's colon counts them: start + k step for k = 0, 1, ... up to the end, which is included when a
/// whole number of steps reaches it. May be empty. Immutable; a time is computed when it is asked for.
/// </summary>
public sealed class TimeInterval : IReadOnlyList<ModifiedJulianDate>
{
    /// <summary>Maximum number of times, above the number of frames of any real run; a larger number is a mistake in the step.</summary>
    public const int MaxTimes = 10_000_000;

    private readonly double _start;

    /// <summary>Counts the times.</summary>
    /// <param name="start">First time.</param>
    /// <param name="stepDays">Days from one time to the next; negative counts down.</param>
    /// <param name="end">Bound of the last time.</param>
    /// <exception cref="BadInputException">
    /// The step is zero, not finite, or too small for an MJD, or there are more than <see cref="MaxTimes"/> times.
    /// </exception>
    public TimeInterval(ModifiedJulianDate start, double stepDays, ModifiedJulianDate end)
    {
        if (Guard.Finite(stepDays, "The step of the time interval (days)") == 0.0)
        {
            throw new BadInputException("The step of the time interval is 0 days; give one that leads from the start to the end.");
        }

        _start = start.Days;
        StepDays = stepDays;
        LengthDays = end.Days - start.Days;
        Count = CountTimes(start.Days, stepDays, end.Days);
    }

    /// <summary>Days from one time to the next.</summary>
    public double StepDays { get; }

    /// <summary>Days from the start to the end that was given; negative if the end lies before the start.</summary>
    public double LengthDays { get; }

    /// <summary>How many times there are, 0 if the step leads away from the end.</summary>
    public int Count { get; }

    /// <summary>start + index * step, rounded once.</summary>
    /// <param name="index">From 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">Not in [0, <see cref="Count"/>).</exception>
    public ModifiedJulianDate this[int index]
    {
        get
        {
            ArgumentOutOfRangeException.ThrowIfNegative(index);
            ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(index, Count);
            return new ModifiedJulianDate(Math.FusedMultiplyAdd(index, StepDays, _start));
        }
    }

    /// <inheritdoc/>
    public IEnumerator<ModifiedJulianDate> GetEnumerator()
    {
        for (int index = 0; index < Count; index++)
        {
            yield return this[index];
        }
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    private static int CountTimes(double start, double step, double end)
    {
        double steps = (end - start) / step;
        if (steps < 0.0)
        {
            return 0;
        }

        double largest = Math.Max(Math.Abs(start), Math.Abs(end));
        double spacing = Math.BitIncrement(largest) - largest;

        // Start and end as typed are each rounded by up to half a spacing; MATLAB allows for that too.
        double tolerance = Math.Max(Tolerances.IntervalSteps, spacing / Math.Abs(step));
        double nearest = Math.Round(steps);
        double last = Math.Abs(steps - nearest) <= tolerance ? nearest : Math.Floor(steps);
        if (last == 0.0)
        {
            return 1;
        }

        if (Math.Abs(step) < spacing)
        {
            throw new BadInputException(Invariant(
                $"The step of the time interval, {step:R} days, is below what an MJD of {largest:R} can hold, {spacing:R} days: "
                    + $"two times would be the same. Give a larger step."));
        }

        if (last >= MaxTimes)
        {
            throw new BadInputException(Invariant(
                $"The time interval [{start:R}:{step:R}:{end:R}] has {Math.Floor(last) + 1.0:R} times, "
                    + $"at most {MaxTimes} can be asked for. Check the step, which is in days."));
        }

        return (int)last + 1;
    }
}
