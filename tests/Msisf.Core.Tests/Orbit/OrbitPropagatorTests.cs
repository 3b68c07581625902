using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Orbit;

public class OrbitPropagatorTests
{
    /// <summary>m: some 16 ulps at 2e6 m; two rotations.</summary>
    private const double RotatedPosition = 4e-9;

    private static readonly Instant Epoch = Moments.OfMjd(55289.0);
    private static readonly Instant TwoHoursLater = Moments.OfMjd(55289.0 + (2.0 / 24.0));
    private static readonly KeplerElements Elements = new(1.9e6, 0.05, 0.7, 1.1, 0.9, 2.0);

    [Fact]
    public void PositionMoonMe_ThesisFrame_IsTheOrbitsOwnPosition()
    {
        OrbitPropagator propagator = new(Elements, Epoch, OrbitFrame.MoonMe, ephemeris: null);
        Assert.Equal(new KeplerOrbit(Elements).PositionAt(TwoHoursLater.SecondsSince(Epoch)), propagator.PositionBodyFixed(TwoHoursLater));
    }

    [Fact]
    public void PositionMoonMe_FrameOfTheEpoch_AgreesWithTheThesisFrameAtTheEpoch()
    {
        OrbitPropagator thesis = new(Elements, Epoch, OrbitFrame.MoonMe, ephemeris: null);
        OrbitPropagator inertial = new(Elements, Epoch, OrbitFrame.MoonMeEpoch, new TurningMoon());
        Assert.InRange((inertial.PositionBodyFixed(Epoch) - thesis.PositionBodyFixed(Epoch)).Length, 0.0, RotatedPosition);
    }

    [Fact]
    public void PositionMoonMe_FrameOfTheEpochTwoHoursLater_LagsByTheMoonsRotation()
    {
        // Deviations row 22: 13.18 degrees a day are 1.0983 degrees in two hours; the Moon turns eastwards below, so the track falls west.
        OrbitPropagator thesis = new(Elements, Epoch, OrbitFrame.MoonMe, ephemeris: null);
        OrbitPropagator inertial = new(Elements, Epoch, OrbitFrame.MoonMeEpoch, new TurningMoon());

        Vector3D expected = thesis.PositionBodyFixed(TwoHoursLater);
        Vector3D actual = inertial.PositionBodyFixed(TwoHoursLater);
        double west = Math.Atan2(expected.Y, expected.X) - Math.Atan2(actual.Y, actual.X);
        Assert.Equal(13.18 / 12.0, west * 180.0 / Math.PI, Rounding.OfPlaces);
        Assert.Equal(expected.Z, actual.Z, RotatedPosition);
    }

    [Fact]
    public void PositionMoonMe_J2000_IsTurnedByTheMoonsAttitudeAtTheTime()
    {
        OrbitPropagator propagator = new(Elements, Epoch, OrbitFrame.J2000, new TurningMoon());
        Vector3D positionJ2000 = new KeplerOrbit(Elements).PositionAt(TwoHoursLater.SecondsSince(Epoch));

        // Right ascension minus the Moon's angle, by hand.
        double rightAscension = Math.Atan2(positionJ2000.Y, positionJ2000.X);
        double longitude = rightAscension - TurningMoon.AngleAt(TwoHoursLater);
        double horizontal = double.Hypot(positionJ2000.X, positionJ2000.Y);
        Vector3D expected = new(horizontal * Math.Cos(longitude), horizontal * Math.Sin(longitude), positionJ2000.Z);
        Assert.InRange((propagator.PositionBodyFixed(TwoHoursLater) - expected).Length, 0.0, RotatedPosition);
    }

    [Fact]
    public void PositionMoonMe_StateVectorAtTheEpoch_IsThatPosition()
    {
        StateVector state = new(new Vector3D(0.0, 1.9e6, 3e5), new Vector3D(-1000.0, 200.0, 1100.0));
        OrbitPropagator propagator = new(StateConversion.ToElements(state), Epoch, OrbitFrame.MoonMeEpoch, new TurningMoon());
        Assert.InRange((propagator.PositionBodyFixed(Epoch) - state.Position).Length, 0.0, RotatedPosition);
    }

    [Fact]
    public void PeriapsisRadius_OfTheElements() =>
        Assert.Equal(
            1.9e6 * 0.95, new OrbitPropagator(Elements, Epoch, OrbitFrame.MoonMe, ephemeris: null).PeriapsisRadius, Rounding.OfPlaces);

    [Theory]
    [InlineData(OrbitFrame.MoonMeEpoch)]
    [InlineData(OrbitFrame.J2000)]
    public void Constructor_TurningFrameWithoutEphemeris_Refused(OrbitFrame frame) =>
        Assert.Throws<ArgumentNullException>(() => new OrbitPropagator(Elements, Epoch, frame, ephemeris: null));

    /// <summary>A Moon that turns about z only, by 13.18 degrees a day from an arbitrary angle.</summary>
    private sealed class TurningMoon : IEphemeris
    {
        public string EngineName => "turning Moon";

        public static double AngleAt(Instant time) => 0.4 + (13.18 * Math.PI / 180.0 * (time.Mjd - 55280.0));

        public TimeScale TimeScale => throw new NotSupportedException();

        public Vector3D SunPositionBodyFixed(Instant time, Aberration aberration = Aberration.None) =>
            throw new NotSupportedException();

        public RotationMatrix BodyFromJ2000(TdbTime time) => RotationMatrix.FrameAboutZ(AngleAt(Moments.OfTdb(time)));

        public Vector3D BodyRateJ2000(TdbTime time) => 13.18 * Math.PI / 180.0 / 86_400.0 * Vector3D.UnitZ;

        public StateVector StateOf(int naifNumber, TdbTime time) => throw new NotSupportedException();
    }
}
