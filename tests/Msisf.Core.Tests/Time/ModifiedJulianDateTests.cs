using Msisf.Core.Errors;
using Msisf.Core.Time;
using Xunit;

namespace Msisf.Core.Tests.Time;

public sealed class ModifiedJulianDateTests
{
    [Theory]
    [InlineData(55289.0, "2010-04-03T00:00:00Z")]
    [InlineData(0.0, "1858-11-17T00:00:00Z")]
    [InlineData(-678575.0, "0001-01-01T00:00:00Z")]
    [InlineData(51544.5, "2000-01-01T12:00:00Z")]
    [InlineData(55289.25, "2010-04-03T06:00:00Z")]
    [InlineData(60369.000011574074, "2024-02-29T00:00:01Z")]
    [InlineData(55289.00000578704, "2010-04-03T00:00:00.5Z")]
    [InlineData(55289.99999999999, "2010-04-03T23:59:59.999999Z")]
    public void ToIsoUtc_KnownDays_AreTheCalendars(double days, string expected) =>
        Assert.Equal(expected, new ModifiedJulianDate(days).ToIsoUtc());

    [Fact]
    public void ToIsoUtc_LastInstantOfTheCalendar_StaysInIt() =>
        Assert.StartsWith(
            "9999-12-31T23:59:59.99", new ModifiedJulianDate(Math.BitDecrement(2973484.0)).ToIsoUtc(), StringComparison.Ordinal);

    [Theory]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    [InlineData(2973484.0)]
    [InlineData(-678576.0)]
    [InlineData(1e9)]
    public void Constructor_NoDate_IsRefused(double days) =>
        Assert.Throws<BadInputException>(() => new ModifiedJulianDate(days));

    [Theory]
    [InlineData(-1e-20)]
    [InlineData(-1e-17)]
    public void SecondsOfDay_JustBeforeMidnight_StaysBelowAFullDay(double days)
    {
        ModifiedJulianDate time = new(days);

        Assert.Equal((0, 0.0), (time.DayNumber, time.SecondsOfDay));
    }

    [Theory]
    [InlineData(55289.5, 55289.0, 43200.0)]
    [InlineData(55289.0, 55290.25, -108000.0)]
    [InlineData(55290.125, 55289.75, 32400.0)]
    public void SecondsSince_DaysAndFractions_AreExact(double time, double epoch, double expected) =>
        Assert.Equal(expected, new ModifiedJulianDate(time).SecondsSince(new ModifiedJulianDate(epoch)));
}
