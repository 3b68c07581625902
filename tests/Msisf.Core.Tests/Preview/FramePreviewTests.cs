using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Preview;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Msisf.Core.Tracing;
using Xunit;

namespace Msisf.Core.Tests.Preview;

public sealed class FramePreviewTests
{
    private const double Radius = MoonConstants.ReferenceRadius;
    private const double Fov = 0.5;
    private const int Width = 400;

    /// <summary>Degrees: a direction is rounded to 1e-15 rad; the ground is up to 50 heights away along it.</summary>
    private const double AngleTolerance = 1e-10;

    /// <summary>Parts of a length: as above.</summary>
    private const double LengthTolerance = 1e-9;

    private static readonly SceneLight Sun = new(new Vector3D(1.5e11, 0.0, 0.0), IsSun: true);

    [Fact]
    public void Of_StraightAboveAPoint_ShowsThatPoint()
    {
        Vector3D position = (Radius + 1e5) * Up(-30.0, 40.0);

        FramePreview view = Of(position, NadirPointing.MoonFromCamera(position));

        AssertPoint(-30.0, 40.0, view.SubSpacecraft);
        AssertPoint(-30.0, 40.0, view.Boresight!.Value.Point);
        Assert.Equal(0.0, view.OffNadir, Rounding.OfChains);
        Assert.Equal(new SphereShare(1.0, 1.0), view.Share);

        // A Sun without parallax: cos(zenith angle) = cos(30) cos(40), less the Moon's radius over the Sun's distance (4e-4 degrees).
        double elevation = 90.0 - double.RadiansToDegrees(Math.Acos(Math.Cos(Math.PI / 6.0) * Math.Cos(Math.PI * 40.0 / 180.0)));
        Assert.Equal(elevation, double.RadiansToDegrees(view.Boresight.Value.Sun!.Value.Elevation), 1e-3);

        double metresPerPixel = 2.0 * 1e5 * Math.Tan(Fov / 2.0) / Width;
        Assert.Equal(1.0, view.Boresight.Value.MetresPerPixel / metresPerPixel, LengthTolerance);

        // 64 px/deg: a cell is a 23 040th of the equator.
        Assert.Equal(1.0, view.PixelsPerCell(64)!.Value * metresPerPixel / (2.0 * Math.PI * Radius / 23040.0), LengthTolerance);
    }

    [Fact]
    public void Of_LooksAway_ShowsNothing()
    {
        Vector3D position = new(0.0, -3e6, 0.0);

        FramePreview view = Of(position, CameraCases.Attitude(-Vector3D.UnitY, Vector3D.UnitX));

        Assert.Null(view.Boresight);
        Assert.Null(view.PixelsPerCell(4));
        Assert.Equal(new SphereShare(0.0, null), view.Share);
        Assert.Equal(Math.PI, view.OffNadir, Rounding.OfChains);
        AssertPoint(0.0, 270.0, view.SubSpacecraft);
    }

    /// <summary>From two radii above the centre the limb stands 30 degrees off the nadir, and 60 degrees of the Moon away.</summary>
    [Theory]
    [InlineData(29.999, true)]
    [InlineData(30.001, false)]
    public void Of_TheLimb_IsTheLastThatHasGround(double offNadir, bool hasGround)
    {
        (double sin, double cos) = Math.SinCos(double.DegreesToRadians(offNadir));
        Vector3D position = new(2.0 * Radius, 0.0, 0.0);

        FramePreview view = Of(position, CameraCases.Attitude(new Vector3D(-cos, 0.0, sin), Vector3D.UnitY));

        Assert.Equal(offNadir, double.RadiansToDegrees(view.OffNadir), AngleTolerance);
        Assert.Equal(hasGround, view.Boresight is not null);
        Assert.InRange(view.Share.Moon, 0.45, 0.51);
        if (view.Boresight is { } ground)
        {
            // Half a degree of the limb or less: asin(2 sin(29.999)) - 29.999 = 59.65 degrees of latitude.
            double latitude = double.RadiansToDegrees(Math.Asin(2.0 * sin)) - offNadir;
            AssertPoint(latitude, 0.0, ground.Point, 1e-6);
        }
    }

    [Fact]
    public void Of_StraightAboveAPole_HasNoAzimuth()
    {
        Vector3D position = new(0.0, 0.0, Radius + 5e4);

        FramePreview view = Of(position, NadirPointing.MoonFromCamera(position));

        Assert.Equal(90.0, double.RadiansToDegrees(view.Boresight!.Value.Point.Latitude), AngleTolerance);
        Assert.Null(view.Boresight.Value.Sun!.Value.Azimuth);
        // degrees: the Sun is not infinitely far
        Assert.Equal(0.0, double.RadiansToDegrees(view.Boresight.Value.Sun.Value.Elevation), 1e-3);
        Assert.Equal(0.5, view.Share.Lit!.Value, 0.01); // a sample of the pixels
    }

    [Fact]
    public void Of_TheNightSide_ShowsNoLitGround()
    {
        Vector3D position = new(-(Radius + 1e5), 0.0, 0.0);

        FramePreview view = Of(position, NadirPointing.MoonFromCamera(position));

        Assert.Equal(new SphereShare(1.0, 0.0), view.Share);
        Assert.InRange(double.RadiansToDegrees(view.Boresight!.Value.Sun!.Value.Elevation), -90.0, -89.9);
    }

    [Fact]
    public void Of_ALampAtTheCamera_LightsAllAndIsNoSun()
    {
        Vector3D position = new(-(Radius + 1e6), 0.0, 0.0);
        PinholeCamera camera = new(position, NadirPointing.MoonFromCamera(position), 2.0, Width, Width);

        FramePreview view = FramePreview.Of(camera, new SceneLight(position, IsSun: false), terrain: null);

        Assert.Null(view.Boresight!.Value.Sun);
        Assert.Equal(1.0, view.Share.Lit);
        Assert.InRange(view.Share.Moon, 0.1, 0.9);
    }

    /// <summary>Over a mare 2 500 m deep the ground is 1 000 m away, and LOLA's sphere above the camera.</summary>
    [Fact]
    public void Of_ALowCameraOverAMare_SeesTheMare()
    {
        Vector3D position = (Radius - 2500.0 + 1000.0) * Up(10.0, 5.0);
        PinholeCamera camera = new(position, NadirPointing.MoonFromCamera(position), Fov, Width, Width);

        FramePreview view = FramePreview.Of(camera, Sun, FunctionGrid.HighlandsAndMare(4));

        // The facets of the mesh are chords: in their middles up to 8.3 m below the mare's sphere.
        Assert.InRange(view.Boresight!.Value.MetresPerPixel * Width / (2.0 * Math.Tan(Fov / 2.0)), 1000.0, 1008.3);
        Assert.Equal(1.0, view.Share.Moon, Rounding.OfChains);
    }

    [Fact]
    public void Of_AHighCameraOverAMare_SeesLolasSphere()
    {
        Vector3D position = (Radius + 1e5) * Up(10.0, 5.0);
        PinholeCamera camera = new(position, NadirPointing.MoonFromCamera(position), Fov, Width, Width);

        FramePreview view = FramePreview.Of(camera, Sun, FunctionGrid.HighlandsAndMare(4));

        Assert.Equal(1e5, view.Boresight!.Value.MetresPerPixel * Width / (2.0 * Math.Tan(Fov / 2.0)), 1e-3); // m: of 100 km, to rounding
    }

    /// <summary>With a tracer the middle of the image is on the mare, 2 500 m below the sphere, and the pixel so much wider.</summary>
    [Fact]
    public void Of_AHighCameraOverAMareWithATracer_SeesTheMare()
    {
        Vector3D position = (Radius + 1e5) * Up(10.0, 5.0);
        PinholeCamera camera = new(position, NadirPointing.MoonFromCamera(position), Fov, Width, Width);
        FunctionGrid ground = FunctionGrid.HighlandsAndMare(4);

        FramePreview view = FramePreview.Of(camera, Sun, ground, new TerrainTracer(ground));

        Assert.InRange(view.Boresight!.Value.MetresPerPixel * Width / (2.0 * Math.Tan(Fov / 2.0)), 102_500.0, 102_508.3);
    }

    /// <summary>A map of 100 km around the south pole fills the image over the pole; 200 km beside it nothing of it is seen.</summary>
    [Theory]
    [InlineData(-90.0, false)]
    [InlineData(-83.4, true)]
    public void Of_AMapAlone_IsSeenOnlyWhereItIs(double latitude, bool isBeside)
    {
        PolarFunctionGrid map = PolarFunctionGrid.Rugged(isSouth: true, 1000.0, 100, 49.5, 49.5);
        Vector3D position = (Radius + 2e4) * Up(latitude, 30.0);
        PinholeCamera camera = new(position, NadirPointing.MoonFromCamera(position), Fov, Width, Width);

        FramePreview view = FramePreview.Of(camera, Sun, map);

        Assert.Equal(isBeside, view.IsBesideMap);
        Assert.Equal(isBeside, view.Boresight is null);
        Assert.Equal(isBeside ? 0.0 : 1.0, view.Share.Moon, Rounding.OfChains);
    }

    /// <summary>The native renderer takes any distance; what is printed has no infinity.</summary>
    [Fact]
    public void Of_AsFarAwayAsNumbersReach_IsFinite()
    {
        Vector3D position = new(1.7e308, 0.0, 0.0);
        PinholeCamera camera = new(position, NadirPointing.MoonFromCamera(position), 3.14, 1, 1);

        FramePreview view = FramePreview.Of(camera, Sun, terrain: null);

        Assert.Equal(0.0, view.OffNadir, Rounding.OfChains);
        Assert.Null(view.Boresight);
        Assert.Equal(new SphereShare(0.0, null), view.Share);
    }

    private static FramePreview Of(Vector3D position, UnitQuaternion moonFromCamera) =>
        FramePreview.Of(new PinholeCamera(position, moonFromCamera, Fov, Width, Width), Sun, terrain: null);

    private static Vector3D Up(double latitude, double longitude) =>
        new SelenographicPoint(double.DegreesToRadians(latitude), double.DegreesToRadians(longitude)).ToDirectionBodyFixed();

    private static void AssertPoint(double latitude, double longitude, SelenographicPoint point, double tolerance = AngleTolerance)
    {
        Assert.Equal(latitude, double.RadiansToDegrees(point.Latitude), tolerance);
        Assert.Equal(longitude, double.RadiansToDegrees(point.Longitude), tolerance);
    }
}
