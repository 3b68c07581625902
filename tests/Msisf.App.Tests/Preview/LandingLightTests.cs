using Msisf.App.Preview;
using Xunit;

namespace Msisf.App.Tests.Preview;

public sealed class LandingLightTests
{
    [Theory]
    [InlineData(true, 15_000.0, 4_000.0, 990.0)]
    [InlineData(true, 3_000.0, 100.0, 100.0)]
    [InlineData(false, 15_000.0, 4_000.0, 1_000.0)] // not low
    [InlineData(false, 900.0, 700.0, 450.0)] // not from high
    [InlineData(false, 15_000.0, 300.0, 900.0)] // goes up again
    [InlineData(false, 500.0)] // one frame
    public void IsLanding_Heights_ComeDownToTheGround(bool isLanding, params double[] heights) =>
        Assert.Equal(isLanding, LandingLight.IsLanding(heights));
}
