using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Ephemeris;

public class LightSpeedTests
{
    [Fact]
    public void TimeOver_LightSecond_IsOne() => Assert.Equal(1.0, LightSpeed.TimeOver(299_792.458));

    [Fact]
    public void SeenFromMoving_AcrossTheLine_TurnsByTheSineOfTheSpeed()
    {
        // 3/5 and 4/5 c: sine 0.6, cosine 0.8.
        Vector3D seen = LightSpeed.SeenFromMoving(new Vector3D(100.0, 0.0, 0.0), new Vector3D(0.0, 0.0, 0.6 * 299_792.458));

        Assert.InRange((seen - new Vector3D(80.0, 0.0, 60.0)).Length, 0.0, 1e-13);
    }

    [Theory]
    [InlineData(20.0)]
    [InlineData(-20.0)]
    public void SeenFromMoving_AlongTheLine_StaysToTheBit(double speed)
    {
        Vector3D position = new(1.5e8, 3e7, -2e7);

        Assert.Equal(position, LightSpeed.SeenFromMoving(position, speed * position.Normalized()));
    }

    [Fact]
    public void SeenFromMoving_AnyMotion_KeepsTheDistance()
    {
        Vector3D position = new(1e8, -1e8, 4e6);

        Vector3D seen = LightSpeed.SeenFromMoving(position, new Vector3D(20.0, 21.0, -3.0));

        Assert.Equal(position.Length, seen.Length, 1e-7); // m: 3 ulps of 1.4e8 m
        Assert.NotEqual(position, seen);
    }
}
