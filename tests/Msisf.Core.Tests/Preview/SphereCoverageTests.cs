using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Preview;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Preview;

/// <summary>Shares of an image, against formulas of the disc and against a ray through each of many points of the image.</summary>
public sealed class SphereCoverageTests
{
    private const double Radius = MoonConstants.ReferenceRadius;

    /// <summary>
    /// 1, parts of the image: a grid of 32 x 32 is right to a thousandth, but for images fifty times as high as wide
    /// (docs/command-line-rules.md names it).
    /// </summary>
    private const double ShareTolerance = 3e-3;

    /// <summary>Points along an edge of the image in the comparison; a border is then right to about a thousandth of it.</summary>
    private const int PointsOfEdge = 400;

    private static readonly SceneLight SunAhead = new(new Vector3D(1.5e11, 0.0, 0.0), IsSun: true);

    /// <summary>The disc's radius in the image plane is tan(asin(R / D)) of tan(fov / 2), from the size of a pixel on.</summary>
    [Theory]
    [InlineData(2e6, 175.0)]
    [InlineData(1e7, 40.0)]
    [InlineData(4e8, 1.0)]
    [InlineData(4e8, 90.0)]
    [InlineData(1e12, 40.0)]
    public void Of_TheWholeDisc_HasTheAreaOfACircle(double distance, double fovDegrees)
    {
        SphereShare share = OfDisc(distance, fovDegrees, SunAhead);

        double radius = Math.Tan(Math.Asin(Radius / distance)) / Math.Tan(double.DegreesToRadians(fovDegrees) / 2.0);
        Assert.Equal(1.0, share.Moon / (Math.PI / 4.0 * radius * radius), ShareTolerance);
        Assert.Equal(1.0, share.Lit!.Value, ShareTolerance);
    }

    /// <summary>From far away the lit part of the disc is (1 + cos phase) / 2.</summary>
    [Theory]
    [InlineData(0.0)]
    [InlineData(45.0)]
    [InlineData(90.0)]
    [InlineData(135.0)]
    [InlineData(170.0)]
    [InlineData(179.0)]
    public void Of_ThePhasesFromFarAway_AreTheirLitPart(double phaseDegrees)
    {
        (double sin, double cos) = Math.SinCos(double.DegreesToRadians(phaseDegrees));
        SphereShare share = OfDisc(4e9, 0.1, new SceneLight(1e16 * new Vector3D(cos, 0.6 * sin, 0.8 * sin), IsSun: true));

        double lit = (1.0 + cos) / 2.0;
        Assert.Equal(lit, share.Lit!.Value, ShareTolerance);
        Assert.True(share.Lit > 0.0, "the crescent is missed");
    }

    [Fact]
    public void Of_NewMoon_HasNoLitGround() =>
        Assert.Equal(0.0, OfDisc(4e8, 1.0, new SceneLight(new Vector3D(-1.5e11, 0.0, 0.0), IsSun: true)).Lit);

    [Fact]
    public void Of_ACameraInsideTheSphere_SeesNothing() =>
        Assert.Equal(new SphereShare(0.0, null), OfDisc(Radius - 1.0, 40.0, SunAhead));

    [Fact]
    public void Of_ACameraOnTheSphere_SeesHalfOfItAboveTheHorizonNothing()
    {
        PinholeCamera level = new(new Vector3D(Radius, 0.0, 0.0), CameraCases.Attitude(Vector3D.UnitZ, Vector3D.UnitY), 1.0, 100, 100);
        PinholeCamera upward = new(new Vector3D(Radius, 0.0, 0.0), CameraCases.Attitude(Vector3D.UnitX, Vector3D.UnitY), 1.0, 100, 100);

        Assert.Equal(0.5, SphereCoverage.Of(level, SunAhead, Radius).Moon, ShareTolerance);
        Assert.Equal(0.0, SphereCoverage.Of(upward, SunAhead, Radius).Moon);
    }

    /// <summary>
    /// The image's diagonal reaches the limb, which is a circle about the Moon's direction, at sqrt(2) tan(fov / 2) = tan(angle between).
    /// </summary>
    [Theory]
    [InlineData(1e-3, true)]
    [InlineData(-1e-3, false)]
    public void Of_ACornerOfTheImage_IsFound(double overlap, bool shows)
    {
        double half = 0.2;
        double corner = Math.Atan(Math.Sqrt(2.0) * Math.Tan(half));
        double aside = Math.Asin(Radius / 4e6) + corner - overlap;
        Vector3D forward = new(-Math.Cos(aside), Math.Sin(aside), 0.0);
        Vector3D across = Vector3D.Cross(forward, Vector3D.UnitZ);
        PinholeCamera camera = new(
            new Vector3D(4e6, 0.0, 0.0), CameraCases.Attitude(forward, (across + Vector3D.UnitZ).Normalized()), 2.0 * half, 100, 100);

        SphereShare share = SphereCoverage.Of(camera, SunAhead, Radius);

        Assert.Equal(shows, share.Moon > 0.0);
        Assert.InRange(share.Moon, 0.0, 1e-4);
    }

    /// <summary>
    /// A camera 100 km over the sphere, whose limb is 71 degrees from the nadir, turned about a line of sight from which no corner of the
    /// image reaches it: half the image's diagonal is atan(sqrt(1 + aspect^2) tan(fov / 2)).
    /// </summary>
    [Theory]
    [InlineData(120.0, 40.0, 64, 64)]
    [InlineData(75.0, 5.0, 1024, 1024)]
    [InlineData(72.5, 2.0, 640, 480)]
    [InlineData(95.0, 5.0, 50, 200)]
    [InlineData(180.0, 120.0, 100, 30)]
    public void Of_EachRollBesideTheSphere_IsExactlyZero(double offNadir, double fov, int width, int height)
    {
        Vector3D position = new(Radius + 1e5, 0.0, 0.0);
        (double sin, double cos) = Math.SinCos(double.DegreesToRadians(offNadir));
        Vector3D forward = new(-cos, sin, 0.0);
        Vector3D across = Vector3D.Cross(forward, Vector3D.UnitZ).Normalized();
        for (int roll = 0; roll < 720; roll++)
        {
            (double right, double up) = Math.SinCos(double.DegreesToRadians(0.5 * roll));
            PinholeCamera camera = new(
                position, CameraCases.Attitude(forward, (right * across) + (up * Vector3D.UnitZ)), double.DegreesToRadians(fov), width,
                height);

            SphereShare share = SphereCoverage.Of(camera, SunAhead, Radius);

            Assert.Equal(0L, BitConverter.DoubleToInt64Bits(share.Moon)); // no -0
            Assert.Null(share.Lit);
        }
    }

    /// <summary>Cameras from 50 m to 1e9 m, at poles, limbs and corners, with images from 1:50 to 50:1.</summary>
    [Fact]
    public void Of_CamerasOfAllKinds_AreThoseOfManyRays()
    {
        FunctionGrid sphere = FunctionGrid.OfHeights(1, (_, _) => 0.0);
        int cases = TestLength.Of(2 * CameraCases.Kinds, 600);
        int seen = 0;
        for (int number = 0; number < cases; number++)
        {
            (PinholeCamera camera, Vector3D sun, string kind) = CameraCases.Make(number, sphere, 10_000);
            SphereShare share = SphereCoverage.Of(camera, new SceneLight(sun, IsSun: true), Radius);
            (double moon, double lit) = ByRays(camera, sun);

            string name = $"case {number}, {kind}";
            AssertNear(moon, share.Moon, $"{name}: the Moon's share");
            AssertNear(lit, share.Moon * (share.Lit ?? 0.0), $"{name}: the lit share");
            seen += moon > 0.0 && moon < 1.0 && lit > 0.0 && lit < moon ? 1 : 0;
        }

        Assert.True(seen > cases / 10, $"only {seen} of {cases} cases have both borders");
    }

    private static void AssertNear(double expected, double actual, string what) =>
        Assert.True(Math.Abs(expected - actual) <= ShareTolerance, $"{what}: {actual}, by rays {expected}");

    private static (double Moon, double Lit) ByRays(PinholeCamera camera, Vector3D sun)
    {
        int moon = 0;
        int lit = 0;
        for (int row = 0; row < PointsOfEdge; row++)
        {
            for (int column = 0; column < PointsOfEdge; column++)
            {
                double x = 0.5 + ((column + 0.5) / PointsOfEdge * camera.Width);
                double y = 0.5 + ((row + 0.5) / PointsOfEdge * camera.Height);
                if (ReferenceSphere.Lola.TryFirstHit(camera.RayThrough(x, y), out Vector3D point))
                {
                    moon++;
                    lit += Vector3D.Dot(point, sun - point) > 0.0 ? 1 : 0;
                }
            }
        }

        return (moon / (double)(PointsOfEdge * PointsOfEdge), lit / (double)(PointsOfEdge * PointsOfEdge));
    }

    private static SphereShare OfDisc(double distance, double fovDegrees, SceneLight light)
    {
        Vector3D position = new(distance, 0.0, 0.0);
        return SphereCoverage.Of(
            new PinholeCamera(position, NadirPointing.MoonFromCamera(position), double.DegreesToRadians(fovDegrees), 100, 100),
            light,
            Radius);
    }
}
