using Msisf.Core.Detector;
using Xunit;

namespace Msisf.Core.Tests.Detector;

public sealed class BloomingTests
{
    [Fact]
    public void Spread_OneFullPixel_FlowsUpAndDownUntilThereIsRoom()
    {
        double[] column = [0.0, 20.0, 100.0, 351.0, 90.0, 0.0, 0.0];
        Blooming.Spread(column, width: 1, fullWell: 100.0);

        // 251 too many: 126 down (10 + 100 + 16), 125 up (past the full one, 80, then 45).
        Assert.Equal([45.0, 100.0, 100.0, 100.0, 100.0, 100.0, 16.0], column);
    }

    [Fact]
    public void Spread_MoreThanTheColumnHolds_LosesTheRest()
    {
        double[] charge = [900.0, 1.0, 0.0, 2.0];
        Blooming.Spread(charge, width: 2, fullWell: 100.0);
        Assert.Equal([100.0, 1.0, 100.0, 2.0], charge);
    }

    [Fact]
    public void Drain_FullPixel_KeepsItsNeighbours()
    {
        double[] column = [5.0, 351.0, 7.0];
        Blooming.Drain(column, fullWell: 100.0);
        Assert.Equal([5.0, 100.0, 7.0], column);
    }
}
