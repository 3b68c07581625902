using Msisf.Core.Ephemeris;
using Msisf.Core.Time;
using Msisf.Stress.Reference;

namespace Msisf.Stress.Time;

/// <summary>UTC to TDB around leap seconds, and the smallest steps of time.</summary>
public sealed class TimeStress : IStressTest
{
    private const double SecondsADay = 86400.0;
    private const double Microsecond = 1e-6;

    /// <summary>
    /// ulp: the two roundings of UTC seconds and TDB, half a unit each; the whole second at which SPICE takes the Earth's anomaly makes
    /// 2e-10 s, a hundredth at most.
    /// </summary>
    private const double TdbError = 1.05;

    /// <summary>s: half of what an MJD of 32768 to 65535 (1948 to 2038) is rounded to, 2^-37 days = 6.3e-7 s.</summary>
    private const double MjdError = 3.2e-7;

    /// <summary>s: a step comes out as one or two spacings of such an MJD.</summary>
    private const double StepError = 3.8e-7;

    /// <summary>s: at each end UTC seconds and TDB are rounded to at most 2^-23 s, so by 1.2e-7 s in all.</summary>
    private const double TdbStepError = StepError + 2.4e-7;

    /// <summary>s: the same at the two ends of the leap second; the MJDs on both sides are exact.</summary>
    private const double LeapError = 2.4e-7;

    /// <summary>MJD from which a step of 1e-6 s is below the spacing of a double: 2038-04-23.</summary>
    private const double CoarseMjd = 65536.0;

    private const int StepsOfAnInterval = 1000;

    /// <inheritdoc/>
    public string Name => "time";

    /// <inheritdoc/>
    public string Subject =>
        "UTC to TDB next to all 28 leap seconds, against IERS's dates and mpmath; "
            + "intervals of 1,000 steps of 1e-6 s from random times of 1972 to 2038, and after, where an MJD is too coarse for them.";

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int intervals = length == StressLength.Full ? 10_000 : 100;
        TdbScale scale = ProjectKernels.ReadScale();
        double[][] leapSeconds = StressTable.Rows("leap_seconds.csv");
        Found all = SeededCases.Run(intervals, seed, () => new Found(scale));
        all.NoteLeapSeconds(leapSeconds);
        return new StressReport(
            Name,
            leapSeconds.Length + ((long)intervals * (StepsOfAnInterval + 1)),
            [
                all.Tdb.ToFigure("TDB next to a leap second", "ulp", TdbError),
                all.Leap.ToFigure(
                    "seconds of TDB from the last MJD of a day with a leap second to midnight, without that of the MJD: difference from 1",
                    "s",
                    LeapError),
                all.Place.ToFigure("MJD of a step of 1e-6 s: difference from its place", "s", MjdError),
                all.Step.ToFigure("length of a step of 1e-6 s in MJD: difference", "s", StepError),
                all.TdbStep.ToFigure("length of a step of 1e-6 s in TDB: difference", "s", TdbStepError),
                all.Order.ToFigure("steps of 1e-6 s that stand still or go back, in MJD or TDB", "", 0.0),
                all.Refusal.ToFigure("intervals of 1e-6 s after 2038-04-23 that are not refused", "", 0.0),
            ],
            [all.OverDate.ToSeries("length of a step of 1e-6 s in TDB: difference", "s", "MJD", "", TdbStepError)]);
    }

    private sealed class Found(TdbScale scale) : IMeasure<Found>
    {
        public WorstCase Tdb { get; } = new();

        public WorstCase Leap { get; } = new();

        public WorstCase Place { get; } = new();

        public WorstCase Step { get; } = new();

        public WorstCase TdbStep { get; } = new();

        public CaseCount Order { get; } = new();

        public CaseCount Refusal { get; } = new();

        public SeriesBuilder OverDate { get; } = new(41317.0, CoarseMjd, 48, isLogarithmic: false);

        public void NoteLeapSeconds(double[][] rows)
        {
            foreach (double[] row in rows)
            {
                double found = scale.FromUtc(new ModifiedJulianDate(row[0]));
                Tdb.Note(Math.Abs(found - row[1]) / Ulp.Of(row[1]), () => MjdText.Of(row[0]));
                if (row[0] == Math.Floor(row[0]))
                {
                    double before = Math.BitDecrement(row[0]);
                    double seconds = found - scale.FromUtc(new ModifiedJulianDate(before)) - (SecondsADay * (row[0] - before));
                    Leap.Note(Math.Abs(seconds - 1.0), () => MjdText.Of(before));
                }
            }
        }

        public void Try(int number, CaseRandom random)
        {
            NoteInterval(random.Between(41317.0, CoarseMjd - 1.0));
            NoteCoarseInterval(random.Between(CoarseMjd, 88000.0));
        }

        public void Add(Found other)
        {
            Tdb.Add(other.Tdb);
            Leap.Add(other.Leap);
            Place.Add(other.Place);
            Step.Add(other.Step);
            TdbStep.Add(other.TdbStep);
            Order.Add(other.Order);
            Refusal.Add(other.Refusal);
            OverDate.Add(other.OverDate);
        }

        private void NoteInterval(double start)
        {
            double step = Microsecond / SecondsADay;
            TimeInterval interval = new(new ModifiedJulianDate(start), step, new ModifiedJulianDate(start + (StepsOfAnInterval * step)));
            ModifiedJulianDate previous = interval[0];
            for (int index = 1; index < interval.Count; index++)
            {
                ModifiedJulianDate time = interval[index];
                double days = time.Days - previous.Days;
                double tdbSeconds = scale.FromUtc(time) - scale.FromUtc(previous);
                Place.Note(Math.Abs((SecondsADay * (time.Days - start)) - (index * Microsecond)), () => MjdText.Of(time.Days));
                Step.Note(Math.Abs((SecondsADay * days) - Microsecond), () => MjdText.Of(time.Days));
                TdbStep.Note(Math.Abs(tdbSeconds - Microsecond), () => MjdText.Of(time.Days));
                Order.Note(days <= 0.0 || tdbSeconds <= 0.0, () => MjdText.Of(time.Days));
                OverDate.Add(start, Math.Abs(tdbSeconds - Microsecond));
                previous = time;
            }
        }

        private void NoteCoarseInterval(double start)
        {
            double step = Microsecond / SecondsADay;
            string? refusal = Refusals.Of(
                () => new TimeInterval(new ModifiedJulianDate(start), step, new ModifiedJulianDate(start + (StepsOfAnInterval * step))));
            Refusal.Note(refusal?.Contains("is below what an MJD", StringComparison.Ordinal) != true, () => MjdText.Of(start));
        }
    }
}
