using Msisf.Adapters.Camera;
using Msisf.Adapters.Ephemeris;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Camera;

/// <summary>
/// Cameras by the keywords of instrument kernels that no row of the table of lenses names. What is expected is ISIS's way from a direction
/// to a pixel, by hand: mm in the focal plane, ITRANSS and ITRANSL.
/// </summary>
public sealed class InstrumentKernelTests : IDisposable
{
    private const string Frame =
        "INS-77_FOV_FRAME = 'EYE'\nINS-77_FOCAL_LENGTH = 50.0\nINS-77_PIXEL_SAMPLES = 400\nINS-77_PIXEL_LINES = 300\n"
            + "INS-77_PIXEL_PITCH = 0.02\nINS-77_CCD_CENTER = ( 200.5 150.5 )\nINS-77_BORESIGHT = ( 0 0 1 )\n";

    private const string OfField =
        "INS-77_FOV_FRAME = 'EYE'\nINS-77_PIXEL_SAMPLES = 400\nINS-77_PIXEL_LINES = 300\nINS-77_BORESIGHT = ( 1 0 0 )\n";

    private const string Transform = "INS-77_ITRANSS = ( 3.0 0.0 50.0 )\nINS-77_ITRANSL = ( -2.0 -50.0 0.0 )\n";

    /// <summary>Of a camera that looks along +x.</summary>
    private static readonly InstrumentAxes Right = InstrumentAxes.Parse("+y,+z");

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>Samples along +y, lines along -x; skewed samples; the constants of ITRANSS and ITRANSL, whatever names the axis.</summary>
    [Theory]
    [InlineData("", 0.0)]
    [InlineData("INS-77_ITRANSS = ( 3.0 4.0 50.0 )\n", 4.0)]
    [InlineData("INS-77_BORESIGHT_SAMPLE = 200.5\nINS-77_BORESIGHT_LINE = 150.5\nINS-77_CCD_CENTER = ( 9 9 )\n", 0.0)]
    [InlineData("INS-77_TRANSX = ( -0.04 0.0 -0.02 )\nINS-77_TRANSY = ( -0.06 0.02 0.0 )\n", 0.0)]
    [InlineData("INS-77_OD_K = ( 0 0 0 )\nINS-77_PP = ( 0 0 )\nINS-77_CONSTANT_TIME_OFFSET = 3\n", 0.0)]
    public void Camera_OfIsissKeywords_HasIsissPixels(string more, double skew)
    {
        InstrumentKernel kernel = Kernel(Frame + Transform + more);
        CameraModel model = kernel.Camera().Model;
        UnitQuaternion frameFromImage = kernel.Axes().InstrumentFromCamera;

        foreach ((double x, double y) in ((double, double)[])[(0.0, 0.0), (1.1, -0.7), (-2.3, 3.1)])
        {
            double sample = 200.5 + 3.0 + (skew * x) + (50.0 * y);
            double line = 150.5 - 2.0 - (50.0 * x);

            Vector3D inCamera = frameFromImage.Conjugate * new Vector3D(x, y, 50.0);
            Assert.True(model.At(new CameraState(default, UnitQuaternion.Identity)).TryProjectPoint(inCamera, out RenderingPoint seen));
            Assert.Equal(sample, seen.X, 1e-6);
            Assert.Equal(line, seen.Y, 1e-6);
        }
    }

    /// <summary>What turns rays in a way that no row of the table knows is named, and what to do.</summary>
    [Theory]
    [InlineData("OD_K = ( 0.001 2E-4 1E-6 )")]
    [InlineData("OD_K = 1E-5")]
    [InlineData("OD_CENTER = ( 1 2 )")]
    [InlineData("DISTORTION_COEF_X = ( 0 1E-4 )")]
    [InlineData("DISTORTION_C3 = 1")]
    [InlineData("DECENTER = ( 1E-5 0 )")]
    [InlineData("PP = ( 0 0.1 )")]
    [InlineData("KAPPA = 0.3")]
    [InlineData("K1 = 1E-4")]
    [InlineData("P2 = 1E-4")]
    [InlineData("ALPHA0 = 1E-4")]
    [InlineData("ADD_OFFSET = ( 3 4 )")]
    [InlineData("FILTER_OFFSET = 30")]
    [InlineData("POINT_OF_SYMMETRY = ( 4.6 -4.6 )")]
    [InlineData("PERSPECTIVE_FACTORS = ( 1E-6 1E-6 )")]
    [InlineData("EULER_ANGLES = ( 0 0.1 0 )")]
    [InlineData("BORESIGHT = ( 0.01 0 1 )")]
    [InlineData("TRANSX = ( 0.0 0.0 -0.021 )\nINS-77_TRANSY = ( 0.0 0.02 0.0 )")]
    [InlineData("TRANSX = ( 0.1 0.0 -0.02 )\nINS-77_TRANSY = ( 0.0 0.02 0.0 )")]
    [InlineData("PIXEL_PITCH = 0.00002")]
    [InlineData("PIXEL_PITCH = 0.002")]
    [InlineData("PIXEL_PITCH = 20")]
    public void Camera_KeywordThatTurnsRays_IsNamed(string keyword)
    {
        string data = Frame + Transform + $"INS-77_{keyword}\n";

        BadInputException error = Assert.Throws<BadInputException>(() => Kernel(data).Camera());

        Assert.Matches(@"eye\.ti, line \d+: ", error.Message);
        Assert.Contains($" {keyword[..keyword.IndexOf(' ', StringComparison.Ordinal)]} of EYE ", error.Message, StringComparison.Ordinal);
        Assert.EndsWith("Give the camera with --camera FILE instead.", error.Message, StringComparison.Ordinal);
    }

    /// <summary>NAIF's kernels without ISIS's additions: the pitch, and the axes that the user gives.</summary>
    [Fact]
    public void Camera_WithAxes_NeedsNoTransform()
    {
        CameraModel model = Kernel(Frame.Replace("( 0 0 1 )", "( 1 0 0 )", StringComparison.Ordinal)).Camera(Right).Model;

        Assert.Equal((400, 300), (model.Width, model.Height));
        Assert.Equal(50.0 / 0.02, model.FocalX, Rounding.OfPlaces);
        Assert.Equal(50.0 / 0.02, model.FocalY, Rounding.OfPlaces);
        Assert.Equal((200.5, 150.5), (model.PrincipalX, model.PrincipalY));
    }

    /// <summary>
    /// A field of view without a focal length, as NAIF's GETFOV reads it: half angles along a reference vector and across, or corners. The
    /// tangents of 10 and 5 degrees are half the image's sides.
    /// </summary>
    [Theory]
    [InlineData(
        "FOV_SHAPE = 'RECTANGLE'\nFOV_CLASS_SPEC = 'ANGLES'\nFOV_REF_VECTOR = ( 0.3 1 0 )\nFOV_REF_ANGLE = 10\n"
            + "FOV_CROSS_ANGLE = 5\nFOV_ANGLE_UNITS = 'DEGREES'\n", 200.5, 150.5)]
    [InlineData(
        "FOV_SHAPE = 'POLYGON'\nFOV_BOUNDARY_CORNERS = ( 2 0.35265396141693 0.17497732705184\n2 0.35265396141693 -0.17497732705184\n"
            + "2 -0.35265396141693 -0.17497732705184 2 -0.35265396141693 0.17497732705184 )\n", 200.5, 150.5)]
    [InlineData(
        "FOV_SHAPE = 'RECTANGLE'\nFOV_BOUNDARY_CORNERS = ( 1 0.35265396141693 0.17497732705184 1 0.35265396141693 0\n"
            + "1 0 0 1 0 0.17497732705184 )\n", 0.5, 0.5)]
    public void Camera_FieldOfViewAlone_FillsTheImage(string field, double centerX, double centerY)
    {
        CameraModel model = WithField(field).Camera(Right).Model;

        Assert.Equal(200.0 / 0.17632698070846, model.FocalX, 1e-6); // px: the tangents have 14 digits
        Assert.Equal(150.0 / 0.08748866352592, model.FocalY, 1e-6); // px: the same
        Assert.Equal(centerX, model.PrincipalX, Rounding.OfPlaces);
        Assert.Equal(centerY, model.PrincipalY, Rounding.OfPlaces);
    }

    [Theory]
    [InlineData("FOV_SHAPE = 'CIRCLE'\nFOV_CLASS_SPEC = 'ANGLES'\n", "line 7: the field of view is no rectangle, and there is no")]
    [InlineData("FOV_SHAPE = 'POLYGON'\nFOV_BOUNDARY = ( 1 1 0 1 0 1 1 -1 0 1 0 -1 )\n", "is not a rectangle along the image's axes")]
    [InlineData("FOV_SHAPE = 'POLYGON'\nFOV_BOUNDARY = ( -1 1 1 -1 1 -1 -1 -1 -1 -1 -1 1 )\n", "lies behind the camera")]
    [InlineData("FOV_SHAPE = 'RECTANGLE'\n", "FOV_BOUNDARY")]
    [InlineData(
        "FOV_SHAPE = 'RECTANGLE'\nFOV_CLASS_SPEC = 'ANGLES'\nFOV_ANGLE_UNITS = 'GON'\n", "has angles in 'GON'; RADIANS")]
    public void Camera_FieldOfViewWrong_IsNamed(string field, string expected) => Assert.Contains(
        expected, Assert.Throws<BadInputException>(() => WithField(field).Camera(Right)).Message, StringComparison.Ordinal);

    [Theory]
    [InlineData("INS-77_ITRANSS = ( 3.0 0.0 50.0 )\n", "", false, "No kernel has INS-77_ITRANSS of EYE, which says how its image lies")]
    [InlineData("INS-77_FOCAL_LENGTH = 50.0\n", "", false, "No kernel has INS-77_FOCAL_LENGTH of EYE. Add its instrument kernel (IK)")]
    [InlineData("INS-77_CCD_CENTER = ( 200.5 150.5 )\n", "", false, "No kernel has INS-77_CCD_CENTER of EYE")]
    [InlineData("PITCH = 0.02", "PITCH = -0.02", false, "PIXEL_PITCH of EYE is not above 0")]
    [InlineData("INS-77_ITRANSL = ( -2.0 -50.0 0.0 )\n", "", false, "ITRANSS of EYE has no ITRANSL beside it")]
    [InlineData("( -2.0 -50.0 0.0 )", "( -2.0 0.0 50.0 )", false, "ITRANSS of EYE is along ITRANSL")]
    [InlineData("( 0 0 1 )", "( 0 1 0 )", true, "BORESIGHT of EYE is (0, 1, 0), off the axis of its image")]
    [InlineData("( 0 0 1 )", "( 0 1 0 )", false, "the boresight of EYE is (0, 1, 0), not near +z")]
    [InlineData("( -2.0 -50.0 0.0 )", "( 2.0 50.0 0.0 )", false, "describe an image that is mirrored as seen along +z. Say how the image")]
    [InlineData("( -2.0 -50.0 0.0 )", "( 2.0 0.0 0.0 )", false, "ITRANSL of EYE has no direction")]
    [InlineData("( -2.0 -50.0 0.0 )", "( 2.0 0.0 )", false, "INS-77_ITRANSL has 2 numbers, 3 expected")]
    [InlineData("PIXEL_LINES = 300\n", "PIXEL_LINES = 300.5\n", false, "INS-77_PIXEL_LINES is 300.5, a whole number expected")]
    [InlineData("INS-77_FOV_FRAME = 'EYE'\n", "", false, "No kernel says which frame instrument -77 has (INS-77_FOV_FRAME")]
    public void Camera_KeywordMissingOrWrong_IsNamed(string right, string wrong, bool hasAxes, string expected) => Assert.Contains(
        expected,
        Assert.Throws<BadInputException>(
            () => Kernel((Frame + Transform).Replace(right, wrong, StringComparison.Ordinal)).Camera(hasAxes ? Right : null)).Message,
        StringComparison.Ordinal);

    [Fact]
    public void Camera_WithAxesAndNothingElse_NeedsThePitch() => Assert.Contains(
        "No kernel has INS-77_PIXEL_PITCH of EYE",
        Assert.Throws<BadInputException>(() => Kernel(
            Frame.Replace("INS-77_PIXEL_PITCH = 0.02\n", "", StringComparison.Ordinal).Replace("( 0 0 1 )", "( 1 0 0 )")).Camera(Right))
            .Message,
        StringComparison.Ordinal);

    private InstrumentKernel WithField(string field) =>
        Kernel(OfField + field.Replace("FOV_", "INS-77_FOV_", StringComparison.Ordinal));

    private InstrumentKernel Kernel(string data)
    {
        string path = _folder.Write("eye.ti", $"KPL/IK\n\\begindata\n{data}\n\\begintext\n");
        return new InstrumentKernel(KernelPool.Of([path]), "-77");
    }
}
