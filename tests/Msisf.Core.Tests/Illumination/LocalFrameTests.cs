using Msisf.Core.Illumination;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Illumination;

public sealed class LocalFrameTests
{
    private const double Radius = 1_737_400.0;

    /// <summary>As docs/illumination.md has it: azimuth 0 is towards longitude 180 at the north pole, 0 at the south pole.</summary>
    [Theory]
    [InlineData(1.0)]
    [InlineData(-1.0)]
    public void At_APole_HasTheAzimuthsOfLongitude0(double sign)
    {
        LocalFrame pole = LocalFrame.At(new Vector3D(0.0, 0.0, sign * Radius));

        Assert.Equal(new Vector3D(-sign, 0.0, 0.0), pole.DirectionOf(0.0, 0.0));
        Assert.InRange((pole.DirectionOf(0.5 * Math.PI, 0.0) - Vector3D.UnitY).Length, 0.0, 1e-15);

        // A metre away, on longitude 0, they are the same.
        LocalFrame near = LocalFrame.At(new Vector3D(1.0, 0.0, sign * Radius));
        Assert.InRange((near.DirectionOf(0.7, 0.2) - pole.DirectionOf(0.7, 0.2)).Length, 0.0, 1e-6);
    }
}
