using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Ephemeris;

public class BuiltInEphemerisTests
{
    private static readonly TdbInterval Always = new(-1e10, 1e10);
    private static readonly Instant Time = Moments.OfMjd(55289.0);

    /// <summary>To 1 ms: TDB - UTC is 64.184 s in 2000.</summary>
    private static readonly Instant AtTdbZero = Moments.OfMjd(51544.5 - (64.184 / 86400.0));

    [Fact]
    public void SunPositionMoonMe_ChainOverEarthMoonBarycentre_IsSunMinusMoonInMetres()
    {
        BuiltInEphemeris ephemeris = Make(
            [Position(10, 0, new(1000.0, 2.0, 3.0)), Position(301, 3, new(0.5, 0.25, 4.0)), Position(3, 0, new(100.0, 10.0, 1.0))],
            angles: default);

        Assert.Equal(new Vector3D(899_500.0, -8_250.0, -2_000.0), ephemeris.SunPositionBodyFixed(Time));
    }

    [Theory]
    [InlineData(0.0, Aberration.LightTimeAndStellar)]
    [InlineData(double.PositiveInfinity, Aberration.None)]
    public void SunPositionMoonMe_NoDirectionFromTheMoon_IsBadInput(double sunX, Aberration aberration)
    {
        BuiltInEphemeris ephemeris = Make([Position(10, 0, new(sunX, 0.0, 0.0)), Position(301, 0, default)], angles: default);

        Assert.Throws<BadInputException>(() => ephemeris.SunPositionBodyFixed(Time, aberration));
    }

    [Fact]
    public void BodyFromJ2000_QuarterTurnAboutZ_TakesXToMinusY()
    {
        // Frame axes turned by +90 degrees about z: the source's x axis is the target's -y.
        RotationMatrix rotation = Make([], angles: new(0.0, 0.0, Math.PI / 2.0)).BodyFromJ2000(Time.Tdb);

        Assert.Equal(0.0, ((rotation * Vector3D.UnitX) + Vector3D.UnitY).Length, Rounding.OfUnits);
    }

    [Fact]
    public void BodyFromJ2000_ThreeAngles_FirstIsAppliedFirst()
    {
        // Node 90 degrees, inclination 90 degrees, no spin: z of J2000 is +y of the frame, x of J2000 is +z.
        RotationMatrix rotation = Make([], angles: new(Math.PI / 2.0, Math.PI / 2.0, 0.0)).BodyFromJ2000(Time.Tdb);

        Assert.Equal(0.0, ((rotation * Vector3D.UnitZ) - Vector3D.UnitY).Length, Rounding.OfUnits);
        Assert.Equal(0.0, ((rotation * Vector3D.UnitX) - Vector3D.UnitZ).Length, Rounding.OfUnits);
    }

    [Fact]
    public void BodyFromJ2000_ManyTurns_IsTheTurnsRest()
    {
        RotationMatrix rotation = Make([], angles: new(0.0, 0.0, (200.0 * Math.PI) + 1.0)).BodyFromJ2000(Time.Tdb);

        Assert.Equal(Math.Cos(1.0), rotation.Row0.X, 2e-13); // the angle is of 1e3 rad and has that ulp
        Assert.Equal(Math.Sin(1.0), rotation.Row0.Y, 2e-13); // the same
    }

    [Fact]
    public void SunPositionMoonMe_TimeNotHeld_NamesTheCommonCover()
    {
        BuiltInEphemeris ephemeris = Make(
            [
                new FixedSegment(10, 0, new TdbInterval(0.0, 864000.0), default),
                new FixedSegment(301, 0, new TdbInterval(-864000.0, 864000.0), default),
            ],
            angles: default);

        SpiceException failure = Assert.Throws<SpiceException>(() => ephemeris.SunPositionBodyFixed(Time));

        Assert.Contains("2010-04-03T00:00:00Z", failure.Message, StringComparison.Ordinal);
        Assert.Contains("2000-01-01T11:58:56Z to 2000-01-11T11:58:55Z", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void SunPositionMoonMe_LightTime_IsTheSunWhenItSentTheLightFromTheMoonNow()
    {
        // The light from 300 s away; the Sun goes 10 km/s along x, the Moon 5 km/s along y.
        const double Distance = 300.0 * 299_792.458;
        BuiltInEphemeris ephemeris = Make(
            [new StraightSegment(10, new(Distance, 0.0, 0.0), new(10.0, 0.0, 0.0)), new StraightSegment(301, default, new(0.0, 5.0, 0.0))],
            angles: default);

        Vector3D sun = ephemeris.SunPositionBodyFixed(AtTdbZero, Aberration.LightTime);

        Assert.Equal((1000.0 * Distance) - 3_000_000.0, sun.X, 1.0);
        Assert.Equal(0.0, sun.Y, 1.0);
    }

    [Fact]
    public void SunPositionMoonMe_StellarAberration_TurnsTheSunTowardsTheMoonsMotion()
    {
        // The Moon goes at 1e-4 c along y, given in two links of the chain.
        const double Speed = 29.9792458;
        BuiltInEphemeris ephemeris = Make(
            [
                Position(10, 0, new(1e8, 0.0, 0.0)),
                new FixedSegment(301, 3, Always, default, new(0.0, 0.25 * Speed, 0.0)),
                new FixedSegment(3, 0, Always, default, new(0.0, 0.75 * Speed, 0.0)),
            ],
            angles: default);

        Vector3D sun = ephemeris.SunPositionBodyFixed(Time, Aberration.LightTimeAndStellar);

        Assert.Equal(1e7, sun.Y, 1e-4);
        Assert.Equal(1e11 * Math.Sqrt(1.0 - 1e-8), sun.X, 1e-4);
        Assert.Equal(new Vector3D(1e11, 0.0, 0.0), ephemeris.SunPositionBodyFixed(Time, Aberration.LightTime));
    }

    [Theory]
    [InlineData(Aberration.LightTime)]
    [InlineData(Aberration.LightTimeAndStellar)]
    public void SunPositionMoonMe_LightFromBeforeTheCover_SaysSo(Aberration aberration)
    {
        FixedSegment sun = new(10, 0, new TdbInterval(-60.0, 864000.0), new(1.5e8, 0.0, 0.0));
        BuiltInEphemeris ephemeris = Make([sun, Position(301, 0, default)], angles: default);

        SpiceException failure = Assert.Throws<SpiceException>(() => ephemeris.SunPositionBodyFixed(AtTdbZero, aberration));

        Assert.Contains("left the Sun some 500 s earlier", failure.Message, StringComparison.Ordinal);
        Assert.Equal(1.5e11, ephemeris.SunPositionBodyFixed(AtTdbZero).X);
    }

    [Fact]
    public void SunPositionMoonMe_CentresInARing_FailsInsteadOfHanging()
    {
        BuiltInEphemeris ephemeris = Make(
            [Position(10, 0, default), Position(301, 3, default), Position(3, 301, default)], angles: default);

        SpiceException failure = Assert.Throws<SpiceException>(() => ephemeris.SunPositionBodyFixed(Time));

        Assert.Contains("body 301", failure.Message, StringComparison.Ordinal);
    }

    private static FixedSegment Position(int body, int center, Vector3D km) => new(body, center, Always, km);

    private static BuiltInEphemeris Make(IEnumerable<IEphemerisSegment> positions, Vector3D angles) => new(
        Moments.Naif0012,
        new SegmentTable(positions),
        new KernelOrientation(
            new SegmentTable([new FixedSegment(31006, 0, Always, angles)]), new BodyFixedFrame(31006, RotationMatrix.Identity)));

    /// <summary>Goes straight on, from a position at TDB = 0.</summary>
    private sealed record StraightSegment(int Body, Vector3D Start, Vector3D Rate) : IEphemerisSegment
    {
        public int Center => 0;

        public TdbInterval Interval => Always;

        public Vector3D ValueAt(TdbTime time) => Start + (time.Seconds * Rate);

        public Vector3D RateAt(TdbTime time) => Rate;
    }
}
