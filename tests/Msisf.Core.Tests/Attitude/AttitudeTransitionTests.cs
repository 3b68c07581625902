using Msisf.Core.Attitude;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Attitude;

public class AttitudeTransitionTests
{
    /// <summary>1: the components of a unit vector after some rotations, 4 ulps.</summary>
    private const double UnitVector = 1e-15;

    private static readonly UnitQuaternion QuarterTurnAboutZ = UnitQuaternion.FromAxisAngle(Vector3D.UnitZ, Math.PI / 2.0);

    [Fact]
    public void At_Epoch_IsTheAttitudeGiven() =>
        AssertSameRotation(QuarterTurnAboutZ, new AttitudeTransition(QuarterTurnAboutZ, new Vector3D(0.1, 0.2, 0.3)).At(0.0));

    [Fact]
    public void At_NoRate_HoldsTheAttitude() =>
        Assert.Equal(QuarterTurnAboutZ, new AttitudeTransition(QuarterTurnAboutZ, default).At(1e9));

    [Fact]
    public void At_RateAboutX_TurnsAboutTheSpacecraftsOwnAxis()
    {
        // By hand: at the epoch the camera's x axis is the Moon's y. 0.01 rad/s about it for a quarter turn: camera y (Moon -x at the
        // epoch) turns towards camera z (Moon z). About the Moon's x axis, it would have stayed where it was.
        AttitudeTransition transition = new(QuarterTurnAboutZ, new Vector3D(0.01, 0.0, 0.0));
        UnitQuaternion moonFromCamera = transition.At(50.0 * Math.PI);

        AssertClose(Vector3D.UnitY, moonFromCamera * Vector3D.UnitX);
        AssertClose(Vector3D.UnitZ, moonFromCamera * Vector3D.UnitY);
        AssertClose(Vector3D.UnitX, moonFromCamera * Vector3D.UnitZ);
    }

    [Fact]
    public void At_BeforeTheEpoch_TurnsBackwards()
    {
        AttitudeTransition transition = new(UnitQuaternion.Identity, new Vector3D(0.0, 0.0, 0.01));
        AssertClose(-Vector3D.UnitY, transition.At(-50.0 * Math.PI) * Vector3D.UnitX);
    }

    [Fact]
    public void At_ManySmallStepsOrOne_IsTheSame()
    {
        // An Euler integration of q' = q w / 2 in 1e6 steps would be off by 1e-7; products of exact steps by their rounding.
        Vector3D rate = new(0.01, -0.02, 0.005);
        UnitQuaternion step = new AttitudeTransition(UnitQuaternion.Identity, rate).At(0.1);
        UnitQuaternion product = QuarterTurnAboutZ;
        for (int count = 0; count < 10_000; count++)
        {
            product *= step;
        }

        UnitQuaternion direct = new AttitudeTransition(QuarterTurnAboutZ, rate).At(1000.0);
        Assert.InRange(((direct * Vector3D.UnitX) - (product * Vector3D.UnitX)).Length, 0.0, Rounding.OfChains);
    }

    [Theory]
    [InlineData(0.3, 1e9, -0.45509991476977335)]
    [InlineData(0.001, 1e15, -0.6576039424550747)]
    [InlineData(7.0, 12345678901.25, -1.7919845135377035)]
    public void At_AfterAges_HasNotDrifted(double rate, double seconds, double angle)
    {
        // mpmath, 60 digits: rate * seconds as exact doubles, less full turns.
        UnitQuaternion moonFromCamera = new AttitudeTransition(UnitQuaternion.Identity, new Vector3D(0.0, rate, 0.0)).At(seconds);
        Vector3D expected = new(Math.Cos(angle), 0.0, -Math.Sin(angle));
        AssertClose(expected, moonFromCamera * Vector3D.UnitX);
    }

    [Fact]
    public void At_AfterAgesAboutASlantedAxis_HasNotDrifted()
    {
        // mpmath, 60 digits, of q = (sin(|w| t / 2) w / |w|, cos(|w| t / 2)). |w| rounded to a double turns it by up to 6e-8 rad.
        UnitQuaternion found = new AttitudeTransition(UnitQuaternion.Identity, new Vector3D(0.3, 0.4, 0.7)).At(1e9);
        double sign = Math.Sign(found.W) * -1.0;
        AssertClose(
            new Vector3D(0.1742946706927612, 0.23239289425701495, 0.4066875649497761), sign * new Vector3D(found.X, found.Y, found.Z));
        Assert.Equal(-0.8661524894510039, sign * found.W, UnitVector);
    }

    [Theory]
    [InlineData(1e-200, 1e200)]
    [InlineData(1e200, 1e-200)]
    public void At_RateWhoseSquareIsNoDouble_TurnsAtThatRate(double rate, double seconds)
    {
        UnitQuaternion moonFromCamera = new AttitudeTransition(UnitQuaternion.Identity, new Vector3D(0.0, 0.0, rate)).At(seconds);
        AssertClose(new Vector3D(Math.Cos(1.0), Math.Sin(1.0), 0.0), moonFromCamera * Vector3D.UnitX);
    }

    [Fact]
    public void Constructor_RateNotFinite_Refused() =>
        Assert.Throws<BadInputException>(() => new AttitudeTransition(UnitQuaternion.Identity, new Vector3D(double.NaN, 0.0, 0.0)));

    [Fact]
    public void Constructor_DefaultAttitude_Refused() =>
        Assert.Throws<ArgumentException>(() => new AttitudeTransition(default, Vector3D.UnitX));

    [Fact]
    public void At_AngleBeyondADouble_Refused() =>
        Assert.Throws<BadInputException>(() => new AttitudeTransition(UnitQuaternion.Identity, new Vector3D(1e300, 0.0, 0.0)).At(1e10));

    private static void AssertClose(Vector3D expected, Vector3D actual) =>
        Assert.InRange((actual - expected).Length, 0.0, UnitVector);

    private static void AssertSameRotation(UnitQuaternion expected, UnitQuaternion actual)
    {
        AssertClose(expected * Vector3D.UnitX, actual * Vector3D.UnitX);
        AssertClose(expected * Vector3D.UnitY, actual * Vector3D.UnitY);
    }
}
