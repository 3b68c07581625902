using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Detector;

public sealed class PixelThroughputTests
{
    private static readonly CameraState State = new(new Vector3D(2e6, 3e5, 1e4), UnitQuaternion.FromAxisAngle(Vector3D.UnitZ, 0.3));

    [Fact]
    public void Of_Pinhole_FallsWithTheFourthPowerOfTheCosine()
    {
        CameraModel model = new(101, 81, (120.0, 100.0), (40.0, 30.0));
        double[] throughput = PixelThroughput.Of(model.At(State), isFlatFielded: false, threads: 2);
        foreach ((int x, int y) in ((int, int)[])[(40, 30), (1, 1), (101, 81), (101, 1)])
        {
            double tangent = double.Hypot((x - 40.0) / 120.0, (y - 30.0) / 100.0);
            double expected = 1.0 / (120.0 * 100.0 * Math.Pow(1.0 + (tangent * tangent), 2.0));
            Assert.Equal(1.0, throughput[((y - 1) * 101) + x - 1] / expected, 11);
        }
    }

    [Fact]
    public void Of_FlatField_IsThatOfTheAxis() =>
        Assert.All(
            PixelThroughput.Of(new CameraModel(9, 7, (120.0, 100.0), (5.0, 4.0)).At(State), isFlatFielded: true, threads: 1),
            value => Assert.Equal(1.0 / 12000.0, value));
}
