using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Numerics;

public sealed class StableTests
{
    /// <summary>-2^60 + (2^30 + 1) (2^30 - 1) = -1; each of product and sum alone would be rounded.</summary>
    [Fact]
    public void Along_ProductAndSumCancel_IsExact()
    {
        double origin = -Math.ScaleB(1.0, 60);
        double large = Math.ScaleB(1.0, 30);

        Assert.Equal(-1.0, Stable.Along(origin, large + 1.0, large - 1.0));
        Assert.Equal(
            new Vector3D(-1.0, 0.0, large - 1.0),
            Stable.PointAlong(new Vector3D(origin, 0.0, 0.0), large + 1.0, new Vector3D(large - 1.0, 0.0, (large - 1.0) / (large + 1.0))));
    }
}
