namespace Msisf.Adapters.Ephemeris;

/// <summary>The numbers of one segment, each checked when it is read. Safe for several threads.</summary>
/// <param name="file">The kernel; must outlive the object.</param>
internal sealed class DafWords(DafFile file, DafSummary summary)
{
    /// <summary>How many numbers the segment has.</summary>
    public long Count { get; } = (long)summary.LastAddress - summary.FirstAddress + 1;

    /// <summary>Reads some numbers.</summary>
    /// <param name="first">The first one, from 0.</param>
    /// <exception cref="BadInputException">They are not all in the segment, or one is not finite.</exception>
    public double[] Read(long first, int count)
    {
        if (first < 0 || count < 0 || first + count > Count)
        {
            throw Damaged("its data lead out of the segment");
        }

        double[] words = new double[count];
        file.ReadDoubles(summary.FirstAddress + first, words);
        return Array.TrueForAll(words, double.IsFinite) ? words : throw Damaged("a number is not finite");
    }

    /// <summary>Reads one of the last numbers, which must be whole.</summary>
    /// <param name="fromEnd">1 for the last one.</param>
    /// <param name="min">The least value that is possible.</param>
    /// <param name="max">The largest one.</param>
    /// <exception cref="BadInputException">It is none of these.</exception>
    public int Whole(int fromEnd, int min, long max)
    {
        double value = Read(Count - fromEnd, 1)[0];
        return value == Math.Truncate(value) && value >= min && value <= Math.Min(max, int.MaxValue)
            ? (int)value
            : throw Damaged(Invariant($"number {fromEnd} from its end is {value:R}, which does not fit its size"));
    }

    /// <summary>Reads times that must rise.</summary>
    /// <param name="first">The first one, from 0.</param>
    /// <exception cref="BadInputException">They do not rise.</exception>
    public double[] ReadRising(long first, int count)
    {
        double[] times = Read(first, count);
        for (int i = 1; i < count; i++)
        {
            if (!(times[i] > times[i - 1]))
            {
                throw Damaged(Invariant($"its times do not rise: {times[i]:R} follows {times[i - 1]:R}"));
            }
        }

        return times;
    }

    /// <summary>The error for a segment that contradicts itself.</summary>
    /// <param name="what">What was found.</param>
    public BadInputException Damaged(string what) => file.Damaged(Invariant($"in the segment of {summary.Integers[0]}, {what}"));
}
