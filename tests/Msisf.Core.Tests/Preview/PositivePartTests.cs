using Msisf.Core.Preview;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Preview;

public sealed class PositivePartTests
{
    /// <summary>Counted by hand: the border cuts the edges in halves, or in one and two thirds.</summary>
    [Theory]
    [InlineData(1.0, 2.0, 0.0, 1.0)]
    [InlineData(-1.0, -2.0, -3.0, 0.0)]
    [InlineData(1.0, -1.0, -1.0, 0.25)]
    [InlineData(-1.0, 1.0, -1.0, 0.25)]
    [InlineData(-1.0, -1.0, 1.0, 0.25)]
    [InlineData(-1.0, 1.0, 1.0, 0.75)]
    [InlineData(1.0, -1.0, 1.0, 0.75)]
    [InlineData(1.0, 1.0, -1.0, 0.75)]
    [InlineData(1.0, -2.0, -1.0, 1.0 / 6.0)]
    [InlineData(0.0, -1.0, -1.0, 0.0)]
    public void OfTriangle_IsTheAreaOfTheCorner(double a, double b, double c, double expected) =>
        Assert.Equal(expected, PositivePart.OfTriangle(a, b, c), Rounding.OfUnits);
}
