using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Numerics;

/// <summary>Expected values: tests/reference/trigonometry.py (mpmath).</summary>
public sealed class TrigonometryTests
{
    [Theory]
    [InlineData(1e-09, 1e-09, 1.0)]
    [InlineData(0.1, 0.09983341664682815, 0.9950041652780258)]
    [InlineData(0.785398163397448, 0.7071067811865472, 0.7071067811865478)]
    [InlineData(1.0, 0.8414709848078965, 0.5403023058681398)]
    [InlineData(1.5707963267948966, 1.0, 6.123233995736766e-17)]
    [InlineData(2.5, 0.5984721441039565, -0.8011436155469337)]
    [InlineData(3.141592653589793, 1.2246467991473532e-16, -1.0)]
    [InlineData(-4.71238898038469, 1.0, -1.8369701987210297e-16)]
    [InlineData(100.0, -0.5063656411097588, 0.8623188722876839)]
    [InlineData(6283.185, -0.0003071795812458726, 0.9999999528203514)]
    [InlineData(-0.3, -0.29552020666133955, 0.955336489125606)]
    public void AccurateSinCos_EveryQuadrant_IsRoundedCorrectly(double angle, double sin, double cos) =>
        Assert.Equal((sin, cos), Trigonometry.AccurateSinCos(angle));

    [Theory]
    [InlineData(1.0, 3.0, 0.3217505543966422)]
    [InlineData(-2000000.0, 1000000.0, -1.1071487177940904)]
    [InlineData(1e-09, -1.0, 3.141592652589793)]
    [InlineData(0.3, 1e-20, 1.5707963267948966)]
    [InlineData(-7e-05, 3.3, -2.1212121208939718e-05)]
    [InlineData(5.0, 5.0, 0.7853981633974483)]
    [InlineData(1250000.0, -300000.0, 1.80634130751576)]
    [InlineData(0.0, -1.0, Math.PI)]
    [InlineData(0.0, 0.0, 0.0)]
    public void AccurateAtan2_EveryQuadrant_IsRoundedCorrectly(double y, double x, double angle) =>
        Assert.Equal(angle, Trigonometry.AccurateAtan2(y, x));

    /// <summary>What Windows gets and what Linux has: the same but where Linux's library rounds the wrong way.</summary>
    [Fact]
    public void Accurate_ManyAngles_AreThoseOfLinux()
    {
        const int Count = 20_000;
        SplitMix64 random = SplitMix64.For(7, 0, 0, 0);
        int others = 0;
        for (int i = 0; i < Count; i++)
        {
            double angle = 7.0 * ((2.0 * random.NextUniform()) - 1.0);
            (double sin, double cos) = Trigonometry.AccurateSinCos(angle);
            (double y, double x) = (Math.Sin(angle) * 1.7e6, Math.Cos(angle) * 1.7e6);
            others += (sin, cos) != Math.SinCos(angle) || Trigonometry.AccurateAtan2(y, x) != Math.Atan2(y, x) ? 1 : 0;
        }

        Assert.InRange(others, 0, OperatingSystem.IsLinux() ? Count / 100 : Count);
    }
}
