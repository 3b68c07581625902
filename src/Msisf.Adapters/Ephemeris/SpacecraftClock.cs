using System.Globalization;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Ephemeris;

/// <summary>The clock of a spacecraft by an SCLK kernel of type 1: ticks, in which CKs count, and TDB. Immutable.</summary>
/// <remarks>NAIF, SCLK Required Reading, "The Type 1 SCLK Data".</remarks>
public sealed class SpacecraftClock
{
    private const double IsTt = 2.0;

    private readonly TdbScale _scale;
    private readonly bool _countsTt;
    private readonly double _ticksPerCount;
    private readonly double[] _ticks;
    private readonly double[] _times;
    private readonly double[] _rates;
    private readonly string _source;

    private SpacecraftClock(KernelPool pool, int clock, TdbScale scale)
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
            throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture, $"{table.Source}: triple {wrong + 1} of the clock has a rate that is not above 0."));
        }
    }

    /// <summary>Whether text kernels have a clock.</summary>
    public static bool IsIn(KernelPool pool, int clock) => pool.Find($"SCLK_DATA_TYPE_{SuffixOf(clock)}") is not null;

    /// <summary>Reads a clock.</summary>
    /// <param name="pool">Has its SCLK kernel.</param>
    /// <param name="clock">NAIF's number of the clock, usually of the spacecraft.</param>
    /// <param name="scale">Of the leap seconds kernel.</param>
    /// <exception cref="BadInputException">There is none, or it can't be read.</exception>
    public static SpacecraftClock Read(KernelPool pool, int clock, TdbScale scale) => IsIn(pool, clock)
        ? new SpacecraftClock(pool, clock, scale)
        : throw new BadInputException(string.Create(
            CultureInfo.InvariantCulture,
            $"No kernel has the clock of spacecraft {clock}, in whose ticks the CK counts. Add its SCLK kernel with --kernels."));

    /// <summary>Ticks at a time, with a fraction.</summary>
    /// <param name="tdbSeconds">TDB seconds past J2000.</param>
    /// <exception cref="BadInputException">The clock does not go yet.</exception>
    public double TicksAt(double tdbSeconds)
    {
        double time = _countsTt ? _scale.ToTt(tdbSeconds) : tdbSeconds;
        int index = EntryOf(_times, time);
        return index >= 0
            ? _ticks[index] + ((time - _times[index]) / (_rates[index] / _ticksPerCount))
            : throw new BadInputException(
                $"{_source}: the clock begins at {_scale.ToUtc(TimeOf(_ticks[0])).ToIsoUtc()}; "
                    + $"{_scale.ToUtc(tdbSeconds).ToIsoUtc()} is before that. Choose a later time, or another SCLK kernel.");
    }

    /// <summary>The time of ticks: TDB seconds past J2000. Before the clock's first entry its first rate goes on.</summary>
    public double TimeOf(double ticks)
    {
        int index = Math.Max(0, EntryOf(_ticks, ticks));
        double time = _times[index] + (_rates[index] / _ticksPerCount * (ticks - _ticks[index]));
        return _countsTt ? _scale.FromTt(time) : time;
    }

    /// <summary>Variables of a clock end in its number without the sign.</summary>
    private static string SuffixOf(int clock) => (-(long)clock).ToString(CultureInfo.InvariantCulture);

    /// <summary>The entry to use, -1 before the first one.</summary>
    /// <remarks>
    /// Real clocks have entries that do not rise (LRO's of 2009-07-18). Which one CSPICE then takes is decided by its search, so the search
    /// is as there: the last entry if the value is past it, else bisection.
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
