using Msisf.Core.Errors;
using Msisf.Core.Orbit;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Orbit;

public class MeanMotionTests
{
    [Fact]
    public void MeanAnomalyAt_UpToACentury_KeepsAllDigits()
    {
        // tests/reference/kepler.py, mpmath at 80 digits. rad: the roundings of M0 in [0, 2 pi) and of the sum; dt itself is exact.
        const double allowed = 1.5e-15;
        Assert.All(ReferenceTable.Rows("mean_anomaly.csv"), row =>
        {
            double difference = new MeanMotion(row[0]).MeanAnomalyAt(row[1], row[2]) - row[3];
            Assert.InRange(Math.Abs(Math.IEEERemainder(difference, 2.0 * Math.PI)), 0.0, allowed);
        });
    }

    [Theory]
    [InlineData(1.0)]
    [InlineData(-3.0)]
    [InlineData(Math.PI)]
    public void MeanAnomalyAt_Epoch_IsM0ToTheBit(double m0) =>
        Assert.Equal(m0, new MeanMotion(1.9e6).MeanAnomalyAt(m0, 0.0));

    [Theory]
    [InlineData(1e-200)]
    [InlineData(1e200)]
    public void RadiansPerSecond_AxisWhoseCubeIsNoDouble_FollowsTheScaling(double factor)
    {
        // n goes with a^-3/2; both factors are far from the edge after the root.
        double expected = Math.Pow(factor, -1.5) * new MeanMotion(1.9e6).RadiansPerSecond;
        Assert.Equal(1.0, new MeanMotion(1.9e6 * factor).RadiansPerSecond / expected, Rounding.OfChains);
    }

    [Fact]
    public void MeanAnomalyAt_MoreRadiansThanADoubleHolds_RefusedWithBothNumbers()
    {
        BadInputException failure = Assert.Throws<BadInputException>(() => new MeanMotion(1e-200).MeanAnomalyAt(0.0, 1e10));
        Assert.Contains("10000000000 s", failure.Message, StringComparison.Ordinal);
    }
}
