using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Xunit;

namespace Msisf.Core.Tests.Surface;

public class LatticePointTests
{
    private static readonly SineCosine Equator = new(Sine: 0.0, Cosine: 1.0);

    [Theory]
    [InlineData(1000.0, 128000)]
    [InlineData(1000.00390625, 128001)] // half a step: up
    [InlineData(1000.0039, 128000)]
    public void Nearest_HalfStep_GoesUp(double radius, int steps) =>
        Assert.Equal(new LatticePoint(steps, 0, 0), LatticePoint.Nearest(radius, Equator, Equator));

    [Fact]
    public void Nearest_HalfStepBelowZero_GoesUp()
    {
        SineCosine west = new(Sine: -1.0, Cosine: 0.0);
        Assert.Equal(new LatticePoint(0, -128000, 0), LatticePoint.Nearest(1000.00390625, Equator, west));
        Assert.Equal(new LatticePoint(0, 0, -128000), LatticePoint.Nearest(1000.00390625, west, Equator));
    }

    [Fact]
    public void PositionMoonMe_OneStep_Is2ToMinus7Metres() =>
        Assert.Equal(new Vector3D(0.0078125, -1.0, 2.0), new LatticePoint(1, -128, 256).PositionBodyFixed);
}
