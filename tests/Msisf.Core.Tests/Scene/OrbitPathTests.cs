using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Scene;

/// <summary>A camera on an orbit states its velocity and its turning: by closed forms, and by its attitudes at other times.</summary>
public sealed class OrbitPathTests
{
    /// <summary>m/s: 4,000 ulps of 1.7 km/s; differences of positions would be off by 1e-4.</summary>
    private const double Velocity = 1e-9;

    /// <summary>rad/s: differences over 2 and 4 s of attitudes with 4 ulps, and the fifth derivative of an orbit's.</summary>
    private const double Turning = 1e-13;

    private const double MoonRate = 13.18 * Math.PI / 180.0 / 86_400.0; // rad/s
    private const double A = 1.9e6;
    private const double E = 0.05;

    private static readonly KeplerElements Elements = new(A, E, 0.7, 1.1, 0.9, 2.0);
    private static readonly Instant Epoch = Moments.OfMjd(55289.0);
    private static readonly Vector3D RateOfMoon = MoonRate * Vector3D.UnitZ;

    /// <summary>Vis-viva, the angular momentum, and the velocity by the true anomaly, which follows from the place.</summary>
    [Theory]
    [InlineData(OrbitFrame.MoonMe)]
    [InlineData(OrbitFrame.MoonMeEpoch)]
    [InlineData(OrbitFrame.J2000)]
    public void MotionAt_EachFrame_HasTheVelocityOfTheClosedForm(OrbitFrame frame)
    {
        OrbitPath path = new(new OrbitPropagator(Elements, Epoch, frame, new SteadyMoon()), attitude: null);
        RotationMatrix epochFromOrbit = (RotationMatrix.FrameAboutZ(0.7) * RotationMatrix.FrameAboutX(0.9)
            * RotationMatrix.FrameAboutZ(1.1)).Transposed;
        double p = A * (1.0 - (E * E));
        double mu = MoonConstants.GravitationalParameter;
        for (double seconds = -9000.0; seconds < 9000.0; seconds += 333.25)
        {
            Instant time = Epoch.After(seconds);
            Vector3D position = path.At(time).PositionBodyFixed;
            Vector3D overMoon = path.MotionAt(time).VelocityBodyFixed;
            RotationMatrix bodyFromOrbit = frame switch
            {
                OrbitFrame.MoonMe => epochFromOrbit,
                OrbitFrame.J2000 => SteadyMoon.At(time) * epochFromOrbit,
                _ => SteadyMoon.At(time) * SteadyMoon.At(Epoch).Transposed * epochFromOrbit,
            };
            Vector3D inOrbit = bodyFromOrbit.Transposed * position;
            double anomaly = Math.Atan2(inOrbit.Y, inOrbit.X);
            Vector3D expected = bodyFromOrbit
                * (Math.Sqrt(mu / p) * new Vector3D(-Math.Sin(anomaly), E + Math.Cos(anomaly), 0.0));
            Vector3D velocity = frame == OrbitFrame.MoonMe ? overMoon : overMoon + Vector3D.Cross(RateOfMoon, position);

            Assert.InRange((velocity - expected).Length, 0.0, Velocity);
            Assert.Equal(Math.Sqrt(mu * ((2.0 / position.Length) - (1.0 / A))), velocity.Length, Velocity);
            Vector3D momentum = Vector3D.Cross(position, velocity) / position.Length;
            Assert.Equal(Math.Sqrt(mu * p) / position.Length, momentum.Length, Velocity);
        }
    }

    [Theory]
    [InlineData(null, OrbitFrame.J2000)]
    [InlineData(null, OrbitFrame.MoonMe)]
    [InlineData(AttitudeFrame.Lvlh, OrbitFrame.J2000)]
    [InlineData(AttitudeFrame.Lvlh, OrbitFrame.MoonMeEpoch)]
    [InlineData(AttitudeFrame.Lvlh, OrbitFrame.MoonMe)]
    [InlineData(AttitudeFrame.J2000, OrbitFrame.MoonMe)]
    [InlineData(AttitudeFrame.MoonMeEpoch, OrbitFrame.J2000)]
    [InlineData(AttitudeFrame.MoonMe, OrbitFrame.J2000)]
    public void MotionAt_EachAttitude_TurnsAsItsAttitudesDo(AttitudeFrame? frame, OrbitFrame orbit)
    {
        SteadyMoon moon = new();
        AttitudeTransition transition = new(
            UnitQuaternion.FromAxisAngle(new Vector3D(1.0, 2.0, 3.0), 0.4), new Vector3D(1e-3, -2e-3, 5e-4));
        OrbitPath path = new(
            new OrbitPropagator(Elements, Epoch, orbit, moon),
            frame is { } axes ? new FramedAttitude(transition, axes, Epoch, moon) : null);
        for (double seconds = 100.0; seconds < 7000.0; seconds += 690.0)
        {
            // Of the fourth order: the differences over twice and four times 0.5 s.
            Vector3D near = Difference(seconds, 0.5);
            Vector3D expected = near + ((near - Difference(seconds, 1.0)) / 3.0);
            Assert.InRange((path.MotionAt(Epoch.After(seconds)).AngularVelocityCamera - expected).Length, 0.0, Turning);
        }

        Vector3D Difference(double seconds, double half) => CameraMotion.Between(
            (default, path.At(Epoch.After(seconds - half)).MoonFromCamera),
            (default, path.At(Epoch.After(seconds + half)).MoonFromCamera),
            2.0 * half).AngularVelocityCamera;
    }

    /// <summary>A Moon that turns about z at a constant rate.</summary>
    private sealed class SteadyMoon : IEphemeris
    {
        public string EngineName => "steady Moon";

        public TimeScale TimeScale => Moments.Naif0012;

        public static RotationMatrix At(Instant time) => RotationMatrix.FrameAboutZ(0.4 + (MoonRate * (time.Tdb - Epoch.Tdb)));

        public Vector3D SunPositionBodyFixed(Instant time, Aberration aberration = Aberration.None) =>
            throw new NotSupportedException();

        public RotationMatrix BodyFromJ2000(TdbTime time) => RotationMatrix.FrameAboutZ(0.4 + (MoonRate * (time - Epoch.Tdb)));

        public Vector3D BodyRateJ2000(TdbTime time) => RateOfMoon;

        public StateVector StateOf(int naifNumber, TdbTime time) => throw new NotSupportedException();
    }
}
