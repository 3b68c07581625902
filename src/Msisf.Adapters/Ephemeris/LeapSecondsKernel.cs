using Msisf.Core.Time;

namespace Msisf.Adapters.Ephemeris;

/// <summary>The time scale that a leap seconds kernel (LSK) defines.</summary>
public static class LeapSecondsKernel
{
    private const string IdWord = "KPL/LSK";

    /// <summary>Reads the scale of kernels.</summary>
    /// <param name="paths">Kernels (no meta-kernels) in load order; the leap seconds kernels of them are read, if there are any.</param>
    /// <exception cref="BadInputException">A kernel can't be read, or a DELTET variable is missing or not as it should be.</exception>
    public static TimeScale ReadScale(IReadOnlyList<string> paths)
    {
        string[] own = [.. paths.Where(path => KernelFile.IdWordOf(path) == IdWord)];
        return ReadScale(KernelPool.Of(own.Length > 0 ? own : paths));
    }

    /// <summary>Takes the scale from the pool.</summary>
    /// <param name="pool">Holds a leap seconds kernel.</param>
    /// <exception cref="BadInputException">A DELTET variable is missing or not as it should be.</exception>
    public static TimeScale ReadScale(KernelPool pool)
    {
        const string Table = "DELTET/DELTA_AT";
        KernelVariable table = pool.Existing(Table);
        if (table.Numbers.Count == 0 || table.Numbers.Count % 2 != 0)
        {
            throw new BadInputException($"{table.Source}: {Table} must be pairs of TAI - UTC and the date from which it holds.");
        }

        LeapSecond[] leapSeconds = new LeapSecond[table.Numbers.Count / 2];
        for (int i = 0; i < leapSeconds.Length; i++)
        {
            leapSeconds[i] = new LeapSecond(table.Numbers[2 * i], table.Numbers[(2 * i) + 1]);
            if (i > 0 && leapSeconds[i].UtcSeconds <= leapSeconds[i - 1].UtcSeconds)
            {
                throw new BadInputException($"{table.Source}: the dates of {Table} must rise; pair {i + 1} does not.");
            }
        }

        IReadOnlyList<double> meanAnomaly = pool.Numbers("DELTET/M", 2);
        TdbConstants constants = new(
            TtMinusTai: pool.Numbers("DELTET/DELTA_T_A", 1)[0],
            Amplitude: pool.Numbers("DELTET/K", 1)[0],
            Eccentricity: pool.Numbers("DELTET/EB", 1)[0],
            MeanAnomalyAtJ2000: meanAnomaly[0],
            MeanMotion: meanAnomaly[1]);
        return new TimeScale(constants, leapSeconds);
    }
}
