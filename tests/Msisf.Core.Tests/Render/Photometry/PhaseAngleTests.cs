using Msisf.Core.Render.Photometry;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Photometry;

public class PhaseAngleTests
{
    [Theory]
    [InlineData(0.0, 0.0)]
    [InlineData(60.0, 0.25)]
    [InlineData(90.0, 0.5)]
    [InlineData(120.0, 0.75)]
    [InlineData(180.0, 1.0)]
    public void FromHaversine_KnownAngle_IsIt(double degrees, double haversine) =>
        Assert.Equal(degrees, double.RadiansToDegrees(PhaseAngle.FromHaversine(haversine)), 12);

    /// <summary>hav(1e-9) = 2.5e-19 (1 - 1e-18 / 12 ...); a cosine of that angle is 1.</summary>
    [Fact]
    public void FromHaversine_NearOpposition_KeepsItsDigits() =>
        Assert.InRange(PhaseAngle.FromHaversine(2.5e-19), 1e-9 * (1.0 - Rounding.OfUnits), 1e-9 * (1.0 + Rounding.OfUnits));

    [Fact]
    public void HalfTangent_RightAngleAndBackwards_IsOneAndInfinite()
    {
        Assert.Equal(1.0, PhaseAngle.HalfTangent(0.5));
        Assert.Equal(double.PositiveInfinity, PhaseAngle.HalfTangent(1.0));
    }
}
