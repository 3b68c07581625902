using FsCheck;
using FsCheck.Fluent;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Numerics;

public class DegreeTrigonometryTests
{
    // tests/reference/degree_trigonometry.py, mpmath with 200 bits, rounded once; the script also checks every grid of LDEM products.
    [Theory]
    [InlineData(1, 8, 0x3f61df45b4769082)]
    [InlineData(1, 2048, 0x3ee1df46a251af5d)]
    [InlineData(5, 2, 0x3fa65547c4694e11)]
    [InlineData(89, 2, 0x3fe66dd943f43372)]
    [InlineData(45, 1, 0x3fe6a09e667f3bcd)]
    [InlineData(91, 2, 0x3fe6d2f29b1f2f46)]
    [InlineData(1, 3, 0x3f77d4555e817be2)]
    [InlineData(359999, 8000, 0x3fe6a09b2a485eb0)]
    public void Sin_AgainstMpmath_IsCorrectlyRounded(long numerator, long denominator, long expectedBits) =>
        Assert.Equal(expectedBits, BitConverter.DoubleToInt64Bits(DegreeTrigonometry.Sin(numerator, denominator)));

    [Theory]
    [InlineData(0, 0.0, 1.0)]
    [InlineData(90, 1.0, 0.0)]
    [InlineData(180, 0.0, -1.0)]
    [InlineData(270, -1.0, 0.0)]
    [InlineData(360, 0.0, 1.0)]
    [InlineData(-90, -1.0, 0.0)]
    public void SinCos_WholeQuarter_IsExactAndNeverMinusZero(long degrees, double sine, double cosine)
    {
        Assert.Equal(BitConverter.DoubleToInt64Bits(sine), BitConverter.DoubleToInt64Bits(DegreeTrigonometry.Sin(degrees, 1)));
        Assert.Equal(BitConverter.DoubleToInt64Bits(cosine), BitConverter.DoubleToInt64Bits(DegreeTrigonometry.Cos(degrees, 1)));
    }

    [Theory]
    [InlineData(30, 0.5)]
    [InlineData(150, 0.5)]
    [InlineData(-30, -0.5)]
    [InlineData(330, -0.5)]
    public void Sin_ThirtyDegrees_IsHalf(long degrees, double expected)
    {
        Assert.Equal(expected, DegreeTrigonometry.Sin(degrees, 1));
        Assert.Equal(expected, DegreeTrigonometry.Cos(90 - degrees, 1));
        Assert.Equal(expected, DegreeTrigonometry.Sin(degrees * 7, 7));
    }

    [Fact]
    public void SinCos_AnyAngle_KeepsSymmetriesBitForBit() =>
        Prop.ForAll(
            ArbMap.Default.ArbFor<int>(),
            Gen.Choose(1, 5000).ToArbitrary(),
            (numerator, d) =>
            {
                long n = numerator * 37L;
                double sine = DegreeTrigonometry.Sin(n, d);
                return sine == DegreeTrigonometry.Sin((180L * d) - n, d)
                    && sine == -DegreeTrigonometry.Sin(-n, d)
                    && sine == DegreeTrigonometry.Cos((90L * d) - n, d)
                    && sine == DegreeTrigonometry.Sin(n + (360L * d), d)
                    && Math.Abs((sine * sine) + Math.Pow(DegreeTrigonometry.Cos(n, d), 2) - 1.0) < 4e-16; // 2 ulps of 1
            })
            .Check(Config.QuickThrowOnFailure.WithMaxTest(2000).WithReplay(20120222UL, 1UL));

    [Theory]
    [InlineData(0)]
    [InlineData(-4)]
    public void Sin_DenominatorBelowOne_Throws(long denominator) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => DegreeTrigonometry.Sin(1, denominator));
}
