using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Numerics;

/// <summary>Expected values: tests/reference/portable_math.py (mpmath).</summary>
public sealed class PortableMathTests
{
    private const double SineTolerance = 4e-16; // 1: two ulps at 1
    private const double RelativePower = 1e-14; // 1: the error of the logarithm times the exponent

    [Theory]
    [InlineData(0.125, 0.0021816598343367697327, 0.99999762017735184291)]
    [InlineData(29.375, 0.49052356815930799396, 0.87142792535026138257)]
    [InlineData(45.0, 0.7071067811865475244, 0.7071067811865475244)]
    [InlineData(89.9921875, 0.99999999070381410783, 0.00013635384738953342581)]
    [InlineData(134.5, 0.71325044915418157514, -0.70090926429985090017)]
    [InlineData(270.25, -0.99999048072073448332, 0.0043633092847465708069)]
    [InlineData(-90.25, -0.99999048072073448332, -0.0043633092847465708069)]
    [InlineData(359.875, -0.0021816598343367697327, 0.99999762017735184291)]
    public void SinCosDegrees_EveryQuadrant_IsExact(double degrees, double sin, double cos)
    {
        (double actualSin, double actualCos) = PortableMath.SinCosDegrees(degrees);
        Assert.Equal(sin, actualSin, SineTolerance);
        Assert.Equal(cos, actualCos, SineTolerance);
    }

    [Fact]
    public void SinCosDegrees_MirrorLatitudes_AreTheSamePlaces()
    {
        (double sin, double cos) = PortableMath.SinCosDegrees(89.875);
        Assert.Equal((sin, -cos), PortableMath.SinCosDegrees(90.125));
    }

    [Theory]
    [InlineData(0.0442, -1.83, 301.21545213360106806)]
    [InlineData(150.0, 0.301, 4.5185955363924324646)]
    [InlineData(7.5, 1.01, 7.6526504412894918749)]
    [InlineData(27.88, -0.24, 0.44991423619536508349)]
    public void Pow_CraterAndSlopeLaws_IsExact(double value, double exponent, double expected) =>
        Assert.Equal(1.0, PortableMath.Pow(value, exponent) / expected, RelativePower);

    [Theory]
    [InlineData(3.0, 1.5849625007211561815)]
    [InlineData(0.7, -0.51457317282975824043)]
    [InlineData(1740000.0, 20.730655875398177694)]
    [InlineData(64.0, 6.0)]
    public void Log2_AnyMagnitude_IsExact(double value, double expected) =>
        Assert.Equal(expected, PortableMath.Log2(value), 4e-15); // an ulp of 20.7
}
