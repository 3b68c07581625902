using System.Runtime.Intrinsics;
using Msisf.Core.Illumination;
using Xunit;

namespace Msisf.Core.Tests.Illumination;

public sealed class DiscOfLightTests
{
    /// <summary>A level horizon leaves a segment of the disc: (acos(h) - h sqrt(1 - h h)) / pi.</summary>
    [Theory]
    [InlineData(-1.5, 1.0)]
    [InlineData(-0.5, 0.8044989)]
    [InlineData(0.0, 0.5)]
    [InlineData(0.7, 0.0940594)]
    [InlineData(1.0, 0.0)]
    public void AreaOver_LevelHorizon_IsTheSegment(double horizon, double expected) =>
        Assert.Equal(expected, new DiscOfLight(isDarkened: false).AreaOver(Vector512.Create((float)horizon)), 0.003);

    /// <summary>
    /// Sums by numpy over 4,000 x 4,000 points of Neckel's law at 0.7 um:
    /// <code>
    /// f=1/.7; g=.7**-5; A=[.75267-.265577*f,
    /// .93874+.265577*f-.004095*g,-1.89287+.012582*g,2.42234-.017117*g,-1.7115+.011977*g,.49062-.003347*g]
    /// I=lambda y,x: sum(a*(1-x*x-y*y)**(i/2) for i,a in enumerate(A))
    /// </code>
    /// </summary>
    [Theory]
    [InlineData(-1.0, 1.0, 0.0)]
    [InlineData(0.0, 0.5, 0.202290)]
    [InlineData(0.5, 0.179949, 0.124809)]
    public void LightOver_LevelHorizon_IsTheIntegral(double horizon, double expectedLight, double expectedMoment)
    {
        (float light, float moment) = new DiscOfLight(isDarkened: true).LightOver(Vector512.Create((float)horizon));
        Assert.Equal(expectedLight, light, 0.003);
        Assert.Equal(expectedMoment, moment, 0.003);
    }
}
