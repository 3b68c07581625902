using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Time;
using Xunit;

namespace Msisf.Core.Tests.Ephemeris;

public class BuiltInEphemerisTests
{
    private static readonly TdbInterval Always = new(-1e10, 1e10);
    private static readonly ModifiedJulianDate Time = new(55289.0);

    [Fact]
    public void SunPositionMoonMe_ChainOverEarthMoonBarycentre_IsSunMinusMoonInMetres()
    {
        BuiltInEphemeris ephemeris = Make(
            [Position(10, 0, new(1000.0, 2.0, 3.0)), Position(301, 3, new(0.5, 0.25, 4.0)), Position(3, 0, new(100.0, 10.0, 1.0))],
            angles: default);

        Assert.Equal(new Vector3D(899_500.0, -8_250.0, -2_000.0), ephemeris.SunPositionMoonMe(Time));
    }

    [Fact]
    public void MoonMeFromJ2000_QuarterTurnAboutZ_TakesXToMinusY()
    {
        // Frame axes turned by +90 degrees about z: the source's x axis is the target's -y.
        RotationMatrix rotation = Make([], angles: new(0.0, 0.0, Math.PI / 2.0)).MoonMeFromJ2000(Time);

        Assert.Equal(0.0, ((rotation * Vector3D.UnitX) + Vector3D.UnitY).Length, 1e-15);
    }

    [Fact]
    public void MoonMeFromJ2000_ThreeAngles_FirstIsAppliedFirst()
    {
        // Node 90 degrees, inclination 90 degrees, no spin: z of J2000 is +y of the frame, x of J2000 is +z.
        RotationMatrix rotation = Make([], angles: new(Math.PI / 2.0, Math.PI / 2.0, 0.0)).MoonMeFromJ2000(Time);

        Assert.Equal(0.0, ((rotation * Vector3D.UnitZ) - Vector3D.UnitY).Length, 1e-15);
        Assert.Equal(0.0, ((rotation * Vector3D.UnitX) - Vector3D.UnitZ).Length, 1e-15);
    }

    [Fact]
    public void MoonMeFromJ2000_ManyTurns_IsTheTurnsRest()
    {
        RotationMatrix rotation = Make([], angles: new(0.0, 0.0, (200.0 * Math.PI) + 1.0)).MoonMeFromJ2000(Time);

        Assert.Equal(Math.Cos(1.0), rotation.Row0.X, 2e-13);
        Assert.Equal(Math.Sin(1.0), rotation.Row0.Y, 2e-13);
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

        SpiceException failure = Assert.Throws<SpiceException>(() => ephemeris.SunPositionMoonMe(Time));

        Assert.Contains("2010-04-03T00:00:00Z", failure.Message, StringComparison.Ordinal);
        Assert.Contains("2000-01-01T11:58:56Z to 2000-01-11T11:58:55Z", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void SunPositionMoonMe_CentresInARing_FailsInsteadOfHanging()
    {
        BuiltInEphemeris ephemeris = Make([Position(10, 0, default), Position(301, 3, default), Position(3, 301, default)], angles: default);

        SpiceException failure = Assert.Throws<SpiceException>(() => ephemeris.SunPositionMoonMe(Time));

        Assert.Contains("body 301", failure.Message, StringComparison.Ordinal);
    }

    private static FixedSegment Position(int body, int center, Vector3D km) => new(body, center, Always, km);

    private static BuiltInEphemeris Make(IEnumerable<IEphemerisSegment> positions, Vector3D angles) => new(
        SampleScale.Naif0012,
        new SegmentTable(positions),
        new SegmentTable([new FixedSegment(31006, 0, Always, angles)]),
        new BodyFixedFrame(31006, RotationMatrix.Identity));
}
