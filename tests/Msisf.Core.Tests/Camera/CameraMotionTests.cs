using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Camera;

public sealed class CameraMotionTests
{
    private static readonly UnitQuaternion Start = UnitQuaternion.FromComponents(0.1, 0.2, 0.3, 0.9273618495495703);

    /// <summary>The attitude transition turns a camera at a constant rate about its own axes; so does the motion.</summary>
    [Theory]
    [InlineData(0.01)]
    [InlineData(-2.5)]
    public void Moved_Turning_IsTheAttitudeTransition(double seconds)
    {
        Vector3D rate = new(0.3, -0.1, 0.2);
        PinholeCamera camera = new(new Vector3D(2e6, 1.0, 2.0), Start, 0.7, 10, 10);
        ICamera moved = camera.Moved(new CameraMotion(new Vector3D(1.0, 2.0, -3.0), rate), seconds);

        UnitQuaternion expected = new AttitudeTransition(Start, rate).At(seconds);
        Assert.Equal(0.0, ((moved.MoonFromCamera * Vector3D.UnitY) - (expected * Vector3D.UnitY)).Length, Rounding.OfUnits);
        Assert.Equal(0.0, ((moved.MoonFromCamera * Vector3D.UnitX) - (expected * Vector3D.UnitX)).Length, Rounding.OfUnits);
        Assert.Equal(new Vector3D(2e6 + seconds, 1.0 + (2.0 * seconds), 2.0 - (3.0 * seconds)), moved.PositionBodyFixed);
    }

    [Theory]
    [InlineData(1.0)]
    [InlineData(-1.0)]
    public void Between_TwoStates_IsTheirDifference(double sign)
    {
        Vector3D rate = new(0.3, -0.1, 0.2);
        UnitQuaternion end = new AttitudeTransition(Start, rate).At(2.0);
        end = UnitQuaternion.FromComponents(sign * end.X, sign * end.Y, sign * end.Z, sign * end.W);
        CameraMotion motion = CameraMotion.Between((new Vector3D(1.0, 2.0, 3.0), Start), (new Vector3D(2.0, 0.0, 3.0), end), 2.0);

        Assert.Equal(new Vector3D(0.5, -1.0, 0.0), motion.VelocityBodyFixed);
        Assert.Equal(0.0, (motion.AngularVelocityCamera - rate).Length, Rounding.OfUnits);
    }

    [Fact]
    public void FromNumbers_NotFinite_NamesTheNumber() => Assert.Contains(
        "wy (rad/s)",
        Assert.Throws<BadInputException>(() => CameraMotion.FromNumbers([0.0, 0.0, 0.0, 0.0, double.NaN, 0.0])).Message,
        StringComparison.Ordinal);
}
