using System.Globalization;
using Msisf.Core.Errors;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Ephemeris;

public class TimeScaleTests
{
    /// <summary>s: utc2et_c's own sums round by up to two units in the last place of 9e8.</summary>
    private const double TdbTolerance = 3e-7;

    private static readonly TimeScale Scale = Moments.Naif0012;

    // tests/reference/ephemeris.py, CSPICE N0067, utc2et_c: half a second before the leap second, and just after it.
    [Theory]
    [InlineData(41317, -883655959.3160794, -883655957.8160794)]
    [InlineData(41499, -867931158.3159056, -867931156.8159056)]
    [InlineData(41683, -852033557.3160579, -852033555.8160579)]
    [InlineData(42048, -820497556.3160654, -820497554.8160654)]
    [InlineData(42413, -788961555.316073, -788961553.816073)]
    [InlineData(42778, -757425554.3160805, -757425552.8160805)]
    [InlineData(43144, -725803153.316059, -725803151.816059)]
    [InlineData(43509, -694267152.3160665, -694267150.8160665)]
    [InlineData(43874, -662731151.3160741, -662731149.8160741)]
    [InlineData(44239, -631195150.3160816, -631195148.8160816)]
    [InlineData(44786, -583934349.3158962, -583934347.8158962)]
    [InlineData(45151, -552398348.3158889, -552398346.8158889)]
    [InlineData(45516, -520862347.31588167, -520862345.81588167)]
    [InlineData(46247, -457703946.3158951, -457703944.8158951)]
    [InlineData(47161, -378734345.31608385, -378734343.81608385)]
    [InlineData(47892, -315575944.3160699, -315575942.8160699)]
    [InlineData(48257, -284039943.3160774, -284039941.8160774)]
    [InlineData(48804, -236779142.3159002, -236779140.8159002)]
    [InlineData(49169, -205243141.31589296, -205243139.81589296)]
    [InlineData(49534, -173707140.3158857, -173707138.8158857)]
    [InlineData(50083, -126273539.31608607, -126273537.81608607)]
    [InlineData(50630, -79012738.31589186, -79012736.81589186)]
    [InlineData(51179, -31579137.316079672, -31579135.816079672)]
    [InlineData(53736, 189345663.6839256, 189345665.1839256)]
    [InlineData(54832, 284040064.683932, 284040066.183932)]
    [InlineData(56109, 394372865.6841052, 394372867.1841052)]
    [InlineData(57204, 488980866.684127, 488980868.184127)]
    [InlineData(57754, 536500867.6839298, 536500869.1839298)]
    public void InstantOf_BothSidesOfALeapSecond_AreCSpices(int dayAfter, double halfASecondBefore, double after)
    {
        Assert.Equal(halfASecondBefore, Moments.OfMjd(dayAfter - (0.5 / 86400.0)).Tdb.Seconds, TdbTolerance);
        Assert.Equal(after, Moments.OfMjd(dayAfter).Tdb.Seconds, TdbTolerance);
    }

    [Fact]
    public void InstantOf_BeforeTheFirstLeapSecond_CountsOneLess()
    {
        // CSPICE N0067: utc2et_c("1901-04-03T12:00:00.123456789").
        Assert.Equal(-3116188758.690886, Moments.OfMjd(15477.0 + (43200.123456789 / 86400.0)).Tdb.Seconds, 5e-7);
    }

    /// <summary>astropy 7.1 (erfa): Time(text, scale="utc").tai and .tt, in ISO.</summary>
    [Theory]
    [InlineData("2016-12-31T23:59:60.25Z", "2017-01-01T00:00:36.25", "2017-01-01T00:01:08.434", "2017-01-01T00:00:17.25")]
    [InlineData(
        "1999-01-01T00:00:00.123456789Z", "1999-01-01T00:00:32.123456789", "1999-01-01T00:01:04.307456789",
        "1999-01-01T00:00:13.123456789")]
    [InlineData(
        "2400-06-01T12:00:00.000000001Z", "2400-06-01T12:00:37.000000001", "2400-06-01T12:01:09.184000001",
        "2400-06-01T12:00:18.000000001")]
    public void CalendarOf_OtherSystems_AreThoseOfAstropy(string utc, string tai, string tt, string gps)
    {
        Instant moment = Scale.InstantOf(Parse(utc));

        Assert.Equal(tai, Scale.CalendarOf(moment, TimeSystem.Tai).ToString());
        Assert.Equal(tt, Scale.CalendarOf(moment, TimeSystem.Tt).ToString());
        Assert.Equal(gps, Scale.CalendarOf(moment, TimeSystem.Gps).ToString());
        Assert.Equal(utc, moment.ToIsoUtc());
    }

    [Fact]
    public void SecondsSince_OverALeapSecond_CountsIt() => Assert.Equal(
        2.0, Moments.OfMjd(57754.0).SecondsSince(Scale.InstantOf(Parse("2016-12-31T23:59:59Z"))));

    [Fact]
    public void After_IntoALeapSecond_IsNamedSo()
    {
        Instant before = Scale.InstantOf(Parse("2016-12-31T23:59:59.75Z"));

        Assert.Equal("2016-12-31T23:59:60.75Z", before.After(1.0).ToIsoUtc());
        Assert.Equal("2017-01-01T00:00:00.75Z", before.After(2.0).ToIsoUtc());
        Assert.Equal(Math.BitDecrement(57754.0), before.After(1.0).Mjd);
    }

    /// <summary>As in CSPICE: TAI - UTC is 9 s before 1972, so that the first day of 1972 comes after a leap second.</summary>
    [Fact]
    public void InstantOf_EndOf1971_HasALeapSecond() => Assert.Equal(
        1.5, Moments.OfMjd(41317.0).SecondsSince(Scale.InstantOf(Parse("1971-12-31T23:59:59.5Z"))));

    [Theory]
    [InlineData("2017-12-31T23:59:60Z", TimeSystem.Utc)]
    [InlineData("2016-12-31T23:59:60Z", TimeSystem.Tai)]
    public void InstantOf_LeapSecondThatWasNot_IsRefused(string time, TimeSystem system) => Assert.Contains(
        "there was no leap second then",
        Assert.Throws<BadInputException>(() => Scale.InstantOf(Parse(time), system)).Message, StringComparison.Ordinal);

    [Fact]
    public void InstantOf_EveryLeapSecond_ComesBackToTheAttosecond()
    {
        foreach (TimeSystem system in Enum.GetValues<TimeSystem>())
        {
            for (int day = 41000; day < 58000; day++)
            {
                CalendarTime time = new(day, Duration.Day - new Duration(0, 7_000_000_000L));
                Assert.Equal(time, Scale.CalendarOf(Scale.InstantOf(time, system), system));
                CalendarTime leap = CalendarTime.InLeapSecond(day, new Duration(0, 123_456_789_000_000_001L));
                if (Scale.HasMoment(leap, system))
                {
                    Assert.Equal(leap, Scale.CalendarOf(Scale.InstantOf(leap, system), system));
                }
            }
        }
    }

    /// <summary>Random moments of 1600 to 2400, to the attosecond; TDB as two doubles to 1e-15 s.</summary>
    [Fact]
    public void InstantOf_RandomMoments_ComeBack()
    {
        Random random = new(43);
        for (int i = 0; i < 10_000; i++)
        {
            Duration fraction = new(0, random.NextInt64(Duration.PerSecond));
            CalendarTime time = new(random.Next(-94_553, 197_642), fraction + Duration.OfSeconds(random.Next(86_400)));
            foreach (TimeSystem system in Enum.GetValues<TimeSystem>())
            {
                Instant moment = Scale.InstantOf(time, system);
                Assert.Equal(time, Scale.CalendarOf(moment, system));
                Assert.InRange(Math.Abs(Scale.InstantOf(moment.Tdb).SecondsSince(moment)), 0.0, 1e-15);
                Assert.Equal(moment.Tdb.Seconds, moment.Tdb.Seconds + moment.Tdb.Rest);
            }
        }
    }

    private static CalendarTime Parse(string text)
    {
        string[] parts = text.TrimEnd('Z').Split('T', ':');
        decimal second = decimal.Parse(parts[3], CultureInfo.InvariantCulture);
        CalendarTime minute = CalendarTime.Of(
            DateOnly.Parse(parts[0], CultureInfo.InvariantCulture),
            60 * ((60 * int.Parse(parts[1], CultureInfo.InvariantCulture)) + int.Parse(parts[2], CultureInfo.InvariantCulture)));
        return second < 60m
            ? minute + Duration.OfSeconds(second)
            : CalendarTime.InLeapSecond(minute.DayNumber, Duration.OfSeconds(second - 60m));
    }

    [Fact]
    public void Constructor_NoLeapSeconds_IsABug() =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new TimeScale(default, []));
}
