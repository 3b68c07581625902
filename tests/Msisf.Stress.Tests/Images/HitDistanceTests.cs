using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Msisf.TestSupport.Images;
using Xunit;

namespace Msisf.Stress.Tests.Images;

public sealed class HitDistanceTests
{
    [Fact]
    public void Of_PointsAndMisses_MeasuresPairsAndCountsTheOthers()
    {
        Vector3D?[] truth = [new(1, 0, 0), new(0, 0, 0), new(0, 0, 5), null, null, new(7, 7, 7)];
        Vector3D?[] shown = [new(1, 3, 4), new(0, 0, 0), new(0, 0, 4), null, new(1, 1, 1), null];
        HitDistance distance = HitDistance.Of(truth, shown);
        Assert.Equal((3, 2), (distance.Pixels, distance.OneSided));
        Assert.Equal((1.0, 5.0), (distance.Median, distance.Largest));
        Assert.Equal(Math.Sqrt(26.0 / 3.0), distance.Rms, Rounding.OfChains);
    }

    [Fact]
    public void Of_NoPair_IsNoDistance() => Assert.Equal(new HitDistance(0, 1, 0, 0, 0), HitDistance.Of([null], [Vector3D.UnitX]));
}
