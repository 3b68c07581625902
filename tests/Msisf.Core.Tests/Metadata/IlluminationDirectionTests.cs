using Msisf.Core.Camera;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Xunit;

namespace Msisf.Core.Tests.Metadata;

public class IlluminationDirectionTests
{
    private const double Radius = 1_737_400.0;
    private const double SunDistance = 1.5e11;

    /// <summary>A nadir camera over (0, 0), north up: it looks along -x, y is right, z is up.</summary>
    private static readonly PinholeCamera Nadir = new(new Vector3D(2e6, 0.0, 0.0), UnitQuaternion.Identity, 0.7, 101, 101);

    [Theory]
    [InlineData(0.0, -1.0, 0.0)]
    [InlineData(1.0, -1.0, 45.0)]
    [InlineData(1.0, 0.0, 90.0)]
    [InlineData(0.0, 1.0, 180.0)]
    [InlineData(-1.0, 0.0, 270.0)]
    [InlineData(-1.0, -1.0, 315.0)]
    public void At_SunToOneSide_CountsCounterClockwiseFromDown(double right, double up, double expectedDegrees)
    {
        double? direction = IlluminationDirection.At(
            Nadir, -Vector3D.UnitX, Radius * Vector3D.UnitX, SunDistance * new Vector3D(1.0, right, up));

        Assert.Equal(expectedDegrees, double.RadiansToDegrees(direction!.Value), 12);
    }

    /// <summary>As the thesis has it: the image of the point 1000 m along the ground towards the Sun, here through the lens.</summary>
    [Theory]
    [InlineData("barrel")]
    [InlineData("prism")]
    [InlineData("radial-factor")]
    [InlineData("fisheye")]
    [InlineData("principal-point")]
    public void At_CameraWithLens_IsTheDirectionInTheDistortedImage(string lens)
    {
        CameraModel model = LensCases.Of(lens, 0.36, 200, 150);
        FrameCamera camera = model.At(new CameraState(new Vector3D(2e6, 0.0, 0.0), UnitQuaternion.Identity));
        Vector3D sun = SunDistance * new Vector3D(1.0, 0.7, 1.4);
        foreach ((double x, double y) in ((double, double)[])[(60.0, 40.0), (150.0, 100.0), (100.0, 20.0)])
        {
            Ray ray = camera.RayThrough(x, y);
            Assert.True(ReferenceSphere.Lola.TryFirstHit(ray, out Vector3D point));
            Vector3D along = Vector3D.Cross(point, Vector3D.Cross(sun - point, point)).Normalized();
            Assert.True(camera.TryProject(point + (10.0 * along) - camera.PositionBodyFixed, out RenderingPoint towards));
            Assert.True(camera.TryProject(point - (10.0 * along) - camera.PositionBodyFixed, out RenderingPoint from));

            double direction = IlluminationDirection.At(camera, ray.Direction, point, sun)!.Value;

            double expected = Math.Atan2(towards.X - from.X, towards.Y - from.Y);
            Assert.Equal(0.0, Math.Sin(direction - expected), 1e-7); // rad: projections of 20 m of a sphere of 1.7e6 m
            Assert.True(Math.Cos(direction - expected) > 0.0);
        }
    }

    [Theory]
    [InlineData(1.0)]
    [InlineData(-1.0)]
    public void At_SunInZenithOrNadirOfThePoint_IsUndefined(double side) =>
        Assert.Null(IlluminationDirection.At(Nadir, -Vector3D.UnitX, Radius * Vector3D.UnitX, side * SunDistance * Vector3D.UnitX));

    [Theory]
    [InlineData(0.9e-7, false)]
    [InlineData(1.1e-7, true)]
    public void At_SunNearTheZenith_IsUndefinedWithinTheTolerance(double zenithAngle, bool isDefined)
    {
        double? direction = IlluminationDirection.At(
            Nadir, -Vector3D.UnitX, Radius * Vector3D.UnitX, SunDistance * new Vector3D(1.0, zenithAngle, 0.0));

        Assert.Equal(isDefined, direction.HasValue);
    }

    [Fact]
    public void At_GroundLineSeenEndOn_IsUndefined()
    {
        PinholeCamera atGroundLevel = new(
            new Vector3D(Radius, -1000.0, 0.0), UnitQuaternion.FromAxisAngle(Vector3D.UnitZ, -Math.PI / 2.0), 0.7, 101, 101);

        Assert.Null(IlluminationDirection.At(
            atGroundLevel, Vector3D.UnitY, Radius * Vector3D.UnitX, SunDistance * Vector3D.UnitY));
    }

    [Fact]
    public void At_LightInThePointItself_IsUndefined() =>
        Assert.Null(IlluminationDirection.At(Nadir, -Vector3D.UnitX, Radius * Vector3D.UnitX, Radius * Vector3D.UnitX));

    [Fact]
    public void At_GroundLineRunsBehindTheCamera_StillPointsTowardsTheSun()
    {
        // 10 m up, looking north along the ground with the Sun in the south: 1000 m towards it lies behind the camera, and its
        // projection through the focal point would come out at the top of the image.
        PinholeCamera low = new(
            new Vector3D(Radius + 10.0, 0.0, 0.0), UnitQuaternion.FromAxisAngle(Vector3D.UnitY, Math.PI / 2.0), 0.7, 101, 101);
        Vector3D point = Radius * new Vector3D(1.0, 0.0, 5e-5);

        double? direction = IlluminationDirection.At(low, point - low.PositionBodyFixed, point, SunDistance * new Vector3D(0.1, 0.0, -1.0));

        Assert.Equal(0.0, double.RadiansToDegrees(direction!.Value), 9);
    }

    [Fact]
    public void At_LightAtTheCamera_PointsFromTheGroundToBelowTheCamera()
    {
        Vector3D north = Radius * new Vector3D(Math.Cos(0.1), 0.0, Math.Sin(0.1));

        double? direction = IlluminationDirection.At(Nadir, north - Nadir.PositionBodyFixed, north, Nadir.PositionBodyFixed);

        Assert.Equal(0.0, double.RadiansToDegrees(direction!.Value), 12);
    }

    [Fact]
    public void At_LampAtACamera1MetreUp_KeepsItsDigits()
    {
        // tests/reference/illumination.py, pixel(...) with these numbers; 1.6e-7 degrees off if the rounded point gives the way to the
        // lamp.
        PinholeCamera camera = new(
            new Vector3D(-189699.6133239057, 281826.5093496118, 1703863.4395424302),
            UnitQuaternion.FromComponents(0.04287626691315912, 0.1365091846156505, 0.6489259289773556, 0.7472763926098815),
            2.2201833553492025,
            114,
            9152);
        Ray ray = camera.RayThrough(76, 8738);
        Assert.True(ReferenceSphere.Lola.TryFirstHit(ray, out Vector3D point));

        double? direction = IlluminationDirection.At(camera, ray.Direction, point, camera.PositionBodyFixed);

        Assert.Equal(336.65459325519314, double.RadiansToDegrees(direction!.Value), 12);
    }
}
