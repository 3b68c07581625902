using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.Core.Scene;
using Msisf.Core.Tests.Ephemeris;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Scene;

public sealed class SpacecraftPathTests
{
    private static readonly TimeScale Scale = Moments.Naif0012;

    /// <summary>After 1000 s the Moon has turned by 90 degrees, so that a camera on the y axis of J2000 is over longitude 0.</summary>
    [Fact]
    public void At_MoonThatTurns_GivesPlaceAndAttitudeOverIt()
    {
        SpacecraftPath path = new(new AlongY(), new LooksAtCenter(), new Turning());

        CameraState camera = path.At(Moments.OfTdb(1000.0));

        Assert.InRange((camera.PositionBodyFixed - new Vector3D(2e6 + 1000.0, 0.0, 0.0)).Length, 0.0, Rounding.OfConvertedPlaces);
        Assert.InRange(((camera.MoonFromCamera * -Vector3D.UnitX) - -Vector3D.UnitX).Length, 0.0, Rounding.OfUnits);
    }

    [Fact]
    public void At_TimeInUtc_IsTheSameAsInTdb()
    {
        SpacecraftPath path = new(new AlongY(), new LooksAtCenter(), new Turning());
        Instant time = Moments.OfMjd(51544.5);

        SpacecraftState state = path.StateAt(time);

        // TAI - UTC is 32 s in January 2000, TT - TAI 32.184 s; TDB is TT within 2 ms.
        Assert.Equal(2e6 + 64.184, state.PositionBodyFixed.Length, 0.002);
        Assert.Equal(time, state.Time);
    }

    /// <summary>Velocity and rate are those that the sources state, seen from the turning Moon.</summary>
    [Fact]
    public void StatedMotionAt_SourcesWithRates_AreTheirsOverTheMoon()
    {
        SpacecraftPath path = new(new AlongY(), new SaysItsRate(), new Turning());

        CameraMotion motion = path.StatedMotionAt(Moments.OfTdb(1000.0))!.Value;

        double ofMoon = Math.PI / 2.0 / 1000.0; // rad/s about z
        Assert.InRange((motion.VelocityBodyFixed - new Vector3D(1.0, -ofMoon * 2_001_000.0, 0.0)).Length, 0.0, Rounding.OfPlaces);
        Assert.InRange((motion.AngularVelocityCamera - new Vector3D(0.1, 0.2, 0.3 - ofMoon)).Length, 0.0, Rounding.OfUnits);
    }

    /// <summary>A camera that keeps looking at the centre turns with the line to it, and no source says so.</summary>
    [Fact]
    public void StatedMotionAt_AttitudeWithoutRate_TurnsAsItsAttitudesDo()
    {
        SpacecraftPath path = new(new AlongY(), new LooksAtCenter(), new Turning());
        CameraMotion motion = path.StatedMotionAt(Moments.OfTdb(1000.0))!.Value;

        Assert.InRange(motion.AngularVelocityCamera.Length, 0.0, 2e-3); // at most as fast as the Moon turns below it
        Assert.Equal(Math.PI / 2.0 / 1000.0, motion.AngularVelocityCamera.Length, Rounding.OfChains);
    }

    [Fact]
    public void Cover_IsWhereBothAreKnown() =>
        Assert.Equal([new TdbInterval(50.0, 1500.0)], new SpacecraftPath(new AlongY(), new LooksAtCenter(), new Turning()).Cover.Intervals);

    /// <summary>Moves out along y by 1 m/s.</summary>
    private sealed class AlongY : ITrajectory
    {
        public TdbCover Cover { get; } = TdbCover.Union([new TdbInterval(0.0, 1500.0)]);

        public StateVector StateJ2000(TdbTime time) => new(new Vector3D(0.0, 2e6 + time.Seconds, 0.0), Vector3D.UnitY);
    }

    private sealed class LooksAtCenter : IAttitudeSource
    {
        public TdbCover Cover { get; } = TdbCover.Union([new TdbInterval(50.0, 2000.0)]);

        public UnitQuaternion MoonFromCamera(in TrajectoryPoint point) => NadirPointing.MoonFromCamera(point.PositionBodyFixed);
    }

    /// <summary>Along the Moon's axes, and turning in space as no neighbouring attitude would tell.</summary>
    private sealed class SaysItsRate : IAttitudeSource
    {
        public UnitQuaternion MoonFromCamera(in TrajectoryPoint point) => UnitQuaternion.Identity;

        public TurnRate? RateOf(in TrajectoryPoint point) => new TurnRate(new Vector3D(0.1, 0.2, 0.3), IsOverBody: false);
    }

    private sealed class Turning : IEphemeris
    {
        public string EngineName => "Moon that turns by 90 degrees in 1000 s";

        public TimeScale TimeScale => Scale;

        public Vector3D SunPositionBodyFixed(Instant time, Aberration aberration = Aberration.None) =>
            throw new NotSupportedException();

        public RotationMatrix BodyFromJ2000(TdbTime time) => RotationMatrix.FrameAboutZ(Math.PI / 2.0 * time.Seconds / 1000.0);

        public Vector3D BodyRateJ2000(TdbTime time) => Math.PI / 2.0 / 1000.0 * Vector3D.UnitZ;

        public StateVector StateOf(int naifNumber, TdbTime time) => throw new NotSupportedException();
    }
}
