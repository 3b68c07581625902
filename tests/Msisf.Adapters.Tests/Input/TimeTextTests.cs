using Msisf.Adapters.Input;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Input;

public class TimeTextTests
{
    // python3 -c "from datetime import *; print((datetime.fromisoformat('2024-01-19T12:00:00+00:00') -
    //     datetime(1858, 11, 17, tzinfo=timezone.utc)) / timedelta(days=1))", and so on for each
    [Theory]
    [InlineData("55289", 55289.0)]
    [InlineData("+5.52895E4", 55289.5)]
    [InlineData("2024-01-19T12:00:00Z", 60328.5)]
    [InlineData("2024-01-19t12:00z", 60328.5)]
    [InlineData("2024-019T12:00:00Z", 60328.5)] // day of the year
    [InlineData("2024-366T00:00:00Z", 60675.0)]
    [InlineData("2024-01-19T14:30:00+02:30", 60328.5)]
    [InlineData("2024-01-18T22:00:00-14:00", 60328.5)]
    [InlineData("2024-01-19T14:00:00+0200", 60328.5)]
    [InlineData("2024-01-01T01:00:00+02:00", 60309.958333333336)] // the day, month and year before
    [InlineData("2000-02-29T06:00:00Z", 51603.25)]
    [InlineData("1858-11-17T00:00:00Z", 0.0)]
    [InlineData("1858-11-16T12:00:00Z", -0.5)]
    [InlineData("0001-01-01T00:00:00Z", -678575.0)]
    [InlineData("9999-12-31T18:00:00Z", 2973483.75)]
    [InlineData("2024-01-19T12:00:00.25Z", 60328.50000289352)]
    [InlineData("2024-01-19T12:00:00.000001Z", 60328.500000000015)]
    [InlineData("2016-12-31T23:59:59.999Z", 57753.999999988424)]
    public void TryParse_TimeOfEitherForm_IsTheMjd(string text, double mjd)
    {
        Assert.True(TimeText.TryParse(text, out CalendarTime found));
        Assert.Equal(mjd, found.Mjd);
        Assert.Equal(mjd, TimeText.Parse(text).Mjd);
    }

    [Theory]
    [InlineData("2016-12-31T23:59:60Z", "2016-12-31T23:59:60")]
    [InlineData("2017-01-01T00:59:60.5+01:00", "2016-12-31T23:59:60.5")]
    [InlineData("2016-12-31T23:59:60.123456789012345678Z", "2016-12-31T23:59:60.123456789012345678")]
    public void Parse_LeapSecond_IsExact(string text, string expected)
    {
        Assert.Equal(expected, TimeText.Parse(text).ToExactText());
        Assert.True(TimeText.Parse(text).IsLeapSecond);
    }

    /// <summary>What names a frame is read back as the same moment.</summary>
    [Theory]
    [InlineData("57753.1", "57753.1")]
    [InlineData("2016-12-31T02:24:00Z", "57753.1")]
    [InlineData("2016-12-31T02:24:01.25Z", "2016-12-31T02:24:01.25Z")]
    [InlineData("2016-12-31T23:59:60Z", "2016-12-31T23:59:60Z")]
    public void Of_Moment_IsItsMjdWhereThatNamesIt(string text, string expected)
    {
        string written = TimeText.Of(Moments.Naif0012.InstantOf(TimeText.Parse(text)));

        Assert.Equal(expected, written);
        Assert.Equal(TimeText.Parse(text), TimeText.Parse(written));
    }

    [Theory]
    [InlineData("2016-12-31T12:59:60Z", "'2016-12-31T12:59:60Z': hours are 00 to 23, minutes and seconds 00 to 59, but for a leap second")]
    [InlineData("2017-01-01T00:58:60.5+01:00", "'2017-01-01T00:58:60.5+01:00': hours are 00 to 23, minutes and seconds 00 to 59, but")]
    [InlineData("2460329", "'2460329' looks like a Julian Date; its MJD is 60328.5 (MJD = JD - 2400000.5)")]
    [InlineData("2455289.25", "'2455289.25' looks like a Julian Date; its MJD is 55288.75 ")]
    [InlineData("2024-01-19", "'2024-01-19' has no time of day; write e.g. 2024-01-19T00:00:00Z")]
    [InlineData("2024-01-19T12:00:00", "'2024-01-19T12:00:00' has no time zone; add Z for UTC, or an offset such as +02:00")]
    [InlineData("2023-02-29T12:00:00Z", "'2023-02-29T12:00:00Z': there is no such day in the calendar")]
    [InlineData("2023-366T12:00:00Z", "'2023-366T12:00:00Z': there is no such day")]
    [InlineData("2024-13-01T12:00:00Z", "'2024-13-01T12:00:00Z': there is no such day")]
    [InlineData("0000-01-01T12:00:00Z", "'0000-01-01T12:00:00Z': there is no such day")]
    [InlineData("2024-01-19T24:00:00Z", "'2024-01-19T24:00:00Z': hours are 00 to 23")]
    [InlineData("2024-01-19T12:60:00Z", "'2024-01-19T12:60:00Z': hours are 00 to 23, minutes and seconds 00 to 59")]
    [InlineData("2024-01-19T12:00:61Z", "'2024-01-19T12:00:61Z': hours are 00 to 23")]
    [InlineData("2024-01-19 12:00:00Z", "'2024-01-19 12:00:00Z' is not a time; write ISO 8601, e.g. 2024-01-19T12:00:00Z")]
    [InlineData("12:00", "'12:00' is not a time")]
    [InlineData("24-1-19T12:00:00Z", "'24-1-19T12:00:00Z' is not a time")]
    [InlineData("today", "'today' is not a number")]
    [InlineData("NaN", "'NaN' is not finite")]
    [InlineData("", "a number is missing")]
    public void ProblemWith_NoTime_SaysWhatToWrite(string text, string problem)
    {
        Assert.False(TimeText.TryParse(text, out _));
        Assert.StartsWith(problem, TimeText.ProblemWith(text), StringComparison.Ordinal);
    }
}
