namespace Msisf.Core.Time;

/// <summary>The times of samples, rising, and which samples lie around a time.</summary>
public sealed class SampleTimes
{
    private readonly LongList<TdbTime> _times = new();

    /// <summary>Number of samples.</summary>
    public int Count => _times.Count;

    /// <summary>The first time.</summary>
    public TdbTime First => _times[0];

    /// <summary>The last time.</summary>
    public TdbTime Last => _times[Count - 1];

    /// <summary>A time.</summary>
    /// <param name="index">From 0 to below <see cref="Count"/>.</param>
    public TdbTime this[int index] => _times[index];

    /// <summary>Adds a time, which must be after the last one.</summary>
    public void Add(TdbTime time)
    {
        if (Count > 0 && !(time > Last))
        {
            throw new ArgumentOutOfRangeException(nameof(time), time, "The times of samples rise.");
        }

        _times.Add(time);
    }

    /// <summary>
    /// The samples through which a polynomial for a time goes: as many before as after it; of an odd number, about the nearest one. Near
    /// the ends, the first or last ones.
    /// </summary>
    /// <param name="time">The time asked for.</param>
    /// <param name="size">How many samples; all if there are fewer.</param>
    /// <returns>The first one, and how many.</returns>
    public (int First, int Count) Around(TdbTime time, int size)
    {
        int before = LastAtOrBefore(time);
        int first = before - ((size - 1) / 2);
        if (size % 2 == 1 && before >= 0 && before + 1 < Count && _times[before + 1] - time < time - _times[before])
        {
            first++;
        }

        int count = Math.Min(size, Count);
        return (Math.Clamp(first, 0, Count - count), count);
    }

    /// <summary>The last sample at a time or before it; -1 if all are later.</summary>
    public int LastAtOrBefore(TdbTime time)
    {
        (int low, int high) = (-1, Count);
        while (high - low > 1)
        {
            int middle = low + ((high - low) / 2);
            (low, high) = _times[middle] <= time ? (middle, high) : (low, middle);
        }

        return low;
    }

    /// <summary>The times of some samples, counted from a time near them so that they keep their digits.</summary>
    /// <param name="origin">From when they are counted.</param>
    /// <param name="times">Gets them.</param>
    public void CopyTo(int first, TdbTime origin, Span<double> times)
    {
        for (int i = 0; i < times.Length; i++)
        {
            times[i] = _times[first + i] - origin;
        }
    }
}
