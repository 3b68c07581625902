using Msisf.Core.Ephemeris;
using Msisf.Core.Time;
using Msisf.Stress.Reference;
using Msisf.Stress.Time;

namespace Msisf.Stress.Engines;

/// <summary>Times at which two readers of the same kernels might differ.</summary>
internal sealed class EphemerisTimes
{
    /// <summary>Days: each record of the shipped kernels is a multiple of it long.</summary>
    private const double RecordDays = 4.0;

    private const double SecondsPerDay = 86400.0;

    /// <summary>First days of a new count of leap seconds, MJD.</summary>
    private static readonly double[] LeapDays = [.. StressTable.Rows("leap_seconds.csv").Select(row => row[0]).Where(double.IsInteger)];

    private readonly KernelCover _cover;
    private readonly double _first;
    private readonly double _last;

    public EphemerisTimes(KernelCover cover)
    {
        _cover = cover;
        _first = MjdOf(cover.Times.Intervals[0].Start);
        _last = MjdOf(cover.Times.Intervals[^1].End);
    }

    /// <summary>MJD at which the cover begins.</summary>
    public double First => _first;

    /// <summary>MJD at which it ends.</summary>
    public double Last => _last;

    /// <summary>Half anywhere in the cover, the rest close by leap seconds, borders of records, and the cover's ends.</summary>
    public Instant Draw(CaseRandom random)
    {
        while (true)
        {
            double mjd = random.Below(6) switch
            {
                0 => Beside(LeapDays[random.Below(LeapDays.Length)], random),
                1 => Beside(RecordBorder(random), random),
                2 => Beside(random.Below(2) == 0 ? _first : _last, random),
                _ => random.Between(_first, _last),
            };
            Instant time = ProjectKernels.OfMjd(mjd);
            if (_cover.Contains(time))
            {
                return time;
            }
        }
    }

    /// <summary>From the very time to 10 s off.</summary>
    private static double Beside(double mjd, CaseRandom random) =>
        mjd + (random.Sign() * random.Logarithmic(1e-7, 10.0) / SecondsPerDay);

    private double RecordBorder(CaseRandom random)
    {
        TdbInterval interval = _cover.Times.Intervals[0];
        double record = RecordDays * SecondsPerDay;
        return MjdOf(interval.Start + (record * Math.Floor(random.Between(0.0, (interval.End - interval.Start) / record))));
    }

    private double MjdOf(double tdbSeconds) => _cover.Scale.InstantOf(tdbSeconds).Mjd;
}
