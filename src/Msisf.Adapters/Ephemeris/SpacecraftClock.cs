using Msisf.Core.Time;

namespace Msisf.Adapters.Ephemeris;

/// <summary>The clock of a spacecraft by an SCLK kernel of type 1: ticks, in which CKs count, and TDB. Immutable.</summary>
/// <remarks>NAIF, SCLK Required Reading, "The Type 1 SCLK Data".</remarks>
public sealed class SpacecraftClock
{
    private const double IsTt = 2.0;

    private readonly TimeScale _scale;
    private readonly bool _countsTt;
    private readonly double _ticksPerCount;
    private readonly double[] _ticks;
    private readonly double[] _times;
    private readonly double[] _rates;
    private readonly double[] _moduli;
    private readonly double[] _offsets;
    private readonly double[] _partitions;
    private readonly string _source;

    private SpacecraftClock(KernelPool pool, int clock, TimeScale scale)
    {
        string suffix = SuffixOf(clock);
        if (pool.WholeNumber($"SCLK_DATA_TYPE_{suffix}") is not 1 and var type)
        {
            throw new BadInputException(
                $"{pool.Existing($"SCLK_DATA_TYPE_{suffix}").Source}: a clock of type {type}; only type 1 is known.");
        }

        _scale = scale;
        _countsTt = pool.Find($"SCLK01_TIME_SYSTEM_{suffix}") is { Numbers: [IsTt, ..] };
        KernelVariable moduli = pool.Existing($"SCLK01_MODULI_{suffix}");
        _ticksPerCount = moduli.Numbers.Skip(1).Aggregate(1.0, (product, field) => product * field);
        _moduli = [.. moduli.Numbers];
        _offsets = [.. pool.Find($"SCLK01_OFFSETS_{suffix}")?.Numbers ?? []];
        _partitions = StartsOf(
            pool.Find($"SCLK_PARTITION_START_{suffix}")?.Numbers ?? [], pool.Find($"SCLK_PARTITION_END_{suffix}")?.Numbers ?? []);
        KernelVariable table = pool.Existing($"SCLK01_COEFFICIENTS_{suffix}");
        _source = table.Source;
        if (table.Numbers.Count == 0 || table.Numbers.Count % 3 != 0 || !(_ticksPerCount > 0.0))
        {
            throw new BadInputException($"{table.Source}: the coefficients of a clock must be triples of ticks, seconds and rate.");
        }

        double[][] columns = [.. Enumerable.Range(0, 3).Select(k => table.Numbers.Where((_, i) => i % 3 == k).ToArray())];
        (_ticks, _times, _rates) = (columns[0], columns[1], columns[2]);
        int wrong = Array.FindIndex(_rates, rate => !(rate > 0.0));
        if (wrong >= 0)
        {
            throw new BadInputException(Invariant($"{table.Source}: triple {wrong + 1} of the clock has a rate that is not above 0."));
        }
    }

    /// <summary>Whether text kernels have a clock.</summary>
    public static bool IsIn(KernelPool pool, int clock) => pool.Find($"SCLK_DATA_TYPE_{SuffixOf(clock)}") is not null;

    /// <summary>Reads a clock.</summary>
    /// <param name="pool">Has its SCLK kernel.</param>
    /// <param name="clock">NAIF's number of the clock, usually of the spacecraft.</param>
    /// <param name="scale">Time scale of the leap seconds kernel.</param>
    /// <exception cref="BadInputException">There is none, or it can't be read.</exception>
    public static SpacecraftClock Read(KernelPool pool, int clock, TimeScale scale) => IsIn(pool, clock)
        ? new SpacecraftClock(pool, clock, scale)
        : throw new BadInputException(Invariant(
            $"No kernel has the clock of spacecraft {clock}, in whose ticks the CK counts. Add its SCLK kernel with --kernels."));

    /// <summary>Ticks at a time, with a fraction.</summary>
    /// <param name="tdbSeconds">TDB seconds past J2000.</param>
    /// <exception cref="BadInputException">The clock does not go yet.</exception>
    public double TicksAt(double tdbSeconds)
    {
        double time = _countsTt ? _scale.TtOfTdb(tdbSeconds) : tdbSeconds;
        int index = EntryOf(_times, time);
        return index >= 0
            ? _ticks[index] + ((time - _times[index]) / (_rates[index] / _ticksPerCount))
            : throw new BadInputException(
                $"{_source}: the clock begins at {_scale.InstantOf(TimeOf(_ticks[0])).ToIsoUtc()}; "
                    + $"{_scale.InstantOf(tdbSeconds).ToIsoUtc()} is before that. Choose a later time, or another SCLK kernel.");
    }

    /// <summary>The time of ticks: TDB seconds past J2000. Before the clock's first entry its first rate goes on.</summary>
    public double TimeOf(double ticks)
    {
        int index = Math.Max(0, EntryOf(_ticks, ticks));
        double time = _times[index] + (_rates[index] / _ticksPerCount * (ticks - _ticks[index]));
        return _countsTt ? _scale.TdbOfTt(time) : time;
    }

    /// <summary>The time of a count as labels write it: TDB seconds past J2000.</summary>
    /// <param name="count">Partition and fields of the clock, e.g. "1/270649237:07208"; without partition it is the first one.</param>
    /// <exception cref="BadInputException">It is not a count of this clock.</exception>
    public double TimeOf(string count)
    {
        string[] halves = count.Trim().Split('/');
        string[] texts = halves[^1].Split([':', '.', '-', ',', ' '], StringSplitOptions.RemoveEmptyEntries);
        double[] fields = [.. texts.Select(text =>
            double.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out double field) ? field : double.NaN)];
        int partition = halves.Length == 1 ? 1
            : int.TryParse(halves[0], NumberStyles.None, CultureInfo.InvariantCulture, out int number) ? number : 0;
        if (halves.Length > 2 || fields.Length == 0 || fields.Length > _moduli.Length || fields.Any(double.IsNaN)
            || partition < 1 || partition > Math.Max(1, _partitions.Length))
        {
            throw new BadInputException($"{_source}: '{count}' is not a count of this clock.");
        }

        double ticks = _partitions.Length == 0 ? 0.0 : _partitions[partition - 1];
        for (int i = 0; i < fields.Length; i++)
        {
            double offset = i < _offsets.Length ? _offsets[i] : 0.0;
            ticks += (fields[i] - offset) * _moduli.Skip(i + 1).Aggregate(1.0, (product, field) => product * field);
        }

        return TimeOf(ticks);
    }

    /// <summary>What is added to a partition's own ticks so that the clock goes on through all of them.</summary>
    private static double[] StartsOf(IReadOnlyList<double> starts, IReadOnlyList<double> ends)
    {
        double[] added = new double[Math.Min(starts.Count, ends.Count)];
        double before = 0.0;
        for (int i = 0; i < added.Length; i++)
        {
            added[i] = before - starts[i];
            before += ends[i] - starts[i];
        }

        return added;
    }

    /// <summary>Variables of a clock end in its number without the sign.</summary>
    private static string SuffixOf(int clock) => (-(long)clock).ToString(CultureInfo.InvariantCulture);

    /// <summary>The entry to use, -1 before the first one.</summary>
    /// <remarks>
    /// Real clocks have entries that do not rise (LRO's of 2009-07-18). Which one CSPICE then takes is decided by its search, so the search
    /// is as there: the last entry if the value is past it, otherwise bisection.
    /// </remarks>
    private static int EntryOf(double[] values, double value)
    {
        (int low, int high) = (0, values.Length - 1);
        if (value < values[0] || value >= values[high])
        {
            return value < values[0] ? -1 : high;
        }

        while (low < high - 1)
        {
            int middle = ((low + high + 2) / 2) - 1; // SPICE counts from 1
            (low, high) = value < values[middle] ? (low, middle) : (middle, high);
        }

        return low;
    }
}
