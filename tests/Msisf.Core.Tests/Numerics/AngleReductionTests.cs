using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Numerics;

public class AngleReductionTests
{
    // mpmath, 60 digits: a - 2 pi nint(a / (2 pi)) for the double a.
    [Theory]
    [InlineData(0.5, 0.5)]
    [InlineData(3.141592653589793, 3.141592653589793)]
    [InlineData(4.0, -2.2831853071795867)]
    [InlineData(6.283185307179586, -2.4492935982947064e-16)]
    [InlineData(6283185.307179586, -4.463824362721742e-10)]
    [InlineData(1653765.788776203, 9.102615980712617e-16)] // as near to a multiple of 2 pi as doubles come below 1e6 turns
    [InlineData(6794693.139851769, 2.01525464535881e-16)]
    [InlineData(1e15, 2.1096981170701126)]
    [InlineData(1e22, -1.020177392559087)]
    [InlineData(-1e300, 2.1838724841522326)]
    public void ToHalfTurn_LargeAngle_KeepsTheDigitsItHas(double angle, double expected) =>
        Assert.Equal(1.0, AngleReduction.ToHalfTurn(angle) / expected, 4e-16);

    [Fact]
    public void ToHalfTurn_WithCorrection_CountsIt()
    {
        // mpmath: 6283185.307179586 + 1e-10 less a million turns.
        Assert.Equal(-3.463824362721742365e-10, AngleReduction.ToHalfTurn(6283185.307179586, 1e-10), 1e-25);
    }

    [Theory]
    [InlineData(-1e-300, 0.0)]
    [InlineData(-1e-17, 0.0)]
    [InlineData(3.0, 3.0)]
    [InlineData(-0.0, 0.0)]
    [InlineData(6.283185307179586, 6.283185307179586)]
    [InlineData(-1.0, 5.283185307179586)]
    [InlineData(7.0, 0.7168146928204138)]
    public void ToFullTurn_AnyAngle_IsNotNegative(double angle, double expected)
    {
        double actual = AngleReduction.ToFullTurn(angle);
        Assert.Equal(0.0, Math.IEEERemainder(actual - expected, 2.0 * Math.PI), Rounding.OfUnits);
        Assert.InRange(actual, 0.0, Math.BitDecrement(2.0 * Math.PI));
        Assert.False(double.IsNegative(actual));
    }
}
