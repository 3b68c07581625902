using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Tests.Support;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Camera;

public sealed class CameraModelTests
{
    /// <summary>px: what the issue asks of a pixel that is undistorted and distorted.</summary>
    private const double RoundTrip = 1e-9;

    [Theory]
    [MemberData(nameof(Lenses))]
    public void TryToImage_IdealPointOfAPixel_ComesBackToIt(string lens, double tangent)
    {
        CameraModel model = LensCases.Of(lens, tangent, 1000, 700);
        Random random = new(1);
        List<(double X, double Y)> points = [(0.5, 0.5), (1000.5, 0.5), (0.5, 700.5), (1000.5, 700.5), (1.0, 1.0), (1000.0, 700.0)];
        for (int i = 0; i < 200; i++)
        {
            points.Add((0.5 + (1000.0 * random.NextDouble()), 0.5 + (700.0 * random.NextDouble())));
        }

        foreach ((double x, double y) in points)
        {
            (double right, double down) = model.ToIdeal(x, y);
            Assert.True(model.TryToImage(right, down, out RenderingPoint back));
            Assert.True(double.Hypot(back.X - x, back.Y - y) <= RoundTrip, $"({x}, {y}) came back as {back}");
        }
    }

    [Theory]
    [InlineData(-3, -3, 106, 76)]
    [InlineData(10, 20, 50, 30)]
    public void Window_SamePartAgain_IsTheSameObject(int left, int top, int width, int height)
    {
        CameraModel model = LensCases.Of("barrel", 0.5, 100, 70);

        CameraModel window = model.Window(left, top, width, height);

        Assert.Same(window, model.Window(left, top, width, height));
        CameraModel other = model.Window(left, top + 1, width, height);
        Assert.Equal(window.PrincipalY - 1.0, other.PrincipalY);
        Assert.Equal(window.ToIdeal(5.0, 6.0), model.Window(left, top, width, height).ToIdeal(5.0, 6.0));
    }

    [Theory]
    [MemberData(nameof(Lenses))]
    public void TryProject_RayThroughAnyPoint_ComesBackToIt(string lens, double tangent)
    {
        CameraState state = new(new Vector3D(1.9e6, 2e5, -3e5), UnitQuaternion.FromComponents(0.1, 0.7, -0.1, 0.7));
        FrameCamera camera = LensCases.Of(lens, tangent, 640, 480).At(state);
        foreach ((double x, double y) in ((double, double)[])[(1.0, 1.0), (640.0, 480.0), (320.25, 17.5), (600.0, 240.0)])
        {
            Assert.True(camera.TryProject(123.0 * camera.RayThrough(x, y).Direction, out RenderingPoint point));
            Assert.Equal(x, point.X, RoundTrip);
            Assert.Equal(y, point.Y, RoundTrip);
        }

        Assert.False(camera.TryProject(-camera.ForwardBodyFixed, out _));
    }

    [Theory]
    [MemberData(nameof(Lenses))]
    public void Window_PixelsOfAPart_ShowWhatTheyShowInTheWhole(string lens, double tangent)
    {
        CameraModel whole = LensCases.Of(lens, tangent, 640, 480);

        CameraModel window = whole.Window(left: 600, top: 17, width: 40, height: 3);

        foreach ((double x, double y) in ((double, double)[])[(1.0, 1.0), (40.0, 3.0), (17.25, 2.5)])
        {
            (double right, double down) = whole.ToIdeal(x + 600.0, y + 17.0);
            (double windowRight, double windowDown) = window.ToIdeal(x, y);
            Assert.Equal(right, windowRight, 1e-14); // the offset is added to hundreds of pixels: last digits of these, as tangents
            Assert.Equal(down, windowDown, Rounding.OfTurns);
        }

        Assert.Same(whole, whole.Window(0, 0, 640, 480));

        CameraModel wider = whole.Window(left: -3, top: -2, width: 650, height: 484);
        foreach ((double x, double y) in ((double, double)[])[(1.0, 1.0), (640.0, 480.0), (-2.0, -1.0)])
        {
            (double right, double down) = whole.ToIdeal(x, y);
            (double widerRight, double widerDown) = wider.ToIdeal(x + 3.0, y + 2.0);
            Assert.Equal(right, widerRight, 1e-12); // the lens is inverted in a grid of its own
            Assert.Equal(down, widerDown, Rounding.OfChains);
        }
    }

    [Theory]
    [InlineData(0.1, 512, 384)]
    [InlineData(1.2, 1000, 700)]
    public void Simplified_PlainCamera_IsTheThesissOwn(double fieldOfView, int width, int height)
    {
        double focal = 0.5 * width / Math.Tan(0.5 * fieldOfView);
        (double, double) middle = (0.5 * (width + 1), 0.5 * (height + 1));
        Distortion none = new OpenCvDistortion([0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0], [0.0, 0.0, 0.0, 0.0]);

        CameraModel model = new CameraModel(width, height, (focal, focal), middle, 0.0, none).Simplified();

        Assert.Null(model.Distortion);
        Assert.Equal(fieldOfView, model.FieldOfView, 1e-15); // some last digits of an angle below 1 rad
        FrameCamera camera = model.At(new CameraState(new Vector3D(1.9e6, 0.0, 0.0), UnitQuaternion.Identity));
        PinholeCamera thesis = new(new Vector3D(1.9e6, 0.0, 0.0), UnitQuaternion.Identity, model.FieldOfView, width, height);
        Assert.Equal(thesis.RayThrough(3.0, 7.0), camera.RayThrough(3.0, 7.0));
    }

    /// <summary>The general pinhole's vectors, for POV-Ray, give the rays of the camera matrix.</summary>
    [Fact]
    public void RayThrough_PrincipalPointAndSkew_IsTheCameraMatrixs()
    {
        CameraModel model = LensCases.Of("principal-point", 0.4, 640, 480);
        FrameCamera camera = model.At(new CameraState(new Vector3D(1.9e6, 0.0, 0.0), UnitQuaternion.Identity));
        foreach ((double x, double y) in ((double, double)[])[(1.0, 1.0), (640.0, 480.0), (320.25, 17.5)])
        {
            double down = (y - model.PrincipalY) / model.FocalY;
            double right = (x - model.PrincipalX - (model.Skew * down)) / model.FocalX;
            Vector3D expected = camera.ForwardBodyFixed + (right * camera.UnitRight) - (down * camera.UnitUp);
            Assert.Equal(0.0, Vector3D.AngleBetween(expected, camera.RayThrough(x, y).Direction), 1e-15); // some last digits of 1
        }
    }

    [Theory]
    [InlineData(-0.4, "(")]
    [InlineData(-5.0, "(")]
    public void New_CoefficientsThatFoldTheImage_AreRefused(double k1, string named)
    {
        BadInputException error = Assert.Throws<BadInputException>(() => new CameraModel(
            1000, 1000, (600.0, 600.0), (500.5, 500.5), 0.0, new OpenCvDistortion([k1], [])));

        Assert.Contains($"do not invert inside the image: pixel {named}", error.Message, StringComparison.Ordinal);
    }

    /// <summary>
    /// r (1 + k1 r2) is greatest at 1 / sqrt(-3 k1): with k1 = -1/3 at r = 1, where it is 2/3. The corner lies at sqrt(2) / 2 over the
    /// focal
    /// length.
    /// </summary>
    [Theory]
    [InlineData(1.061, false)]
    [InlineData(1.060, true)]
    public void New_ImageUpToTheFold_IsTaken(double focal, bool isRefused)
    {
        const int Size = 1000;
        void Make() => _ = new CameraModel(
            Size, Size, (focal * Size, focal * Size), (500.5, 500.5), 0.0, new OpenCvDistortion([-1.0 / 3.0], []));
        if (isRefused)
        {
            Assert.Throws<BadInputException>(Make);
        }
        else
        {
            Make();
        }
    }

    /// <summary>A fisheye without coefficients measures the angle itself.</summary>
    [Theory]
    [InlineData(84.9, false)]
    [InlineData(85.0, true)]
    [InlineData(89.0, true)]
    public void New_FieldOf170Degrees_IsRefused(double degrees, bool isRefused)
    {
        double focal = 500.0 / (degrees * Math.PI / 180.0);
        void Make() => _ = new CameraModel(1000, 1, (focal, focal), (500.5, 1.0), 0.0, new FisheyeDistortion([]));
        if (isRefused)
        {
            Assert.Contains("170 degrees", Assert.Throws<BadInputException>(Make).Message, StringComparison.Ordinal);
        }
        else
        {
            Make();
        }
    }

    public static TheoryData<string, double> Lenses()
    {
        TheoryData<string, double> all = [];
        foreach (string name in LensCases.Names)
        {
            all.Add(name, 0.35);
            all.Add(name, 0.002);
            all.Add(name, 1.2);
        }

        return all;
    }
}
