using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Synthesis.Tests;

public sealed class SyntheticShapeTests
{
    [Theory]
    [InlineData(1UL)]
    [InlineData(2UL)]
    [InlineData(12345UL)]
    public void RadiusBounds_AnySeed_AreLikeTheMoons(ulong seed)
    {
        (double minimum, double maximum) = new SyntheticShape(seed).RadiusBounds(0, 180, 0, 360);
        Assert.InRange(minimum - MoonConstants.ReferenceRadius, -5000.0, -2000.0);
        Assert.InRange(maximum - MoonConstants.ReferenceRadius, 2000.0, 5000.0);
    }

    [Fact]
    public void MareMask_OfTheShape_CoversAPartOfTheNearSideOnly()
    {
        MareMask maria = new(new SyntheticShape(seed: 3), CancellationToken.None);
        double near = Average(maria, -60, 60);
        Assert.InRange(near, 0.1, 0.9);
        Assert.Equal(0.0, Average(maria, 120, 240));
    }

    private static double Average(MareMask maria, int west, int east)
    {
        double[] fractions = [.. from latitude in Enumerable.Range(-30, 61)
                                 from longitude in Enumerable.Range(west, east - west)
                                 select maria.At(latitude, (longitude + 360) % 360)];
        return fractions.Average();
    }
}
