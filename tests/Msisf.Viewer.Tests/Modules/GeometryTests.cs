using System.Text.Json;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests.Modules;

/// <summary>wwwroot/js/geometry.js against the camera of Msisf.Core, and against places on the globe that need no computation.</summary>
[Collection(Chromium.Collection)]
public class GeometryTests(ModulePage page) : IClassFixture<ModulePage>
{
    /// <summary>Of a vector of length 1: a few roundings of a chain of ten rotations.</summary>
    private const double DirectionTolerance = 1e-13;

    /// <summary>m: some ulps of 1e7 m.</summary>
    private const double PositionTolerance = 1e-8;

    /// <summary>Of the whole sphere: some roundings of a sum of angles.</summary>
    private const double AreaTolerance = 1e-15;

    /// <summary>m²: a square of 1 km² that touches the sphere is larger than its image there by (1 km / R)² of it, 0.3 m².</summary>
    private const double FlatTolerance = 2.0;

    /// <summary>Degrees.</summary>
    private const double AngleTolerance = 1e-9;

    private static readonly View[] Views =
    [
        new(12.5, 341.0, 250e3, 30.0, 40.0, 0.0),
        new(-71.0, 187.25, 9e6, 350.0, 5.0, 17.0),
        new(45.0, 90.0, 15e3, 200.0, 85.0, -120.0),
        new(-3.0, 0.0, 2e5, 90.0, 130.0, 3.0),
        new(89.5, 20.0, 1e5, 10.0, 60.0, 45.0),
    ];

    [RequiresFact(Part.Chromium)]
    public async Task StateOf_TiltedViews_AreTheCamerasOfOffNadir()
    {
        foreach (View view in Views)
        {
            double[] state = await NumbersAsync("stateOf", view.ForPage);

            Assert.Equal(55289.25, state[0]);
            Assert.InRange((PositionOf(state) - view.Position).Length, 0.0, PositionTolerance);
            AssertSameAxes(view.Attitude, QuaternionOf(state));
        }
    }

    [RequiresFact(Part.Chromium)]
    public async Task StateOf_LookingStraightDown_HasTheHeadingUpInTheImage()
    {
        double[] state = await NumbersAsync("stateOf", new View(20.0, 30.0, 1e6, 90.0, 0.0, 0.0).ForPage);

        UnitQuaternion northUp = NadirPointing.MoonFromCamera(PositionOf(state));
        AssertSameAxes(northUp * UnitQuaternion.FromAxisAngle(-Vector3D.UnitX, Math.PI / 2.0), QuaternionOf(state));
    }

    [RequiresFact(Part.Chromium)]
    public async Task ViewOf_TiltedCamerasOfCore_HasTheirAngles()
    {
        foreach (View view in Views)
        {
            JsonElement found = await page.CallAsync("geometry", "viewOf", new object[] { view.StateOfCore });

            Assert.Equal(view.Latitude, found.GetProperty("latitude").GetDouble(), AngleTolerance);
            Assert.Equal(view.Longitude, found.GetProperty("longitude").GetDouble(), AngleTolerance);
            Assert.Equal(view.Altitude, found.GetProperty("altitude").GetDouble(), PositionTolerance);
            Assert.Equal(view.Heading, found.GetProperty("heading").GetDouble(), AngleTolerance);
            Assert.Equal(view.Tilt, found.GetProperty("tilt").GetDouble(), AngleTolerance);
            Assert.Equal(view.Roll, found.GetProperty("roll").GetDouble(), AngleTolerance);
        }
    }

    [RequiresFact(Part.Chromium)]
    public async Task ViewOf_QuaternionWithoutRotationOverTheOrigin_LooksDownWithNorthUp()
    {
        // docs/camera-model.md: {0,0,0,1} looks from over latitude 0, longitude 0 straight down, north up.
        double[] state = [55289.0, 2e6, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        JsonElement found = await page.CallAsync("geometry", "viewOf", new object[] { state });

        Assert.Equal(0.0, found.GetProperty("tilt").GetDouble(), AngleTolerance);
        Assert.Equal(0.0, found.GetProperty("heading").GetDouble(), AngleTolerance);
        Assert.Equal(0.0, found.GetProperty("roll").GetDouble(), AngleTolerance);
        Assert.Equal(262_600.0, found.GetProperty("altitude").GetDouble(), PositionTolerance);
    }

    [RequiresFact(Part.Chromium)]
    public async Task RayThroughAndProject_PixelsOfAnImage_AreThoseOfCoresPinhole()
    {
        foreach (View view in Views)
        {
            PinholeCamera core = new(view.Position, view.Attitude, double.DegreesToRadians(33.0), 640, 360);
            JsonElement camera = await page.CallAsync("geometry", "cameraOf", view.ForPage);
            object lens = new { width = 640, height = 360, fov = 33.0 };
            foreach (double[] pixel in new[] { [1.0, 1.0], [640.0, 360.0], new[] { 320.5, 180.5 }, [17.25, 300.0] })
            {
                Vector3D expected = core.RayThrough(pixel[0], pixel[1]).Direction.Normalized();
                double[] ray = await NumbersAsync("rayThrough", camera, lens, pixel);
                Vector3D point = view.Position + (3e5 * expected);
                double[] back = await NumbersAsync("project", camera, lens, new[] { point.X, point.Y, point.Z });

                Assert.InRange((new Vector3D(ray[0], ray[1], ray[2]) - expected).Length, 0.0, DirectionTolerance);
                Assert.Equal(pixel[0], back[0], 1e-6); // px: there and back through a ray
                Assert.Equal(pixel[1], back[1], 1e-6); // px: the same
            }
        }
    }

    [RequiresFact(Part.Chromium)]
    public async Task Project_PointBehindTheCamera_IsNone()
    {
        JsonElement camera = await page.CallAsync("geometry", "cameraOf", new View(0.0, 0.0, 1e6, 0.0, 0.0, 0.0).ForPage);

        JsonElement pixel = await page.CallAsync(
            "geometry", "project", camera, new { width = 10, height = 10, fov = 40.0 }, new[] { 4e6, 0.0, 0.0 });

        Assert.Equal(JsonValueKind.Null, pixel.ValueKind);
    }

    [RequiresFact(Part.Chromium)]
    public async Task MeetSphere_RayDownAndRayBesideTheMoon_MeetsTheNearSideAndNothing()
    {
        double[] hit = await NumbersAsync("meetSphere", new[] { 2e6, 0.0, 0.0 }, new[] { -1.0, 0.0, 0.0 });
        JsonElement miss = await page.CallAsync("geometry", "meetSphere", new[] { 2e6, 0.0, 0.0 }, new[] { 0.0, 1.0, 0.0 });
        JsonElement behind = await page.CallAsync("geometry", "meetSphere", new[] { 2e6, 0.0, 0.0 }, new[] { 1.0, 0.0, 0.0 });

        Assert.Equal([1_737_400.0, 0.0, 0.0], hit);
        Assert.Equal(JsonValueKind.Null, miss.ValueKind);
        Assert.Equal(JsonValueKind.Null, behind.ValueKind);
    }

    /// <summary>From two radii the limb is 60 degrees from the point below.</summary>
    [RequiresFact(Part.Chromium)]
    public async Task SeenParts_EquatorFromTwoRadii_EndsAtTheLimb()
    {
        object camera = new { position = new[] { 2.0 * 1_737_400.0, 0.0, 0.0 } };
        double[] longitudes = [.. Enumerable.Range(0, 515).Select(i => 0.7 * i)]; // none at 60 or 300, from the near side to the near side
        double[][] equator = [.. longitudes.Select(angle => new[]
        {
            1_737_400.0 * Math.Cos(double.DegreesToRadians(angle)), 1_737_400.0 * Math.Sin(double.DegreesToRadians(angle)), 0.0,
        })];

        JsonElement parts = await page.CallAsync("geometry", "seenParts", camera, equator);

        Assert.Equal(2, parts.GetArrayLength());
        Assert.Equal(60.0, LongitudeOf(parts[0][parts[0].GetArrayLength() - 1]), 1e-3); // a straight line between points 0.7 degrees apart
        Assert.Equal(-60.0, LongitudeOf(parts[1][0]), 1e-3);
        Assert.Equal(60.0, (await page.CallAsync("geometry", "limbAngle", camera)).GetDouble(), AngleTolerance);

        static double LongitudeOf(JsonElement point) =>
            double.RadiansToDegrees(Math.Atan2(point[1].GetDouble(), point[0].GetDouble()));
    }

    [RequiresFact(Part.Chromium)]
    public async Task SunAt_SunOverThePoleAndInTheEast_HasTheAnglesOfTheGlobe()
    {
        double root = Math.Sqrt(0.5);
        double[] at45North = [1_737_400.0 * root, 0.0, 1_737_400.0 * root];
        double[] origin = [1_737_400.0, 0.0, 0.0];

        JsonElement overPole = await page.CallAsync("geometry", "sunAt", at45North, new[] { 0.0, 0.0, 1e20 });
        JsonElement inEast = await page.CallAsync("geometry", "sunAt", origin, new[] { 1e20 * Math.Sqrt(0.75), 0.5e20, 0.0 });
        JsonElement overhead = await page.CallAsync("geometry", "sunAt", origin, new[] { 1e20, 0.0, 0.0 });

        Assert.Equal(45.0, overPole.GetProperty("elevation").GetDouble(), AngleTolerance);
        Assert.Equal(0.0, overPole.GetProperty("azimuth").GetDouble(), AngleTolerance);
        Assert.Equal(60.0, inEast.GetProperty("elevation").GetDouble(), AngleTolerance);
        Assert.Equal(90.0, inEast.GetProperty("azimuth").GetDouble(), AngleTolerance);
        Assert.Equal(JsonValueKind.Null, overhead.GetProperty("azimuth").ValueKind);
    }

    [RequiresFact(Part.Chromium)]
    public async Task GroundDistance_EquatorToPole_IsAQuarterOfTheCircumference()
    {
        JsonElement distance = await page.CallAsync(
            "geometry", "groundDistance", new[] { 1_737_400.0, 0.0, 0.0 }, new[] { 0.0, 0.0, 1_730_000.0 });

        Assert.Equal(2_729_101.537, distance.GetDouble(), 0.5);
        Assert.Equal(Math.PI / 2.0 * 1_737_400.0, distance.GetDouble(), 1e-6); // m: thousands of ulps
    }

    [RequiresFact(Part.Chromium)]
    public async Task Travelled_EastAlongTheEquatorAndOverThePole_GoesStraightOn()
    {
        JsonElement east = await page.CallAsync("geometry", "travelled", new View(0.0, 350.0, 1e5, 90.0, 10.0, 0.0).ForPage, 30.0, 0.0);
        JsonElement overPole = await page.CallAsync("geometry", "travelled", new View(80.0, 0.0, 1e5, 0.0, 10.0, 0.0).ForPage, 20.0, 0.0);

        Assert.Equal(20.0, east.GetProperty("longitude").GetDouble(), AngleTolerance);
        Assert.Equal(90.0, east.GetProperty("heading").GetDouble(), AngleTolerance);
        Assert.Equal(80.0, overPole.GetProperty("latitude").GetDouble(), AngleTolerance);
        Assert.Equal(180.0, overPole.GetProperty("longitude").GetDouble(), AngleTolerance);
        Assert.Equal(180.0, overPole.GetProperty("heading").GetDouble(), AngleTolerance);
    }

    /// <summary>An eighth of the sphere, a twelfth of its northern half both ways round, and 1 km² of almost flat ground.</summary>
    [RequiresFact(Part.Chromium)]
    public async Task EnclosedArea_PartsOfTheSphere_AreThoseOfTheirAngles()
    {
        const double radius = 1_737_400.0;
        const double sphere = 4.0 * Math.PI * radius * radius;
        double[] x = [radius, 0.0, 0.0];
        double[] pole = [0.0, 0.0, 5.0 * radius]; // heights do not count
        double[] east = [radius * Math.Cos(Math.PI / 6.0), radius / 2.0, 0.0];

        Assert.Equal(sphere / 8.0, await AreaAsync(x, [0.0, radius, 0.0], pole), sphere * AreaTolerance);
        Assert.Equal(sphere / 24.0, await AreaAsync(x, east, pole), sphere * AreaTolerance);
        Assert.Equal(sphere / 24.0, await AreaAsync(pole, east, x), sphere * AreaTolerance);
        Assert.Equal(
            1e6, await AreaAsync([radius, 0.0, 0.0], [radius, 1e3, 0.0], [radius, 1e3, 1e3], [radius, 0.0, 1e3]), FlatTolerance);
    }

    private async Task<double> AreaAsync(params double[][] points) =>
        (await page.CallAsync("geometry", "enclosedArea", [points])).GetDouble();

    private static void AssertSameAxes(UnitQuaternion expected, UnitQuaternion actual)
    {
        foreach (Vector3D axis in new[] { Vector3D.UnitX, Vector3D.UnitY, Vector3D.UnitZ })
        {
            Assert.InRange(((expected * axis) - (actual * axis)).Length, 0.0, DirectionTolerance);
        }
    }

    private static Vector3D PositionOf(double[] state) => new(state[1], state[2], state[3]);

    private static UnitQuaternion QuaternionOf(double[] state) => UnitQuaternion.FromComponents(state[4], state[5], state[6], state[7]);

    private async Task<double[]> NumbersAsync(string name, params object[] parameters) =>
        [.. (await page.CallAsync("geometry", name, parameters)).EnumerateArray().Select(number => number.GetDouble())];

    /// <summary>A view as the page has it, and the camera of Msisf.Core that it means; degrees, m.</summary>
    private sealed record View(double Latitude, double Longitude, double Altitude, double Heading, double Tilt, double Roll)
    {
        public object ForPage => new
        {
            mjd = 55289.25,
            latitude = Latitude,
            longitude = Longitude,
            altitude = Altitude,
            heading = Heading,
            tilt = Tilt,
            roll = Roll,
        };

        public Vector3D Position
        {
            get
            {
                (double sinLatitude, double cosLatitude) = Math.SinCos(double.DegreesToRadians(Latitude));
                (double sinLongitude, double cosLongitude) = Math.SinCos(double.DegreesToRadians(Longitude));
                return (1_737_400.0 + Altitude) * new Vector3D(cosLatitude * cosLongitude, cosLatitude * sinLongitude, sinLatitude);
            }
        }

        public UnitQuaternion Attitude => Boresight.MoonFromCamera(
            Position,
            Boresight.OffNadir(Position, double.DegreesToRadians(Tilt), double.DegreesToRadians(Heading)),
            Position,
            double.DegreesToRadians(Roll));

        public double[] StateOfCore =>
            [55289.25, Position.X, Position.Y, Position.Z, Attitude.X, Attitude.Y, Attitude.Z, Attitude.W];
    }
}
