using Msisf.Core.Errors;
using Msisf.Core.Time;
using Xunit;

namespace Msisf.Core.Tests.Time;

public sealed class DurationTests
{
    [Theory]
    [InlineData(0.1)]
    [InlineData(-1e-9)]
    [InlineData(599_616_069.1839)]
    [InlineData(12_622_780_800.000977)]
    public void TotalSeconds_OfADouble_IsThatDouble(double seconds) => Assert.Equal(seconds, Duration.OfSeconds(seconds).TotalSeconds);

    [Fact]
    public void OfDecimal_NumberAsPrinted_IsNotTheDoubleNextToIt()
    {
        Assert.Equal(Duration.OfSeconds(321_840), 10_000 * Duration.OfDecimal(32.184));
        Assert.NotEqual(Duration.OfSeconds(321_840), 10_000 * Duration.OfSeconds(32.184));
    }

    [Fact]
    public void OfDecimal_DaysAndMinutes_AreDecimalToo() =>
        Assert.Equal(Duration.OfDecimal(0.6, 60m), Duration.OfDecimal(0.1, 360m));

    [Theory]
    [InlineData(double.NaN)]
    [InlineData(double.NegativeInfinity)]
    [InlineData(2e16)]
    public void OfSeconds_NoLength_IsRefused(double seconds) => Assert.Throws<BadInputException>(() => Duration.OfSeconds(seconds));

    [Fact]
    public void Minus_NearTimes_LosesNothing() => Assert.Equal(
        1e-18, (Duration.OfSeconds(1e10) + new Duration(1) - Duration.OfSeconds(1e10)).TotalSeconds);

    [Theory]
    [InlineData(1.4999, 1.0)]
    [InlineData(1.5, 2.0)]
    [InlineData(-1.5, -1.0)]
    [InlineData(-1.6, -2.0)]
    public void RoundedTo_Seconds_IsTheNearest(double seconds, double expected) =>
        Assert.Equal(expected, Duration.OfSeconds(seconds).RoundedTo(Duration.OfSeconds(1)).TotalSeconds);
}
