using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Scene;

/// <summary>States between samples of motions that are known by formula.</summary>
public sealed class SampledMotionTests
{
    /// <summary>s: unevenly spaced, as logs are; each is a whole number of a day's 2^-37, which a date holds exactly.</summary>
    private static readonly double[] Seconds =
        [.. new[] { 0, 3, 5, 9, 12, 14, 19, 22, 26, 30 }.Select(step => step * 20 * 86400.0 / (1L << 24))];

    private static readonly Vector3D Axis = new Vector3D(1.0, -2.0, 0.5).Normalized();

    [Theory]
    [InlineData(InterpolationMethod.Lagrange)]
    [InlineData(InterpolationMethod.Hermite)]
    public void At_PolynomialOfDegreeSeven_IsThePolynomial(InterpolationMethod method)
    {
        SampledMotion motion = new([.. Seconds.Select(State)], method, AttitudePath.Slerp);
        foreach (double seconds in Enumerable.Range(0, 50).Select(i => i / 49.0 * Seconds[^1]))
        {
            // m: weights of alternating sign take digits away
            Assert.InRange((Position(seconds) - motion.At(seconds).PositionBodyFixed).Length, 0.0, 1e-6);
        }
    }

    [Fact]
    public void At_Linear_IsTheLineBetweenNeighbours()
    {
        SampledMotion motion = new([.. Seconds.Select(State)], InterpolationMethod.Linear, AttitudePath.Slerp);
        double middle = 0.5 * (Seconds[3] + Seconds[4]);
        Vector3D expected = 0.5 * (Position(Seconds[3]) + Position(Seconds[4]));
        Assert.InRange((expected - motion.At(middle).PositionBodyFixed).Length, 0.0, 1e-6); // m: thousands of ulps
        Assert.True((Position(middle) - expected).Length > 1.0); // else the case says nothing
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void At_TurnAtAConstantRate_StaysOne(bool isSmooth)
    {
        double[] times = isSmooth ? [.. Enumerable.Range(0, 6).Select(i => i * 50 * 86400.0 / (1L << 24))] : Seconds;
        SampledMotion motion = new(
            [.. times.Select(State)], InterpolationMethod.Linear, isSmooth ? AttitudePath.Squad : AttitudePath.Slerp);
        Assert.Equal(times[^1], motion.End);
        foreach (double seconds in Enumerable.Range(0, 40).Select(i => i / 39.0 * times[^1]))
        {
            UnitQuaternion between = motion.At(seconds).MoonFromCamera.Conjugate * Attitude(seconds);
            Assert.InRange(new Vector3D(between.X, between.Y, between.Z).Length, 0.0, Rounding.OfChains);
        }
    }

    /// <summary>Angular velocities that samples state are those of the motion, and the attitude follows them between the samples.</summary>
    [Fact]
    public void At_StatedRates_AreFollowed()
    {
        // A turn about one axis whose rate grows: the angle is quadratic, so cubic polynomials of quaternions are off by its fourth power.
        static double AngleAt(double seconds) => (2e-4 * seconds) + (3e-3 * seconds * seconds);
        double[] times = [.. Enumerable.Range(0, 6).Select(i => i * 50 * 86400.0 / (1L << 24))];
        SpacecraftState[] states =
        [
            .. times.Select(seconds => State(seconds) with
            {
                MoonFromCamera = UnitQuaternion.FromAxisAngle(Axis, AngleAt(seconds)),
                Motion = new CameraMotion(new Vector3D(1.0, 2.0, 3.0), (2e-4 + (6e-3 * seconds)) * Axis),
            }),
        ];
        double middle = 0.5 * (times[2] + times[3]);
        double Error(AttitudePath path)
        {
            UnitQuaternion turn = UnitQuaternion.FromAxisAngle(Axis, AngleAt(middle)).Conjugate
                * new SampledMotion(states, InterpolationMethod.Hermite, path).At(middle).MoonFromCamera;
            return new Vector3D(turn.X, turn.Y, turn.Z).Length;
        }

        Assert.InRange(Error(AttitudePath.Hermite), 0.0, 1e-10);
        Assert.InRange(Error(AttitudePath.Slerp), 1e-6, 1e-3); // else the case says nothing

        CameraMotion stated = new SampledMotion(states, InterpolationMethod.Hermite, AttitudePath.Hermite).MotionAt(times[3]);
        Assert.InRange((stated.AngularVelocityCamera - states[3].Motion!.Value.AngularVelocityCamera).Length, 0.0, Rounding.OfUnits);
        Assert.InRange((stated.VelocityBodyFixed - new Vector3D(1.0, 2.0, 3.0)).Length, 0.0, 1e-6);
    }

    /// <summary>The rate of slerp jumps at a sample where the turning changes, that of squad does not.</summary>
    [Fact]
    public void Squad_ChangingTurns_HasOneRateOnBothSidesOfASample()
    {
        UnitQuaternion[] q =
        [
            UnitQuaternion.Identity, UnitQuaternion.FromAxisAngle(Vector3D.UnitX, 0.3), UnitQuaternion.FromAxisAngle(Vector3D.UnitY, 0.5),
            UnitQuaternion.FromAxisAngle(new Vector3D(0.0, 1.0, 1.0), 0.9),
        ];
        const double Step = 1e-6;
        Vector3D before = Rate(Squad.At(null, q[0], q[1], q[2], 1.0 - Step), q[1], Step);
        Vector3D after = Rate(q[1], Squad.At(q[0], q[1], q[2], q[3], Step), Step);
        Assert.InRange((before - after).Length, 0.0, 1e-5);
        Vector3D jump = Rate(Squad.Between(q[0], q[1], 1.0 - Step), q[1], Step) - Rate(q[1], Squad.Between(q[1], q[2], Step), Step);
        Assert.True(jump.Length > 0.1);
        Assert.InRange(Rate(q[1], Squad.At(q[0], q[1], q[2], q[3], 0.0), 1.0).Length, 0.0, Rounding.OfUnits);
    }

    private static Vector3D Rate(UnitQuaternion from, UnitQuaternion to, double time)
    {
        UnitQuaternion turn = from.Conjugate * to;
        return 2.0 / time * Math.Sign(turn.W) * new Vector3D(turn.X, turn.Y, turn.Z);
    }

    private static SpacecraftState State(double seconds) =>
        new(Moments.OfMjd(55289.0).After(seconds), Position(seconds), Attitude(seconds))
        {
            Motion = new CameraMotion(Velocity(seconds), default),
        };

    private static UnitQuaternion Attitude(double seconds) => UnitQuaternion.FromAxisAngle(Axis, 0.7 * seconds);

    private static Vector3D Position(double t) =>
        new(1.9e6 + (30.0 * t * t), (1600.0 * t) - (2.0 * t * t * t), 500.0 * Math.Pow(t / 2.0, 7.0));

    private static Vector3D Velocity(double t) => new(60.0 * t, 1600.0 - (6.0 * t * t), 1750.0 * Math.Pow(t / 2.0, 6.0));
}
