using System.Runtime.Intrinsics;
using Msisf.Core.Illumination;
using Xunit;

namespace Msisf.Core.Tests.Illumination;

public sealed class DiscOfLightTests
{
    private const float Slope = 0.0046f;

    /// <summary>A level horizon leaves a segment of the disc: (acos(h) - h sqrt(1 - h h)) / pi.</summary>
    [Theory]
    [InlineData(-1.5, 1.0, true, true)]
    [InlineData(-0.5, 0.8044989, false, true)]
    [InlineData(0.0, 0.5, false, true)]
    [InlineData(0.7, 0.0940594, false, true)]
    [InlineData(1.0, 0.0, false, false)]
    public void AreaOver_LevelHorizon_IsTheSegment(double horizon, double expected, bool isWhole, bool isAny)
    {
        DiscOfLight disc = new(16, isDarkened: false);
        HorizonTable table = LevelAt(horizon);
        Assert.Equal(expected, disc.AreaOver(table, Discs(0.0f))[3], 0.003);
        Assert.Equal(expected, new DiscOfLight(64, isDarkened: false).AreaOver(table, Discs(0.0f))[3], 0.0005);
        Assert.Equal((isWhole ? 0xFFFFu : 0, isAny ? 0xFFFFu : 0), disc.SeeOver(table, Discs(0.0f)));
    }

    /// <summary>
    /// Sums by numpy over 4,000 x 4,000 points of Neckel's law at 0.7 um:
    /// <code>
    /// f=1/.7; g=.7**-5; A=[.75267-.265577*f,
    /// .93874+.265577*f-.004095*g,-1.89287+.012582*g,2.42234-.017117*g,-1.7115+.011977*g,.49062-.003347*g]
    /// I=lambda y,x: sum(a*(1-x*x-y*y)**(i/2) for i,a in enumerate(A))
    /// </code>
    /// Of the light above the horizon, that above the plane counts on it: with the horizon below the disc all above the plane.
    /// </summary>
    [Theory]
    [InlineData(-1.0, 1.0, 0.202290)]
    [InlineData(0.0, 0.5, 0.202290)]
    [InlineData(0.5, 0.179949, 0.124809)]
    public void Over_LevelHorizonAndDiscInThePlane_IsTheIntegral(double horizon, double expectedLight, double expectedUp)
    {
        DiscParts parts = new DiscOfLight(16, isDarkened: true).Over(LevelAt(horizon), Discs(0.0f));
        Assert.Equal(expectedLight, parts.Light[5], 0.003);
        Assert.Equal(expectedUp, parts.Up[5] / Slope, 0.003);
    }

    /// <summary>The whole disc through the plane: the integral above, less the level times the light over it; so are its strips.</summary>
    [Theory]
    [InlineData(0.0, 0.202290)]
    [InlineData(-0.5, 0.124809 - (0.5 * 0.179949))]
    [InlineData(0.5, 0.5 + 0.124809 - (0.5 * 0.179949))]
    [InlineData(1.0, 1.0)]
    [InlineData(-1.0, 0.0)]
    [InlineData(3.0, 3.0)]
    public void UpOf_WholeDisc_IsTheIntegral(double sine, double expected)
    {
        DiscOfLight disc = new(16, isDarkened: true);
        float height = (float)sine * Slope;
        Assert.Equal(expected, disc.UpOf(Vector512.Create(height), Vector512.Create(Slope))[0] / Slope, 0.003);
        Assert.Equal(expected, disc.Over(LevelAt(-10.0), Discs(height)).Up[0] / Slope, 0.003);
    }

    /// <summary>The part of the disc above a tilted horizon and the plane: each strip has its own horizon.</summary>
    [Fact]
    public void Over_TiltedHorizon_LetsOneSideThrough()
    {
        HorizonTable table = LevelAt(-2.0);
        for (int column = 0; column < 1000; column++)
        {
            table.Tangents[column] = 2.0f * Slope;
        }

        DiscParts parts = new DiscOfLight(16, isDarkened: true).Over(table, Discs(0.0f) with { Column = Vector512.Create(1000.0f) });
        Assert.Equal(0.5, parts.Area[0], 0.03);
        Assert.Equal(0.5, parts.Light[0], 0.03);
        Assert.Equal(0.101145, parts.Up[0] / Slope, 0.006);
    }

    private static HorizonTable LevelAt(double horizon)
    {
        HorizonTable table = new(32_768);
        Array.Fill(table.Tangents, (float)horizon * Slope);
        return table;
    }

    private static SeenBody Discs(float tangent) => new(
        Vector512.Create(tangent), Vector512.Create(20.25f), Vector512.Create(Slope), Vector512.Create(1.0f),
        Vector512.Create(Slope * (float)(32_768 / (2.0 * Math.PI))));
}
