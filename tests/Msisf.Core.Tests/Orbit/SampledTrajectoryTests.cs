using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.Core.Tests.Ephemeris;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Orbit;

public sealed class SampledTrajectoryTests
{
    private const double Rate = 1e-3; // rad/s: an orbit of 1.7 hours

    private static readonly TurningMoon Moon = new();

    /// <summary>A minute is 0.06 rad, so that degree 7 leaves 0.06^8 / 8! / 70 of the radius.</summary>
    [Fact]
    public void StateJ2000_CircleSampledEachMinute_IsOnTheCircle()
    {
        SampledTrajectory trajectory = new([Block(Circle(0, 40))], "orbit.oem", Moon);

        for (double time = 200.0; time < 2000.0; time += 7.3)
        {
            StateVector state = trajectory.StateJ2000(time);
            Assert.InRange((state.Position - OnCircle(time).Position).Length, 0.0, 1e-6);
            Assert.InRange((state.Velocity - OnCircle(time).Velocity).Length, 0.0, Rounding.OfConvertedPlaces);
        }
    }

    [Theory]
    [InlineData(InterpolationMethod.Lagrange, 5, 1e-3)]
    [InlineData(InterpolationMethod.Hermite, 3, 2.0)]
    [InlineData(InterpolationMethod.Linear, 1, 900.0)]
    public void StateJ2000_OtherMethod_IsAsNearAsItCanBe(InterpolationMethod method, int degree, double limit)
    {
        StateSamples samples = Circle(0, 40);
        samples.Interpolation = new Interpolation(method, degree);
        SampledTrajectory trajectory = new([Block(samples)], "orbit.oem", Moon);

        double error = (trajectory.StateJ2000(1230.0).Position - OnCircle(1230.0).Position).Length;

        Assert.InRange(error, limit / 100.0, limit);
    }

    /// <summary>Velocities that a file states are its own, also beside a polynomial of positions (as in SPICE's type 9).</summary>
    [Theory]
    [InlineData(InterpolationMethod.Lagrange, 7)]
    [InlineData(InterpolationMethod.Linear, 1)]
    public void StateJ2000_VelocitiesBesidePositions_AreTheirs(InterpolationMethod method, int degree)
    {
        StateSamples samples = new() { Interpolation = new Interpolation(method, degree) };
        for (int i = 0; i < 12; i++)
        {
            samples.Add(60.0 * i, OnCircle(60.0 * i) with { Velocity = new Vector3D(7.0, 0.5 * i, -3.0) });
        }

        SampledTrajectory trajectory = new([Block(samples)], "orbit.oem", Moon);

        Assert.InRange((trajectory.StateJ2000(300.0).Velocity - new Vector3D(7.0, 2.5, -3.0)).Length, 0.0, Rounding.OfChains);
        Assert.InRange((trajectory.StateJ2000(330.0).Velocity - new Vector3D(7.0, 2.75, -3.0)).Length, 0.0, Rounding.OfChains);
    }

    [Fact]
    public void StateJ2000_TwoBlocks_NeverUsesSamplesOfBoth()
    {
        StateSamples shifted = new();
        for (int i = 30; i <= 60; i++)
        {
            StateVector state = OnCircle(60.0 * i);
            shifted.Add(60.0 * i, state with { Position = state.Position + new Vector3D(5000.0, 0.0, 0.0) }); // after a manoeuvre
        }

        SampledTrajectory trajectory = new([Block(Circle(0, 30)), Block(shifted)], "orbit.oem", Moon);

        Assert.InRange((trajectory.StateJ2000(1790.0).Position - OnCircle(1790.0).Position).Length, 0.0, 1e-4);
        Assert.InRange((trajectory.StateJ2000(1810.0).Position - OnCircle(1810.0).Position).Length, 4999.9999, 5000.0001);
        Assert.InRange((trajectory.StateJ2000(1800.0).Position - OnCircle(1800.0).Position).Length, 4999.9999, 5000.0001); // the later one
    }

    [Fact]
    public void StateJ2000_BetweenBlocks_SaysWhereTheyEndAndBegin()
    {
        SampledTrajectory trajectory = new([Block(Circle(0, 10)), Block(Circle(20, 30))], "orbit.oem", Moon);

        BadInputException failure = Assert.Throws<BadInputException>(() => trajectory.StateJ2000(900.0));

        Assert.Equal(
            "orbit.oem: 2000-01-01T12:13:55.816Z (MJD 51544.50967379713) is between two blocks, of which one ends at "
                + "2000-01-01T12:08:55.816Z and the next begins at 2000-01-01T12:18:55.816Z; nothing is known between them. "
                + "Choose a time inside a block.",
            failure.Message);
    }

    [Theory]
    [InlineData(-1.0)]
    [InlineData(2401.0)]
    public void StateJ2000_Outside_SaysWhatThereIs(double time)
    {
        SampledTrajectory trajectory = new([Block(Circle(0, 40))], "orbit.oem", Moon);

        BadInputException failure = Assert.Throws<BadInputException>(() => trajectory.StateJ2000(time));

        Assert.Contains("is outside the file, which has 2000-01-01T11:58:55.816Z to 2000-01-01T12:38:55.816Z.", failure.Message);
    }

    /// <summary>Dates hold 0.6 microseconds, so the file's last time may come back a little after it.</summary>
    [Fact]
    public void StateJ2000_MicrosecondAfterTheEnd_IsThere() =>
        Assert.InRange(new SampledTrajectory([Block(Circle(0, 40))], "orbit.oem", Moon).StateJ2000(2400.000001).Position.X, -2e6, 2e6);

    [Fact]
    public void StateJ2000_OnlyAPartIsUseable_SamplesOutsideStillHelp()
    {
        StateSamples samples = Circle(0, 40);
        samples.Useable = new TdbInterval(300.0, 600.0);
        SampledTrajectory trajectory = new([Block(samples)], "orbit.oem", Moon);

        // m: what degree 7 leaves in a minute of the circle
        Assert.InRange((trajectory.StateJ2000(301.0).Position - OnCircle(301.0).Position).Length, 0.0, 1e-6);
        Assert.Throws<BadInputException>(() => trajectory.StateJ2000(299.0));
    }

    /// <summary>The Moon turns by 1e-5 rad/s about z here: what rests over it moves by 10 m/s a thousand km from the axis.</summary>
    [Fact]
    public void StateJ2000_FrameOfTheMoon_TurnsWithIt()
    {
        StateSamples samples = new();
        for (int i = 0; i < 10; i++)
        {
            samples.Add(60.0 * i, new StateVector(new Vector3D(2e6, 0.0, 1e5), default));
        }

        samples.Interpolation = new Interpolation(InterpolationMethod.Lagrange, 3);
        SampledTrajectory trajectory = new(
            [new TrajectoryBlock(samples, 301, RotationMatrix.FrameAboutZ(Math.PI / 2.0))], "place.oem", Moon);

        StateVector state = trajectory.StateJ2000(300.0);

        double angle = -(Math.PI / 2.0) + 3e-3; // of the frame's x axis in J2000
        Assert.InRange(
            (state.Position - new Vector3D(2e6 * Math.Cos(angle), 2e6 * Math.Sin(angle), 1e5)).Length, 0.0, Rounding.OfConvertedPlaces);
        Assert.InRange(
            (state.Velocity - new Vector3D(-20.0 * Math.Sin(angle), 20.0 * Math.Cos(angle), 0.0)).Length, 0.0, Rounding.OfConvertedPlaces);
    }

    [Fact]
    public void StateJ2000_AboutTheEarth_AddsWhereItIs()
    {
        SampledTrajectory trajectory = new([new TrajectoryBlock(Circle(0, 40), 399, null)], "orbit.oem", Moon);

        StateVector state = trajectory.StateJ2000(600.0);

        Assert.InRange((state.Position - (OnCircle(600.0).Position + new Vector3D(4e8, 600.0, 0.0))).Length, 0.0, 1e-6); // m: the same
        Assert.InRange((state.Velocity - (OnCircle(600.0).Velocity + new Vector3D(0.0, 1.0, 0.0))).Length, 0.0, 1e-6); // m/s: the same
    }

    private static TrajectoryBlock Block(StateSamples samples) => new(samples, 301, null);

    private static StateSamples Circle(int first, int last)
    {
        StateSamples samples = new();
        for (int i = first; i <= last; i++)
        {
            samples.Add(60.0 * i, OnCircle(60.0 * i));
        }

        return samples;
    }

    private static StateVector OnCircle(double time)
    {
        (double sin, double cos) = Math.SinCos(Rate * time);
        return new StateVector(1.838e6 * new Vector3D(cos, 0.8 * sin, 0.6 * sin), 1838.0 * new Vector3D(-sin, 0.8 * cos, 0.6 * cos));
    }

    /// <summary>A Moon that turns by 1e-5 rad/s, and an Earth that moves by 1 m/s.</summary>
    private sealed class TurningMoon : IEphemeris
    {
        public string EngineName => "turning";

        public TimeScale TimeScale => Moments.Naif0012;

        public Vector3D SunPositionBodyFixed(Instant time, Aberration aberration = Aberration.None) =>
            throw new NotSupportedException();

        public RotationMatrix BodyFromJ2000(TdbTime time) => RotationMatrix.FrameAboutZ(1e-5 * time.Seconds);

        public Vector3D BodyRateJ2000(TdbTime time) => 1e-5 * Vector3D.UnitZ;

        public StateVector StateOf(int naifNumber, TdbTime time) => naifNumber == 399
            ? new StateVector(new Vector3D(4e8, time.Seconds, 0.0), new Vector3D(0.0, 1.0, 0.0))
            : throw new NotSupportedException();
    }
}
