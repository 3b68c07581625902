using FsCheck;
using FsCheck.Fluent;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Camera;

public class PinholeCameraTests
{
    private static readonly Gen<double> Parts = Gen.Choose(0, 1_000_000).Select(i => i / 1e6);

    [Theory]
    [InlineData(1, 1, -0.75, 0.25)]
    [InlineData(4, 1, 0.75, 0.25)]
    [InlineData(1, 2, -0.75, -0.25)]
    [InlineData(4, 2, 0.75, -0.25)]
    public void RayThrough_PixelCentre_LiesHalfAPixelInsideThePlane(int x, int y, double right, double up)
    {
        // 4 x 2 px, FOV 90 degrees: the plane is 2 wide and 1 high, 1 away.
        PinholeCamera camera = new(new Vector3D(5.0, 0.0, 0.0), UnitQuaternion.Identity, Math.PI / 2.0, 4, 2);

        Vector3D direction = camera.RayThrough(x, y).Direction;

        Assert.Equal(0.0, (direction - new Vector3D(-1.0, right, up)).Length, 15);
    }

    [Fact]
    public void TryProject_RayThroughAnyPoint_ComesBackToIt() =>
        Prop.ForAll(
            Arb.From(Gen.Zip(Gen.Zip(Parts, Parts), Gen.Zip(Parts, Parts))),
            parts =>
            {
                ((double a, double b), (double c, double d)) = parts;
                UnitQuaternion orientation = UnitQuaternion.FromAxisAngle(new Vector3D(a - 0.5, b - 0.5, 1.0), 6.0 * c);
                PinholeCamera camera = new(new Vector3D(2e6, 1e6, -3e6), orientation, 0.001 + (2.5 * d), 1900, 1200);
                RenderingPoint expected = new(3000.0 * b, 2000.0 * c);

                bool isInFront = camera.TryProject(123.0 * camera.RayThrough(expected.X, expected.Y).Direction, out RenderingPoint point);

                // px: rounding of the direction (4e-16) times the focal length, 1e6 px at FOV 0.001 rad, and of the sum.
                double tolerance = (1200.0 * camera.Direction.Length * 2e-15) + 1e-11;
                return isInFront && double.Hypot(point.X - expected.X, point.Y - expected.Y) <= tolerance;
            })
            .Check(Config.QuickThrowOnFailure.WithMaxTest(1000).WithReplay(20120222UL, 1UL));

    [Theory]
    [InlineData(1.0, 0.0, 0.0)]
    [InlineData(0.0, 1.0, 0.0)]
    [InlineData(0.0, 0.0, 0.0)]
    [InlineData(-1e-320, 1.0, 0.0)]
    [InlineData(double.NaN, 1.0, 0.0)]
    public void TryProject_NotForward_IsRefused(double x, double y, double z)
    {
        PinholeCamera camera = new(default, UnitQuaternion.Identity, 0.7, 64, 64);

        Assert.False(camera.TryProject(new Vector3D(x, y, z), out RenderingPoint point));
        Assert.Equal(default, point);
    }

    [Theory]
    [InlineData(0.0)]
    [InlineData(9e-13)]
    [InlineData(Math.PI)]
    [InlineData(-0.7)]
    [InlineData(double.NaN)]
    public void Constructor_FieldOfViewOutOfRange_IsBadInput(double fov) =>
        Assert.Throws<BadInputException>(() => new PinholeCamera(default, UnitQuaternion.Identity, fov, 64, 64));

    [Theory]
    [InlineData(0, 64)]
    [InlineData(64, 0)]
    public void Constructor_NoPixels_IsACallersBug(int width, int height) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new PinholeCamera(default, UnitQuaternion.Identity, 0.7, width, height));

    [Theory]
    [InlineData(double.PositiveInfinity)]
    [InlineData(1.7e308)] // each component is finite, the distance is not
    public void Constructor_DistanceNotFinite_IsBadInput(double y) =>
        Assert.Throws<BadInputException>(() => new PinholeCamera(new Vector3D(1.7e308, y, 0.0), UnitQuaternion.Identity, 0.7, 64, 64));

    [Fact]
    public void Constructor_DefaultQuaternion_IsABug() =>
        Assert.Throws<ArgumentException>(() => new PinholeCamera(default, default, 0.7, 64, 64));
}
