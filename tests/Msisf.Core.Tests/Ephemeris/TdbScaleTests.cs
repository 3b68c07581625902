using Msisf.Core.Ephemeris;
using Msisf.Core.Time;
using Xunit;

namespace Msisf.Core.Tests.Ephemeris;

public class TdbScaleTests
{
    /// <summary>s: utc2et_c's own sums round by up to two units in the last place of 9e8.</summary>
    private const double TdbTolerance = 3e-7;

    private static readonly TdbScale Scale = SampleScale.Naif0012;

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
    public void FromUtc_BothSidesOfALeapSecond_AreCSpices(int dayAfter, double halfASecondBefore, double after)
    {
        Assert.Equal(halfASecondBefore, Scale.FromUtc(new ModifiedJulianDate(dayAfter - (0.5 / 86400.0))), TdbTolerance);
        Assert.Equal(after, Scale.FromUtc(new ModifiedJulianDate(dayAfter)), TdbTolerance);
    }

    [Fact]
    public void FromUtc_BeforeTheFirstLeapSecond_CountsOneLess()
    {
        // CSPICE N0067: utc2et_c("1901-04-03T12:00:00.123456789").
        Assert.Equal(-3116188758.690886, Scale.FromUtc(new ModifiedJulianDate(15477.0 + (43200.123456789 / 86400.0))), 5e-7);
    }

    [Fact]
    public void FromUtc_NearlyBetweenTwoDoubles_RoundsAsCSpice()
    {
        // CSPICE N0067: u + deltet_c(u, "UTC") for u = -1152073943.6425798; a random time at which 6e-11 s decide.
        Assert.Equal(-1152073902.4584477, Scale.FromUtc(new ModifiedJulianDate(38210.31083747014)));
    }

    [Theory]
    [InlineData(15100)]
    [InlineData(55289)]
    [InlineData(69000)]
    public void FromUtc_OneMicrosecondLater_IsThatMuchLater(int day)
    {
        // A fraction of a day near zero is exact far below a microsecond, so only the scale's own rounding counts.
        double tenMicroseconds = Scale.FromUtc(new ModifiedJulianDate(day + 0.25 + (10e-6 / 86400.0)))
            - Scale.FromUtc(new ModifiedJulianDate(day + 0.25));

        Assert.Equal(10e-6, tenMicroseconds, 1e-6);
    }

    [Theory]
    [InlineData(15020.5)]
    [InlineData(41316.9)]
    [InlineData(57753.999)]
    [InlineData(57754.001)]
    [InlineData(69000.25)]
    public void ToUtcSeconds_OfFromUtc_IsTheSameTime(double mjd)
    {
        ModifiedJulianDate time = new(mjd);

        Assert.Equal((mjd - 51544.5) * 86400.0, Scale.ToUtcSeconds(Scale.FromUtc(time)), 2e-6); // s: ulps of 1e9 s and of a day of an MJD
    }

    [Fact]
    public void Constructor_NoLeapSeconds_IsABug() =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new TdbScale(default, []));
}
