using System.Globalization;
using Msisf.Core.Ephemeris;
using Msisf.Core.Time;
using Msisf.Stress.Reference;

namespace Msisf.Stress.Time;

/// <summary>UTC to TDB around leap seconds, and the smallest steps of time.</summary>
public sealed class TimeStress : IStressTest
{
    private const double SecondsADay = 86400.0;

    /// <summary>
    /// ulp: one rounding; the whole second at which SPICE takes the Earth's anomaly makes 2e-10 s, a hundredth at most.
    /// </summary>
    private const double TdbError = 1.05;

    /// <summary>s: two roundings of the rest that a double of TDB leaves, and TDB - TT's change of 3.3e-10 in each second.</summary>
    private const double TdbStepError = 1e-14;

    /// <summary>s: of two roundings of TDB, of which each is at most half of 1.2e-7 s.</summary>
    private const double LeapError = 1.3e-7;

    private static readonly Duration Microsecond = Duration.OfSeconds(1e-6m);

    private const int StepsOfAnInterval = 1000;
    private const double FirstMjd = -94_553.0; // 1600-01-01
    private const double LastMjd = 197_640.0; // 2399-12-31

    /// <inheritdoc/>
    public string Name => "time";

    /// <inheritdoc/>
    public string Subject =>
        "UTC to TDB next to all 28 leap seconds, against IERS's dates and mpmath; "
            + "intervals of 1,000 steps of 1e-6 s from random times of 1600 to 2400.";

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int intervals = length == StressLength.Full ? 10_000 : 100;
        TimeScale scale = ProjectKernels.ReadScale();
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
                all.Place.ToFigure("a step of 1e-6 s in UTC: difference from its place", "s", 0.0),
                all.TdbStep.ToFigure("length of a step of 1e-6 s in TDB: difference", "s", TdbStepError),
                all.Order.ToFigure("steps of 1e-6 s that stand still or go back, in UTC or TDB", "", 0.0),
            ],
            [all.OverDate.ToSeries("length of a step of 1e-6 s in TDB: difference", "s", "MJD", "", TdbStepError)]);
    }

    private sealed class Found(TimeScale scale) : IMeasure<Found>
    {
        public WorstCase Tdb { get; } = new();

        public WorstCase Leap { get; } = new();

        public WorstCase Place { get; } = new();

        public WorstCase TdbStep { get; } = new();

        public CaseCount Order { get; } = new();

        public SeriesBuilder OverDate { get; } = new(FirstMjd, LastMjd, 48, isLogarithmic: false);

        public void NoteLeapSeconds(double[][] rows)
        {
            foreach (double[] row in rows)
            {
                double found = ProjectKernels.OfMjd(row[0]).Tdb.Seconds;
                double late = LateInPrint(row[0]);
                Tdb.Note(Math.Abs(found - row[1] - late) / Ulp.Of(row[1]), () => MjdText.Of(row[0]));
                if (row[0] == Math.Floor(row[0]))
                {
                    double before = Math.BitDecrement(row[0]);
                    double seconds = found - ProjectKernels.OfMjd(before).Tdb.Seconds - (SecondsADay * (row[0] - before))
                        + LateInPrint(before);
                    Leap.Note(Math.Abs(seconds - 1.0), () => MjdText.Of(before));
                }
            }
        }

        /// <summary>
        /// s: by how much the decimal number that an MJD prints, as which it is read, is later than the double, of which
        /// leap_seconds.csv speaks. A double of these days has at most 37 binary digits behind the point.
        /// </summary>
        private static double LateInPrint(double mjd)
        {
            decimal unit = 1L << 37;
            decimal exact = (decimal)((mjd - Math.Floor(mjd)) * (double)unit) / unit;
            decimal printed = decimal.Parse(mjd.ToString("R", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
            return (double)((printed - (decimal)Math.Floor(mjd) - exact) * (decimal)SecondsADay);
        }

        public void Try(int number, CaseRandom random)
        {
            NoteInterval(random.Between(FirstMjd, LastMjd));
        }

        public void Add(Found other)
        {
            Tdb.Add(other.Tdb);
            Leap.Add(other.Leap);
            Place.Add(other.Place);
            TdbStep.Add(other.TdbStep);
            Order.Add(other.Order);
            OverDate.Add(other.OverDate);
        }

        private void NoteInterval(double start)
        {
            CalendarTime first = CalendarTime.OfMjd(start);
            TimeInterval interval = new(first, Microsecond, first + (StepsOfAnInterval * Microsecond));
            CalendarTime previous = interval[0];
            for (int index = 1; index < interval.Count; index++)
            {
                CalendarTime time = interval[index];
                double tdbSeconds = scale.InstantOf(time).Tdb - scale.InstantOf(previous).Tdb;
                string Text() => time.ToExactText();
                Place.Note(Math.Abs((time - first - (index * Microsecond)).TotalSeconds), Text);
                TdbStep.Note(Math.Abs(tdbSeconds - Microsecond.TotalSeconds), Text);
                Order.Note(time <= previous || tdbSeconds <= 0.0, Text);
                OverDate.Add(start, Math.Abs(tdbSeconds - Microsecond.TotalSeconds));
                previous = time;
            }
        }
    }
}
