using System.Globalization;
using Msisf.Core.Errors;
using Msisf.Core.Time;
using Xunit;

namespace Msisf.Core.Tests.Time;

public sealed class CalendarTimeTests
{
    /// <summary>Decimal fractions of a day are decimal seconds.</summary>
    [Theory]
    [InlineData(55289.0, "2010-04-03T00:00:00")]
    [InlineData(0.0, "1858-11-17T00:00:00")]
    [InlineData(-678575.0, "0001-01-01T00:00:00")]
    [InlineData(51544.5, "2000-01-01T12:00:00")]
    [InlineData(55289.1, "2010-04-03T02:24:00")]
    [InlineData(60369.00001157, "2024-02-29T00:00:00.999648")]
    [InlineData(55289.00000578704, "2010-04-03T00:00:00.500000256")]
    [InlineData(55289.99999999999, "2010-04-03T23:59:59.999999136")]
    public void OfMjd_KnownDays_AreTheCalendars(double days, string expected) =>
        Assert.Equal(expected, CalendarTime.OfMjd(days).ToString());

    [Fact]
    public void ToString_LastInstantOfTheCalendar_StaysInIt() => Assert.StartsWith(
        "9999-12-31T23:59:59.99", CalendarTime.OfMjd(Math.BitDecrement(2973484.0)).ToString(), StringComparison.Ordinal);

    [Fact]
    public void ToExactText_HasAllDecimals() => Assert.Equal(
        "2010-04-03T00:00:01.000000000000000001", new CalendarTime(55289, Duration.OfSeconds(1) + new Duration(0, 1)).ToExactText());

    [Fact]
    public void ToNanoseconds_IsPadded() =>
        Assert.Equal("2010-04-03T00:00:01.500000000", new CalendarTime(55289, Duration.OfSeconds(1.5)).ToNanoseconds());

    [Theory]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    [InlineData(2973484.0)]
    [InlineData(-678576.0)]
    [InlineData(1e9)]
    public void OfMjd_NoDate_IsRefused(double days) => Assert.Throws<BadInputException>(() => CalendarTime.OfMjd(days));

    [Fact]
    public void Mjd_OfOfMjd_IsTheSameDouble()
    {
        Random random = new(1);
        for (int i = 0; i < 10_000; i++)
        {
            double mjd = (random.NextDouble() * 292_000.0) - 94_553.0;
            Assert.Equal(mjd, CalendarTime.OfMjd(mjd).Mjd);
        }
    }

    /// <summary>Against decimals of 28 digits, whose text is rounded to a double once.</summary>
    [Fact]
    public void Mjd_OfAttoseconds_IsTheNearestDouble()
    {
        Random random = new(2);
        for (int i = 0; i < 10_000; i++)
        {
            int day = random.Next(-94_553, 197_000) >> random.Next(17);
            decimal seconds = random.Next(86_400) + (random.NextInt64(1_000_000_000_000_000_000) * 1e-18m);
            decimal days = day + (seconds / 86_400m);
            Assert.Equal(
                double.Parse(days.ToString(CultureInfo.InvariantCulture), CultureInfo.InvariantCulture),
                new CalendarTime(day, Duration.OfSeconds(seconds)).Mjd);
        }
    }

    [Fact]
    public void RoundedTo_EndOfALeapSecond_IsTheNextDay()
    {
        CalendarTime last = CalendarTime.InLeapSecond(57753, Duration.OfSeconds(0.999_999_999_9m));

        Assert.Equal("2017-01-01T00:00:00", last.ToString());
        Assert.Equal("2016-12-31T23:59:60.9999999999", last.ToExactText());
        Assert.Equal("2016-12-31T23:59:60.4", CalendarTime.InLeapSecond(57753, Duration.OfSeconds(0.4m)).ToString());
    }

    [Fact]
    public void Plus_ALeapSecond_CountsAsTheSecondAfterIt() => Assert.Equal(
        "2017-01-01T00:00:00.4", (CalendarTime.InLeapSecond(57753, Duration.OfSeconds(0.4m)) + default(Duration)).ToString());

    [Fact]
    public void CompareTo_ALeapSecond_StandsBetweenTheDays()
    {
        CalendarTime leap = CalendarTime.InLeapSecond(57753, Duration.OfSeconds(0.5));

        Assert.True(leap > CalendarTime.OfMjd(Math.BitDecrement(57754.0)) && leap < CalendarTime.OfMjd(57754.0));
    }
}
