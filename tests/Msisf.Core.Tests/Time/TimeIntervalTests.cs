using Msisf.Core.Errors;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Time;

public class TimeIntervalTests
{
    // Counted by hand, as MATLAB's colon does.
    [Theory]
    [InlineData(55289.0, 0.1, 55290.0, 11)]
    [InlineData(55289.0, 0.3, 55290.0, 4)]
    [InlineData(55289.0, 1.0, 55289.0, 1)]
    [InlineData(55289.0, 5.0, 55290.0, 1)]
    [InlineData(0.0, 0.1, 0.3, 4)] // 0.3 / 0.1 is 2.9999999999999996
    [InlineData(55289.1, 0.0001, 55289.2, 1001)] // both ends are rounded to 7e-12 days, 7e-8 of a step
    [InlineData(55290.0, -0.25, 55289.0, 5)]
    [InlineData(55289.0, 1.0, 55298.999999995, 10)] // 5e-9 of a step short of the tenth
    [InlineData(55289.0, 1.0, 55298.9999999999, 11)] // within 1e-9 of a step
    public void Count_WholeStepsReachTheEnd_IncludesIt(double start, double step, double end, int expected) =>
        Assert.Equal(expected, Interval(start, step, end).Count);

    [Theory]
    [InlineData(55290.0, 0.1, 55289.0)]
    [InlineData(55289.0, -0.1, 55290.0)]
    public void Count_StepLeadsAway_Empty(double start, double step, double end)
    {
        TimeInterval interval = Interval(start, step, end);
        Assert.Equal((0, false), (interval.Count, interval.GetEnumerator().MoveNext()));
    }

    [Fact]
    public void GetEnumerator_ManySteps_CountsByIntegerAndDoesNotDrift()
    {
        // Adding up 0.1 a million times would be 1.3e-6 days off; 55289 + 100000 is exact.
        TimeInterval interval = Interval(55289.0, 0.1, 155289.0);
        Assert.Equal(1_000_001, interval.Count);
        Assert.Equal(155289.0, interval[^1].Mjd);
        Assert.Equal(55289.3, interval.Skip(3).First().Mjd);
    }

    [Fact]
    public void GetEnumerator_CountingDown_Falls() =>
        Assert.Equal([3.0, 2.5, 2.0], Interval(3.0, -0.5, 2.0).Select(time => time.Mjd));

    [Fact]
    public void Indexer_StepsBelowWhatAnMjdHolds_AreExact()
    {
        CalendarTime start = CalendarTime.OfMjd(55289.0);
        TimeInterval interval = new(start, Duration.OfSeconds(1e-9m), start + Duration.OfSeconds(1e-6m));

        Assert.Equal(1001, interval.Count);
        Assert.Equal("2010-04-03T00:00:00.000000999", interval[999].ToString());
    }

    // A clock's day has 86 400 s; the last one of 2016 had one more.
    [Fact]
    public void Indexer_DaysOverALeapSecond_AreThoseOfTheClock() => Assert.Equal(
        ["2016-12-31T12:00:00", "2017-01-01T12:00:00", "2017-01-02T12:00:00"],
        Interval(57753.5, 1.0, 57755.5).Select(time => time.ToString()));

    [Fact]
    public void Constructor_StartInALeapSecond_Refused() => Assert.Contains(
        "begins in a leap second",
        Assert.Throws<BadInputException>(() => new TimeInterval(
            CalendarTime.InLeapSecond(57753, Duration.OfSeconds(0.5)), Duration.Day, CalendarTime.OfMjd(57755.0))).Message,
        StringComparison.Ordinal);

    [Theory]
    [InlineData(0.0, "step of the time interval is 0")]
    [InlineData(double.NaN, "NaN s is not a length of time")]
    [InlineData(double.PositiveInfinity, "Infinity s is not a length of time")]
    [InlineData(1e300, "is not a length of time")]
    [InlineData(5e-324, "step of the time interval is 0")]
    [InlineData(1e-8, "has 100000001 times, at most 10000000")]
    public void Constructor_WrongStep_RefusedWithTheReason(double step, string reason) =>
        Assert.Contains(reason, Assert.Throws<BadInputException>(() => Interval(55289.0, step, 55290.0)).Message, StringComparison.Ordinal);

    [Theory]
    [InlineData(-1)]
    [InlineData(11)]
    public void Indexer_OutsideTheCount_Refused(int index) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => Interval(55289.0, 0.1, 55290.0)[index]);

    private static TimeInterval Interval(double start, double step, double end) =>
        new(CalendarTime.OfMjd(start), Duration.OfDecimal(step, 86_400m), CalendarTime.OfMjd(end));
}
