using System.Numerics;
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
        1e-18, (Duration.OfSeconds(1e10) + new Duration(0, 1) - Duration.OfSeconds(1e10)).TotalSeconds);

    [Theory]
    [InlineData(1.4999, 1.0)]
    [InlineData(1.5, 2.0)]
    [InlineData(-1.5, -1.0)]
    [InlineData(-1.6, -2.0)]
    public void RoundedTo_Seconds_IsTheNearest(double seconds, double expected) =>
        Assert.Equal(expected, Duration.OfSeconds(seconds).RoundedTo(Duration.OfSeconds(1)).TotalSeconds);

    /// <summary>Each operator against integers of any length, with carries and both signs.</summary>
    [Fact]
    public void Operators_RandomLengths_AreThoseOfWholeNumbers()
    {
        Random random = new(2026);
        for (int i = 0; i < 10_000; i++)
        {
            (Duration a, Duration b, long count) = (Any(random), Any(random), random.NextInt64(-1000, 1000));
            Assert.Equal(Attoseconds(a) + Attoseconds(b), Attoseconds(a + b));
            Assert.Equal(Attoseconds(a) - Attoseconds(b), Attoseconds(a - b));
            Assert.Equal(-Attoseconds(a), Attoseconds(-a));
            Assert.Equal(count * Attoseconds(a), Attoseconds(count * a));
            Assert.Equal(Attoseconds(a).CompareTo(Attoseconds(b)), a.CompareTo(b));
            Assert.Equal((double)Attoseconds(a) / 1e18, a.TotalSeconds, 1e-15 * Math.Abs(a.TotalSeconds));
            Assert.Equal((decimal)Attoseconds(a) / Duration.PerSecond, a.ToDecimalSeconds(18));

            BigInteger shift = Duration.PerSecond * (BigInteger)1e17; // division of integers rounds down only above 0
            BigInteger steps = BigInteger.Divide(Attoseconds(a) + 500_000 + shift, 1_000_000);
            Assert.Equal((steps * 1_000_000) - shift, Attoseconds(a.RoundedTo(new Duration(0, 1_000_000))));
        }
    }

    private static BigInteger Attoseconds(Duration length) => ((BigInteger)length.WholeSeconds * Duration.PerSecond) + length.Attoseconds;

    /// <summary>A length of up to 16 digits of seconds, often near a whole second.</summary>
    private static Duration Any(Random random)
    {
        long seconds = random.NextInt64(-5, 5) * (long)Math.Pow(10.0, random.Next(10));
        return new Duration(seconds, random.Next(3) switch
        {
            0 => random.Next(3),
            1 => Duration.PerSecond - 1 - random.Next(3),
            _ => random.NextInt64(Duration.PerSecond),
        });
    }
}
