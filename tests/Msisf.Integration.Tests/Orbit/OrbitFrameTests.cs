using Msisf.Adapters.Ephemeris;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.Core.Scene;
using Msisf.Core.Time;
using Msisf.Integration.Tests.Ephemeris;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Orbit;

/// <summary>Orbits in frames that turn, with the real kernels.</summary>
[Collection(SpiceItself.Name)]
public sealed class OrbitFrameTests
{
    /// <summary>m: the rotation of the frame is the same to 1e-12 in both engines, and the mean anomaly after a month to 1e-13.</summary>
    private const double PositionTolerance = 1e-5;

    /// <summary>m/s: 1e-12 of 1.8 km/s, as much as the axes of the two engines differ (EngineAgreementTests).</summary>
    private const double Velocity = 2e-9;

    /// <summary>m/s: positions are rounded by 1e-6 m (the Moon's angle is some 1e3 rad), and are 2 s apart.</summary>
    private const double VelocityOfPositions = 2e-6;

    private static readonly KeplerElements Elements = new(1.9e6, 0.05, 0.7, 1.1, 0.9, 2.0);
    private static readonly Instant Epoch = Moments.OfMjd(55289.0);

    /// <summary>tests/reference/orbit_frames.py, CSPICE N0067; times that an MJD holds exactly.</summary>
    [Theory]
    [InlineData(OrbitFrame.MoonMe, 10800.0, 1352916.3598718392, 735902.7835975757, -1098765.1790939362)]
    [InlineData(OrbitFrame.J2000, 10800.0, 928478.31993717, -1058428.7550338241, -1263676.0195671422)]
    [InlineData(OrbitFrame.MoonMeEpoch, 10800.0, 1373512.1839652637, 696701.7082965658, -1098768.1796723432)]
    [InlineData(OrbitFrame.MoonMe, 2592000.0, -807222.9713299418, 852986.2367247599, 1394131.0586919927)]
    [InlineData(OrbitFrame.J2000, 2592000.0, 1366041.1249149928, 772602.018045957, 927261.3553074228)]
    [InlineData(OrbitFrame.MoonMeEpoch, 2592000.0, -165176.42658108234, 1163063.1016265575, 1393842.4674370407)]
    public void PositionMoonMe_EachFrame_AgreesWithCSpice(OrbitFrame frame, double seconds, double x, double y, double z)
    {
        using OpenedEphemeris ephemeris = EphemerisFactory.Open(new EphemerisRequest(
            EphemerisChoice.BuiltIn, [Path.Combine(TestParts.Kernels, "msisf.tm")], TestParts.RepositoryRoot, CSpicePath: null));
        OrbitPropagator orbit = new(Elements, Epoch, frame, ephemeris.Engine);

        Vector3D position = orbit.PositionBodyFixed(Moments.OfMjd(55289.0 + (seconds / 86400.0)));

        Assert.InRange((position - new Vector3D(x, y, z)).Length, 0.0, PositionTolerance);
    }

    /// <summary>The velocity over the turning Moon is what CSPICE makes of the orbit's own state.</summary>
    [RequiresTheory(Part.CSpice)]
    [InlineData(EphemerisChoice.BuiltIn)]
    [InlineData(EphemerisChoice.CSpice)]
    public void StateBodyFixed_J2000_IsThatOfCSpice(EphemerisChoice choice)
    {
        using OpenedEphemeris opened = Engines.Open(choice);
        OrbitPropagator orbit = new(Elements, opened.Engine.TimeScale.InstantOf(3.2e8), OrbitFrame.J2000, opened.Engine);
        KeplerOrbit own = new(Elements);
        using OpenedEphemeris cspice = Engines.CSpice();
        _ = cspice.Engine.BodyFromJ2000(0.0); // loads the kernels
        for (int i = 0; i < 100; i++)
        {
            double seconds = 3.2e8 + (i * 977.125); // TDB, held by a double
            Instant time = opened.Engine.TimeScale.InstantOf(seconds);
            double[] ofStates = new double[36];
            SpiceItself.sxform_c(SpiceItself.Bytes("J2000"), SpiceItself.Bytes("MOON_ME"), seconds, ofStates);
            SpiceItself.ThrowIfFailed();
            StateVector state = own.StateAt(time.SecondsSince(opened.Engine.TimeScale.InstantOf(3.2e8)));
            double[] six =
                [state.Position.X, state.Position.Y, state.Position.Z, state.Velocity.X, state.Velocity.Y, state.Velocity.Z];
            double[] turned = [.. Enumerable.Range(3, 3).Select(
                row => Enumerable.Range(0, 6).Sum(column => ofStates[(6 * row) + column] * six[column]))];

            Vector3D found = orbit.StateBodyFixed(time).Velocity;

            Assert.InRange((found - new Vector3D(turned[0], turned[1], turned[2])).Length, 0.0, Velocity);
        }
    }

    /// <summary>A spacecraft's velocity over the turning Moon is that of its kernel as CSPICE gives it along the axes of MOON_ME.</summary>
    [RequiresTheory(Part.CSpice, Part.LroNac)]
    [InlineData(EphemerisChoice.BuiltIn)]
    [InlineData(EphemerisChoice.CSpice)]
    public void StatedMotionAt_OfKernels_IsThatOfCSpice(EphemerisChoice choice)
    {
        using OpenedEphemeris opened = Engines.Open(choice, Engines.MetaKernel, LroNac.Spk);
        KernelTrajectory trajectory = new(opened, "LRO");
        SpacecraftPath path = new(trajectory, new Slanting(), opened.Engine);
        TdbInterval cover = trajectory.Cover.Intervals[0];
        using OpenedEphemeris cspice = Engines.CSpice(Engines.MetaKernel, LroNac.Spk);
        _ = cspice.Engine.BodyFromJ2000(0.0); // loads the kernels
        double step = (cover.End - cover.Start) / 100.0;
        for (int i = 1; i < 100; i++)
        {
            double seconds = Math.Floor(1024.0 * (cover.Start + (i * step))) / 1024.0;
            double[] km = new double[6];
            SpiceItself.spkgeo_c(-85, seconds, SpiceItself.Bytes("MOON_ME"), 301, km, out _);
            SpiceItself.ThrowIfFailed();

            CameraMotion motion = path.StatedMotionAt(opened.Engine.TimeScale.InstantOf(seconds))!.Value;

            Assert.InRange((motion.VelocityBodyFixed - (1000.0 * new Vector3D(km[3], km[4], km[5]))).Length, 0.0, Velocity);
        }
    }

    /// <summary>What a camera sees by the ground's aberration moves as its positions do.</summary>
    [Theory]
    [InlineData(Aberration.None)]
    [InlineData(Aberration.LightTime)]
    [InlineData(Aberration.LightTimeAndStellar)]
    public void StatedMotionAt_GroundAberration_IsThatOfThePoses(Aberration aberration)
    {
        using OpenedEphemeris opened = Engines.BuiltIn();
        SpacecraftPath path = new(new Inertial(), new Slanting(), opened.Engine) { OfGround = aberration };
        for (double seconds = 0.0; seconds < 7000.0; seconds += 499.0)
        {
            Instant time = opened.Engine.TimeScale.InstantOf(3.2e8 + seconds);

            CameraMotion motion = path.StatedMotionAt(time)!.Value;

            // Of the fourth order: the differences over 2 and 4 s.
            (CameraMotion near, CameraMotion far) = (Between(time, 1.0), Between(time, 2.0));
            Vector3D expected = near.VelocityBodyFixed + ((near.VelocityBodyFixed - far.VelocityBodyFixed) / 3.0);
            Assert.InRange((motion.VelocityBodyFixed - expected).Length, 0.0, VelocityOfPositions);
            Assert.InRange((motion.AngularVelocityCamera - near.AngularVelocityCamera).Length, 0.0, 1e-9); // 1e-6 of it
        }

        CameraMotion Between(Instant time, double half)
        {
            (CameraState before, CameraState after) = (path.At(time.After(-half)), path.At(time.After(half)));
            return CameraMotion.Between(
                (before.PositionBodyFixed, before.MoonFromCamera), (after.PositionBodyFixed, after.MoonFromCamera), 2.0 * half);
        }
    }

    /// <summary>The orbit in J2000.</summary>
    private sealed class Inertial : ITrajectory
    {
        private readonly KeplerOrbit _orbit = new(Elements);

        public TdbCover Cover => TdbCover.Everything;

        public StateVector StateJ2000(TdbTime time) => _orbit.StateAt(time - 3.2e8);
    }

    /// <summary>Off the nadir by 20 degrees.</summary>
    private sealed class Slanting : IAttitudeSource
    {
        public UnitQuaternion MoonFromCamera(in TrajectoryPoint point) => NadirPointing.MoonFromCamera(point.PositionBodyFixed)
            * UnitQuaternion.FromAxisAngle(Vector3D.UnitZ, Math.PI / 9.0);
    }
}
