using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Numerics;

public class AnglesTests
{
    [Theory]
    [InlineData(0.0, 0.0)]
    [InlineData(3.0, 3.0)]
    [InlineData(-1.0, 5.2831853071795862)]
    [InlineData(-1e-17, 0.0)]
    public void OnFullTurn_AnyAngle_IsFrom0ToBelow2Pi(double angle, double expected) =>
        Assert.Equal(expected, Angles.OnFullTurn(angle));

    [Fact]
    public void OnFullTurn_MinusZero_IsPlusZero() => Assert.False(double.IsNegative(Angles.OnFullTurn(-0.0)));
}
