using FsCheck;
using FsCheck.Fluent;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Attitude;

public class CameraPointingTests
{
    /// <summary>1, parts of the range: positions of 2e6 m are rounded by 4e-10 m, and the nearest target here is 10 m away.</summary>
    private const double MissOfRange = 1e-9;

    /// <summary>1: the components of a unit vector after some rotations.</summary>
    private const double UnitVector = 2e-15;

    private static readonly Instant Time = Moments.OfMjd(55289.0);
    private static readonly SphereScene Scene = new();

    private static Gen<SurfacePlace> Places(int lowest, int highest) =>
        from latitude in Gen.Choose(-9000, 9000)
        from longitude in Gen.Choose(-36000, 36000)
        from height in Gen.Choose(lowest, highest)
        select new SurfacePlace(latitude / 100.0, longitude / 100.0, height + 0.5, isOverTerrain: true);

    // The horizon of a camera 100 km over a sphere of 1,738,634.5 m is 19.0 degrees away: acos(1 / (1 + 100 / 1738.6345)).
    [Theory]
    [InlineData(18.9, 0.0, false)]
    [InlineData(19.2, 0.0, true)]
    [InlineData(180.0, 0.0, true)]
    [InlineData(19.2, 1000.0, false)] // a summit over the horizon
    [InlineData(0.0, -500.0, false)] // straight down into a hole
    public void IsTargetHidden_OverASphere_IsWhatTheHorizonSays(double longitude, double height, bool isHidden)
    {
        Vector3D position = new SurfacePlace(0.0, 0.0, 100_000.0, isOverTerrain: true).ToPositionBodyFixed(Scene.GroundRadius);
        CameraPointing pointing = new()
        {
            Kind = BoresightKind.Place,
            Target = new SurfacePlace(0.0, longitude, height, isOverTerrain: true),
        };

        Assert.Equal(isHidden, pointing.IsTargetHidden(position, Scene));
        Assert.False((pointing with { Kind = BoresightKind.Horizon }).IsTargetHidden(position, Scene));
    }

    [Fact]
    public void MoonFromCamera_AnyTarget_BoresightMeetsItWithTheHorizonLevel()
    {
        Gen<(SurfacePlace Camera, SurfacePlace Target)> far =
            from camera in Places(10, 3_000_000)
            from target in Places(-5000, 5000)
            select (camera, target);

        // From 10 m upwards: the angle to a target 30 m away is rounded most.
        Gen<(SurfacePlace Camera, SurfacePlace Target)> near =
            from camera in Places(10, 1000)
            from north in Gen.Choose(1, 100)
            from east in Gen.Choose(-100, 100)
            select (camera, new SurfacePlace(
                camera.LatitudeDegrees * (1.0 - (1e-5 * north)), camera.LongitudeDegrees + (1e-5 * east), 0.0, isOverTerrain: true));

        Prop.ForAll(Arb.From(Gen.OneOf(far, near)), pair =>
        {
            Vector3D position = pair.Camera.ToPositionBodyFixed(Scene.GroundRadius);
            Vector3D target = pair.Target.ToPositionBodyFixed(Scene.GroundRadius);
            UnitQuaternion moonFromCamera = Look(pair.Target).MoonFromCamera(position, Time, Scene);
            double range = (target - position).Length;
            Vector3D reached = position + (range * (moonFromCamera * -Vector3D.UnitX));
            return (reached - target).Length <= MissOfRange * range
                && Math.Abs(Vector3D.Dot(moonFromCamera * Vector3D.UnitY, position.Normalized())) <= UnitVector
                && Vector3D.Dot(moonFromCamera * Vector3D.UnitZ, position) >= 0.0;
        }).Check(Config.QuickThrowOnFailure.WithMaxTest(2000).WithReplay(20120222UL, 1UL));
    }

    [Fact]
    public void MoonFromCamera_AnyRoll_TurnsTheImageAboutTheBoresight()
    {
        Gen<(SurfacePlace Camera, SurfacePlace Target, int Roll)> cases =
            from camera in Places(10_000, 3_000_000)
            from target in Places(-5000, 5000)
            from roll in Gen.Choose(-720, 720)
            select (camera, target, roll);

        Prop.ForAll(Arb.From(cases), one =>
        {
            Vector3D position = one.Camera.ToPositionBodyFixed(Scene.GroundRadius);
            CameraPointing level = Look(one.Target);
            UnitQuaternion straight = level.MoonFromCamera(position, Time, Scene);
            UnitQuaternion rolled = (level with { Roll = one.Roll * Math.PI / 180.0 }).MoonFromCamera(position, Time, Scene);

            // Clockwise from behind: the camera's up moves towards what was right.
            (double sin, double cos) = Math.SinCos(one.Roll * Math.PI / 180.0);
            Vector3D up = (cos * (straight * Vector3D.UnitZ)) + (sin * (straight * Vector3D.UnitY));
            return ((rolled * -Vector3D.UnitX) - (straight * -Vector3D.UnitX)).Length <= UnitVector
                && ((rolled * Vector3D.UnitZ) - up).Length <= 10.0 * UnitVector;
        }).Check(Config.QuickThrowOnFailure.WithMaxTest(1000).WithReplay(20120222UL, 3UL));
    }

    [Fact]
    public void MoonFromCamera_AnyOffNadir_HasThisAngleAndAzimuth()
    {
        Gen<(SurfacePlace Camera, int Angle, int Azimuth)> cases =
            from camera in Places(10_000, 3_000_000)
            from angle in Gen.Choose(1, 179)
            from azimuth in Gen.Choose(0, 359)
            where Math.Abs(camera.LatitudeDegrees) < 89.0
            select (camera, angle, azimuth);

        Prop.ForAll(Arb.From(cases), one =>
        {
            Vector3D position = one.Camera.ToPositionBodyFixed(Scene.GroundRadius);
            CameraPointing pointing = new()
            {
                Kind = BoresightKind.OffNadir,
                OffNadir = one.Angle * Math.PI / 180.0,
                Azimuth = one.Azimuth * Math.PI / 180.0,
            };
            Vector3D forward = pointing.MoonFromCamera(position, Time, Scene) * -Vector3D.UnitX;
            Vector3D east = Vector3D.Cross(Vector3D.UnitZ, position).Normalized();
            Vector3D north = Vector3D.Cross(position, east).Normalized();
            double azimuth = Math.Atan2(Vector3D.Dot(forward, east), Vector3D.Dot(forward, north)) * 180.0 / Math.PI;
            double turn = Math.IEEERemainder(azimuth - one.Azimuth, 360.0);
            return Math.Abs((Vector3D.AngleBetween(forward, -position) * 180.0 / Math.PI) - one.Angle) <= 1e-12
                && Math.Abs(turn) <= 1e-11;
        }).Check(Config.QuickThrowOnFailure.WithMaxTest(1000).WithReplay(20120222UL, 3UL));
    }

    [Theory]
    [InlineData(0.0, 0.0)]
    [InlineData(-58.6, -14.5)]
    [InlineData(90.0, 0.0)] // the poles
    [InlineData(90.0, 77.0)]
    [InlineData(-90.0, 0.0)]
    [InlineData(45.0, 180.0)]
    public void MoonFromCamera_TargetBelow_IsTheNadirWithNorthUp(double latitude, double longitude)
    {
        Vector3D position = new SurfacePlace(latitude, longitude, 50_000.0, isOverTerrain: false).ToPositionBodyFixed(Scene.GroundRadius);
        UnitQuaternion expected = NadirPointing.MoonFromCamera(position);

        UnitQuaternion found = Look(new SurfacePlace(latitude, longitude, 0.0, isOverTerrain: true)).MoonFromCamera(position, Time, Scene);
        UnitQuaternion nadir = new CameraPointing().MoonFromCamera(position, Time, Scene);

        // The target lies 5e4 m away, and both places are rounded by 4e-10 m.
        AssertSameAxes(expected, found, 4e-14);
        AssertSameAxes(expected, nadir, UnitVector);
    }

    // By hand, from 100 km over latitude 0, longitude 0: nadir is -x, east y, north z.
    [Theory]
    [InlineData(UpDirection.Zenith, 90.0, 0.0, "0,0,1", "1,0,0")] // level, to the north
    [InlineData(UpDirection.Zenith, 90.0, 180.0, "0,0,-1", "1,0,0")] // level, to the south: not upside down
    [InlineData(UpDirection.Zenith, 90.0, 90.0, "0,1,0", "1,0,0")]
    [InlineData(UpDirection.Zenith, 180.0, 0.0, "1,0,0", "0,0,1")] // straight up: up is parallel to the boresight, north does
    [InlineData(UpDirection.North, 90.0, 90.0, "0,1,0", "0,0,1")]
    [InlineData(UpDirection.North, 0.0, 0.0, "-1,0,0", "0,0,1")]
    [InlineData(UpDirection.North, 90.0, 0.0, "0,0,1", "1,0,0")] // along the pole's direction, and along north too: the zenith
    [InlineData(UpDirection.North, 90.0, 180.0, "0,0,-1", "1,0,0")]
    public void MoonFromCamera_KnownPlace_HasTheAxesByHand(UpDirection up, double angle, double azimuth, string forward, string imageUp)
    {
        CameraPointing pointing = new()
        {
            Kind = BoresightKind.OffNadir,
            OffNadir = angle * Math.PI / 180.0,
            Azimuth = azimuth * Math.PI / 180.0,
            Up = up,
        };

        UnitQuaternion found = pointing.MoonFromCamera(new Vector3D(1.8374e6, 0.0, 0.0), Time, Scene);

        AssertClose(Parse(forward), found * -Vector3D.UnitX, UnitVector);
        AssertClose(Parse(imageUp), found * Vector3D.UnitZ, UnitVector);
    }

    [Fact]
    public void MoonFromCamera_Sun_LooksAtItAndUpAlongItFallsBackToNorth()
    {
        Vector3D position = new(0.0, 2e6, 0.0);
        Vector3D toSun = (SphereScene.Sun - position).Normalized();
        CameraPointing atSun = new() { Kind = BoresightKind.Sun, Up = UpDirection.Sun };

        UnitQuaternion found = atSun.MoonFromCamera(position, Time, Scene);
        UnitQuaternion sunUp = new CameraPointing { Up = UpDirection.Sun }.MoonFromCamera(position, Time, Scene);

        AssertClose(toSun, found * -Vector3D.UnitX, UnitVector);
        AssertClose((Vector3D.UnitZ - (toSun.Z * toSun)).Normalized(), found * Vector3D.UnitZ, UnitVector);
        AssertClose(new Vector3D(toSun.X, 0.0, toSun.Z).Normalized(), sunUp * Vector3D.UnitZ, UnitVector);
    }

    [Theory]
    [InlineData(0.0)]
    [InlineData(123.0)]
    public void MoonFromCamera_Horizon_IsInTheMiddleOfTheImage(double azimuth)
    {
        Vector3D position = new SurfacePlace(20.0, 30.0, 50_000.0, isOverTerrain: false).ToPositionBodyFixed(Scene.GroundRadius);
        CameraPointing pointing = new() { Kind = BoresightKind.Horizon, Azimuth = azimuth * Math.PI / 180.0 };
        PinholeCamera camera = new(position, pointing.MoonFromCamera(position, Time, Scene), 0.5, 100, 100);

        // A line touches the sphere where its nearest approach to the centre is the radius.
        Vector3D forward = camera.ForwardBodyFixed;
        double nearest = Vector3D.Cross(position, forward).Length;

        Assert.Equal(MoonConstants.ReferenceRadius, nearest, Rounding.OfConvertedPlaces);
        Assert.True(Vector3D.Dot(forward, position) < 0.0);
    }

    [Fact]
    public void MoonFromCamera_HorizonInsideTheSphere_IsLevel()
    {
        Vector3D position = new(1.735e6, 0.0, 0.0);
        UnitQuaternion found = new CameraPointing { Kind = BoresightKind.Horizon }.MoonFromCamera(position, Time, Scene);
        AssertClose(Vector3D.UnitZ, found * -Vector3D.UnitX, UnitVector);
    }

    [Fact]
    public void MoonFromCamera_AtTheTargetOrTheCentre_Refused()
    {
        SurfacePlace target = new(10.0, 20.0, 0.0, isOverTerrain: false);
        Vector3D position = target.ToPositionBodyFixed(Scene.GroundRadius);

        Assert.Contains(
            "very point", Assert.Throws<BadInputException>(() => Look(target).MoonFromCamera(position, Time, Scene)).Message,
            StringComparison.Ordinal);
        Assert.Throws<BadInputException>(() => Look(target).MoonFromCamera(default, Time, Scene));
    }

    private static CameraPointing Look(SurfacePlace target) => new() { Kind = BoresightKind.Place, Target = target };

    private static Vector3D Parse(string components)
    {
        double[] numbers = [.. components.Split(',').Select(text => double.Parse(text, System.Globalization.CultureInfo.InvariantCulture))];
        return new Vector3D(numbers[0], numbers[1], numbers[2]);
    }

    private static void AssertSameAxes(UnitQuaternion expected, UnitQuaternion found, double tolerance)
    {
        AssertClose(expected * Vector3D.UnitX, found * Vector3D.UnitX, tolerance);
        AssertClose(expected * Vector3D.UnitY, found * Vector3D.UnitY, tolerance);
        AssertClose(expected * Vector3D.UnitZ, found * Vector3D.UnitZ, tolerance);
    }

    private static void AssertClose(Vector3D expected, Vector3D actual, double tolerance) =>
        Assert.InRange((actual - expected).Length, 0.0, tolerance);
}
