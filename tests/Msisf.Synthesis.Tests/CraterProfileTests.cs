using System.Runtime.Intrinsics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Synthesis.Tests;

public sealed class CraterProfileTests
{
    // Pike (1977), fresh craters of 1 km and 40 km: depth 196 m and 3170 m, rim 36 m and 1029 m over the surroundings.
    [Theory]
    [InlineData(1.0, 196.0, 36.0)]
    [InlineData(40.0, 3170.0, 1029.0)]
    public void HeightAt_FreshCrater_HasThePublishedDepthAndRim(double diameterKm, double depth, double rim)
    {
        CraterProfile profile = new(new Crater(0.0, 0.0, 500.0 * diameterKm, Freshness: 1.0));
        Assert.Equal(rim - depth, At(profile, 0.0), 0.01 * depth);

        // The crest is rounded by a quarter of the rounding's width, 0.15 of the depth.
        double crest = Enumerable.Range(80, 60).Max(i => At(profile, i / 100.0));
        Assert.InRange(crest, rim - (0.05 * depth), rim);
    }

    [Fact]
    public void HeightAt_OldCrater_IsShallowAndRound()
    {
        CraterProfile fresh = new(new Crater(0.0, 0.0, 500.0, Freshness: 1.0));
        CraterProfile old = new(new Crater(0.0, 0.0, 500.0, Freshness: 0.25));
        Assert.Equal(0.25, At(old, 0.0) / At(fresh, 0.0), Rounding.OfPlaces);
        Assert.InRange(Bend(old) / 0.25, 0.0, 0.7 * Bend(fresh));
    }

    [Fact]
    public void HeightAt_EndOfReach_ComesDownToZeroAndStays()
    {
        CraterProfile profile = new(new Crater(0.0, 0.0, 5000.0, Freshness: 1.0));
        Assert.InRange(At(profile, 2.9), 0.1, 3.0);
        Assert.Equal(0.0, At(profile, Crater.Reach));
        Assert.Equal(0.0, At(profile, 50.0));
    }

    private static double Bend(CraterProfile profile) => Math.Abs(At(profile, 0.95) - (2.0 * At(profile, 1.0)) + At(profile, 1.05));

    private static double At(CraterProfile profile, double radii) => profile.HeightAt(Vector256.Create(radii * radii))[0];
}
