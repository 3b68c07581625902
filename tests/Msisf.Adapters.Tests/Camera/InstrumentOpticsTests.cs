using System.Globalization;
using System.Text.RegularExpressions;
using Msisf.Adapters.Camera;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Tests.CameraExport;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Camera;

/// <summary>
/// The table of lunar cameras: each by the keywords of its own kernel, over the whole detector, against the formula that the comments of
/// the kernel print (M3, Apollo: the distortion maps of ISIS, as the kernels print none). The keywords are those of the files that are
/// named; LROC's kernel is read where it is.
/// </summary>
public sealed class InstrumentOpticsTests : IDisposable
{
    /// <summary>px.</summary>
    private const double Tolerance = 1e-6;

    private const string Tc = """
        INS-131351_FOCAL_LENGTH = ( 72.45 )
        INS-131351_PIXEL_SAMPLES = ( 4096 )
        INS-131351_PIXEL_LINES = ( 1 )
        INS-131351_CENTER = ( 2048.5, 1.0 )
        INS-131351_PIXEL_SIZE = ( 0.007 )
        INS-131351_FOV_FRAME = 'LISM_TC1_HEAD'
        INS-131351_BORESIGHT = ( -0.0725 0.0214 72.4500 )
        INS-131351_DISTORTION_COEF_X = ( -9.6499e-4, 9.8441e-4 8.5773e-6, -3.7438e-6 )
        INS-131351_DISTORTION_COEF_Y = ( -1.3796e-3, 1.3502e-5 2.7251e-6, -6.1938e-6 )
        """;

    /// <summary>kaguyaTcAddendum006.ti, which counts BORESIGHT_SAMPLE from 0.</summary>
    private const string TcAddendum = """

        INS-131351_PIXEL_PITCH = 0.007
        INS-131351_BORESIGHT_SAMPLE = 2047.5
        INS-131351_BORESIGHT_LINE = 0.0
        INS-131351_TRANSX = ( 0.0, 0.0, -0.007 )
        INS-131351_TRANSY = ( 0.0, -0.007, 0.0 )
        INS-131351_ITRANSS = ( 0.0, 0.0, -142.857142857 )
        INS-131351_ITRANSL = ( 0.0, -142.857142857, 0.0 )
        """;

    private const string MiVisible = """
        INS-131331_FOCAL_LENGTH = ( 65.4 )
        INS-131331_PIXEL_SAMPLES = ( 962 )
        INS-131331_PIXEL_LINES = ( 962 )
        INS-131331_CENTER = ( 484.0, 1.0 )
        INS-131331_PIXEL_SIZE = ( 0.013 )
        INS-131331_FOV_FRAME = 'LISM_MI_V_HEAD'
        INS-131331_BORESIGHT = ( 6.2543 -0.0201 65.4000 )
        INS-131331_DISTORTION_COEF_X = ( -1.7347e-18, 6.5562e-4, -1.7224e-4 )
        INS-131331_DISTORTION_COEF_Y = ( 2.3130e-18, -1.7082e-3, 5.0717e-5 )
        INS-131331_TRANSX = ( 0.0 , 0.0 , 0.0 )
        INS-131331_TRANSY = ( 0.0 , -0.013 , 0.0 )
        INS-131331_ITRANSS = ( 0.0 , 0.0 , -76.923076923076900 )
        INS-131331_ITRANSL = ( 0.0 , -76.923076923076900 , 0.0 )
        """;

    private const string MiInfrared = """
        INS-131344_FOCAL_LENGTH = ( 65.2 )
        INS-131344_PIXEL_SAMPLES = ( 320 )
        INS-131344_PIXEL_LINES = ( 240 )
        INS-131344_CENTER = ( 160.0, 1.0 )
        INS-131344_PIXEL_SIZE = ( 0.040 )
        INS-131344_FOV_FRAME = 'LISM_MI_N_HEAD'
        INS-131344_BORESIGHT = ( 1.4998 0.0028 65.2000 )
        INS-131344_DISTORTION_COEF_X = ( -5.0560e-3, 9.5244e-5, -1.2675e-4, -1.3607e-5 )
        INS-131344_DISTORTION_COEF_Y = ( -4.2265e-3, 7.2037e-5, 2.9845e-4, -3.4799e-5 )
        """;

    /// <summary>clem_uvvis_beta_ik_v04.ti, filter D, which is decentred most.</summary>
    private const string Uvvis = """
        INS-40024_FOCAL_LENGTH = 89.991267
        INS-40024_BORESIGHT_SAMPLE = 192.5
        INS-40024_BORESIGHT_LINE = 144.5
        INS-40024_PIXEL_SAMPLES = 384
        INS-40024_PIXEL_LINES = 288
        INS-40024_PIXEL_PITCH = 0.023
        INS-40024_PIXEL_SIZE = ( 0.023 0.023 )
        INS-40024_CCD_CENTER = ( 512.5 512.5 )
        INS-40024_FOV_FRAME = 'CLEM_UVVIS_D'
        INS-40024_BORESIGHT = ( 0.0 0.0 1.0 )
        INS-40024_TRANSX = (0.0 0.023 0.0)
        INS-40024_TRANSY = (0.0 0.0 0.023)
        INS-40024_ITRANSS = (0.0 43.47826087 0.0)
        INS-40024_ITRANSL = (0.0 0.0 43.47826087)
        INS-40024_PP = ( 0 0 )
        INS-40024_OD_K = ( 0 -2.398624e-05 0 )
        INS-40024_DECENTER = ( +1.414502e-05 -1.372645e-04 )
        """;

    /// <summary>m3Addendum005.ti, which has no detector.</summary>
    private const string M3 = """
        FRAME_-86520_NAME = 'CHANDRAYAAN-1_M3'
        INS-86520_PIXEL_PITCH = 0.027
        INS-86520_FOCAL_LENGTH = 39.63
        INS-86520_BORESIGHT_SAMPLE = 304.5
        INS-86520_BORESIGHT_LINE = 0.0
        INS-86520_TRANSX = ( -0.64, -0.0000400552916405788, 0.0269999702883839)
        INS-86520_TRANSY = ( -0.052, -0.0269999702883839, -0.0000400552916405788)
        INS-86520_ITRANSS = ( -1.96108894601637, -0.0549455303711644, -37.036996280362 )
        INS-86520_ITRANSL = ( 23.7008204518524, 37.036996280362, -0.0549455303711644 )
        INS-86520_PP = ( 0.0, 0.0 )
        INS-86520_OD_K = ( 0.000379921103637315, 0.000213226448051461, -4.01862878758592E-08 )
        INS-86520_DECENTER = ( 0.004047, -0.000005 )
        """;

    /// <summary>apollo15_metric_v2.0001.ti and apollo15MetricAddendum002.ti.</summary>
    private const string Metric = """
        INS-915240_FOCAL_LENGTH = ( 76.054 )
        INS-915240_PIXEL_PITCH = ( 0.005 )
        INS-915240_K = ( 200.00 )
        INS-915240_PIXEL_SAMPLES = ( 22900 )
        INS-915240_PIXEL_LINES = ( 22900 )
        INS-915240_CCD_CENTER = ( 11450.5, 11450.5 )
        INS-915240_TRANSX = ( 0.0, -0.005, 0.0)
        INS-915240_TRANSY = ( 0.0, 0.0, 0.005)
        INS-915240_ITRANSS = ( 0.0, -200.00, 0.0)
        INS-915240_ITRANSL = ( 0.0, 0.0, 200.00)
        INS-915240_FOV_FRAME = 'A15_METRIC'
        INS-915240_BORESIGHT = ( 0.0 0.0 +1.0 )
        INS-915240_PP = (-0.006, -0.002)
        INS-915240_OD_K = (-0.13361854e-5, 0.52261757e-9, -0.50728336e-13)
        INS-915240_DECENTER = (-0.54958195e-6, -0.46089420e-10, 2.9659070)
        """;

    private static readonly Lazy<string> LrocText = new(() => File.ReadAllText(LroNac.TextKernels[2]));

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>ITRANSS has three and four digits of 1 / 0.007.</summary>
    [RequiresTheory(Part.LroNac)]
    [InlineData(-85600, 0.0026)]
    [InlineData(-85610, 0.0008)]
    public void LrocNac_WholeLine_IsThatOfItsKernelToItsDigits(int id, double tolerance)
    {
        InstrumentKernel kernel = Lroc(id);

        AssertPixels(kernel.Camera().Model, kernel.Axes(), Line(5064), pixel => NacDirection(id, pixel.Sample), tolerance);
    }

    [RequiresTheory(Part.LroNac)]
    [InlineData(-85631)]
    [InlineData(-85632)]
    [InlineData(-85633)]
    [InlineData(-85634)]
    [InlineData(-85635)]
    public void LrocWac_WholeDetector_IsThatOfItsKernel(int id)
    {
        InstrumentKernel kernel = Lroc(id);
        CameraModel model = kernel.Camera().Model;

        Assert.Equal((1024, 1024), (model.Width, model.Height));
        AssertPixels(model, kernel.Axes(), Frame(1024, 1024), pixel => WacDirection(id, pixel));
    }

    /// <summary>
    /// The corners of the detector lie 85 degrees and more off; a band is 512 x 16 px of it, not summed here. At 321 nm the kernel's
    /// TRANSX and ITRANSS turn the image against each other, by 3.5e-5 each.
    /// </summary>
    [RequiresTheory(Part.LroNac)]
    [InlineData(-85641, 0.0185)]
    [InlineData(-85642, Tolerance)]
    public void LrocWac_UltravioletBand_IsThatOfItsKernel(int id, double tolerance)
    {
        InstrumentKernel kernel = Lroc(id);
        CameraModel model = kernel.Camera().Model;

        Assert.Equal((512, 16), (model.Width, model.Height));
        AssertPixels(model, kernel.Axes(), Frame(512, 16), pixel => WacDirection(
            id, (pixel.Sample + LrocNumbers(id, "UV_SAMPLE_OFFSET")[0], pixel.Line + LrocNumbers(id, "FILTER_OFFSET")[0])), tolerance);
    }

    /// <summary>The deprecated cameras of the kernel have another formula, which stands nowhere.</summary>
    [RequiresTheory(Part.LroNac)]
    [InlineData(-85621)]
    [InlineData(-85626)]
    public void LrocWac_Deprecated_IsRefused(int id) => Assert.Contains(
        "turns the rays of its pixels, and no formula is known in which instrument -8562",
        Assert.Throws<BadInputException>(() => Lroc(id).Camera()).Message, StringComparison.Ordinal);

    /// <summary>The kernel's formula counts from FILTER_OFFSET; a part of the kernel without it counts from who knows what.</summary>
    [Fact]
    public void LrocWac_PartOfItsKernel_IsRefused() => Assert.Contains(
        "No kernel has INS-85634_FILTER_OFFSET of WACX. Add its instrument kernel (IK) with --kernels.",
        Assert.Throws<BadInputException>(() => Kernel(
            -85634,
            """
            INS-85634_FOV_FRAME = 'WACX'
            INS-85634_BORESIGHT = ( 0 0 1 )
            INS-85634_FOCAL_LENGTH = 6.0308669
            INS-85634_PIXEL_PITCH = 0.009
            INS-85634_PIXEL_SAMPLES = 1024
            INS-85634_PIXEL_LINES = 1024
            INS-85634_BORESIGHT_SAMPLE = 509.5297
            INS-85634_BORESIGHT_LINE = 775.7545
            INS-85634_ITRANSS = ( 0 0 111.111111111111 )
            INS-85634_ITRANSL = ( 0 -111.111111111111 0 )
            INS-85634_OD_K = ( 0.0113109452166359 0.000144463288593614 4.88754251291127E-6 )
            """).Camera()).Message,
        StringComparison.Ordinal);

    [Theory]
    [InlineData(-131351, Tc, 4096)]
    [InlineData(-131351, Tc + TcAddendum, 4096)]
    [InlineData(-131331, MiVisible, 962)]
    [InlineData(-131344, MiInfrared, 320)]
    public void Kaguya_WholeLine_IsThatOfItsKernel(int id, string keywords, int samples)
    {
        InstrumentKernel kernel = Kernel(id, keywords);
        CameraModel model = kernel.Camera().Model;

        Assert.Equal((samples, 1), (model.Width, model.Height));
        AssertPixels(model, kernel.Axes(), Line(samples), pixel => KaguyaDirection(id, keywords, pixel.Sample));
    }

    [Fact]
    public void Clementine_WholeDetector_IsThatOfItsKernel()
    {
        InstrumentKernel kernel = Kernel(-40024, Uvvis);

        AssertPixels(kernel.Camera().Model, kernel.Axes(), Frame(384, 288), pixel => Corrected(
            -40024, Uvvis, 0.023 * (pixel.Sample - 192.5), 0.023 * (pixel.Line - 144.5)));
    }

    /// <summary>A principal point off the axis, which no filter has, and an image that lies across.</summary>
    [Fact]
    public void Clementine_PrincipalPointAndAxesOfAnotherCamera_IsThatOfTheFormula()
    {
        string keywords = Uvvis.Replace("PP = ( 0 0 )", "PP = ( 0.4 -0.7 )", StringComparison.Ordinal)
            .Replace("OD_K = ( 0 -2.398624e-05 0 )", "OD_K = ( 1e-3 -2e-5 3e-7 )", StringComparison.Ordinal)
            .Replace("ITRANSS = (0.0 43.47826087 0.0)", "ITRANSS = (2.5 0.0 43.47826087)", StringComparison.Ordinal)
            .Replace("ITRANSL = (0.0 0.0 43.47826087)", "ITRANSL = (-1.5 -43.47826087 0.0)", StringComparison.Ordinal)
            .Replace("_TRANS", "_OLD", StringComparison.Ordinal);
        InstrumentKernel kernel = Kernel(-40024, keywords);

        AssertPixels(kernel.Camera().Model, kernel.Axes(), Frame(384, 288), pixel => Corrected(
            -40024, keywords, -0.023 * (pixel.Line - 144.5 + 1.5), 0.023 * (pixel.Sample - 192.5 - 2.5)));
    }

    [Fact]
    public void M3_WholeLine_IsThatOfItsKernel()
    {
        InstrumentKernel kernel = Kernel(-86520, M3);
        CameraModel model = kernel.Camera().Model;

        Assert.Equal((608, 1), (model.Width, model.Height));
        AssertPixels(model, kernel.Axes(), Line(608), pixel => M3Direction(pixel.Sample));
    }

    /// <summary>The lens of USGSCSM that a camera by its kernel gets, and px that it is off; beyond 0.05 it is refused.</summary>
    [RequiresTheory(Part.LroNac)]
    [InlineData(-85600, 4, 0.0, "")]
    [InlineData(-85610, 4, 0.0, "")]
    [InlineData(-85634, 1, 226.0, "k3 (its RADIAL")] // the whole detector, most of which no band uses
    [InlineData(-85641, 7, 0.076, "k3 (its RADIAL")]
    [InlineData(-85642, 7, 0.044, "k3 (its RADIAL")]
    [InlineData(-131351, 2, 0.0, "")]
    [InlineData(-86520, 2, 0.008, "corrections about a centre")]
    [InlineData(-40024, 1, 0.001, "corrections about a centre")]
    public void Camera_OfAKernel_GoesThroughUsgscsm(int id, int type, double misfit, string missing) => CsmSensorTests.AssertLens(
        (id switch
        {
            -131351 => Kernel(id, Tc),
            -86520 => Kernel(id, M3),
            -40024 => Kernel(id, Uvvis),
            _ => Lroc(id),
        }).Camera().Model,
        type, missing, misfit);

    /// <summary>Samples against x and lines along y: the image is right if the camera looks along -z. The film is summed to fit.</summary>
    [Theory]
    [InlineData("-x,+y", 1.0)]
    [InlineData("+x,-y", -1.0)]
    public void Apollo_WholeFilm_IsThatOfItsKernel(string axes, double sign)
    {
        InstrumentKernel kernel = Kernel(-915240, Metric);
        CameraModel model = kernel.Camera(InstrumentAxes.Parse(axes)).Model;

        Assert.Equal((11450, 11450), (model.Width, model.Height));
        Assert.Contains(
            "mirrored as seen along +z. Say how the image lies with --instrument-axes",
            Assert.Throws<BadInputException>(() => kernel.Camera()).Message, StringComparison.Ordinal);
        double[] k = Numbers(-915240, Metric, "OD_K");
        double[] pp = Numbers(-915240, Metric, "PP");
        double[] decenter = Numbers(-915240, Metric, "DECENTER");
        AssertPixels(model, InstrumentAxes.Parse(axes), Frame(11450, 11450), pixel =>
        {
            // 2 x 2 pixels of the film are one.
            (double sample, double line) = ((2.0 * pixel.Sample) - 0.5, (2.0 * pixel.Line) - 0.5);
            double x = (-0.005 * (sample - 11450.5)) - pp[0];
            double y = (0.005 * (line - 11450.5)) - pp[1];
            double rr = (x * x) + (y * y);
            double dr = 1.0 + (k[0] * rr) + (k[1] * rr * rr) + (k[2] * rr * rr * rr);
            double dt = (decenter[0] * rr) + (decenter[1] * rr * rr);
            return new Vector3D(
                sign * ((dr * x) - (dt * Math.Sin(decenter[2]))), sign * ((dr * y) + (dt * Math.Cos(decenter[2]))), -76.054);
        });
    }

    /// <summary>A preset and the kernel of its camera have the same rays, or differ by what docs/cameras.md says.</summary>
    [RequiresTheory(Part.LroNac)]
    [InlineData("lroc-nac-l", -85600, Tolerance)]
    [InlineData("lroc-nac-r", -85610, Tolerance)]
    [InlineData("lroc-wac-415", -85631, Tolerance)]
    [InlineData("lroc-wac-566", -85632, Tolerance)]
    [InlineData("lroc-wac-604", -85633, Tolerance)]
    [InlineData("lroc-wac-643", -85634, Tolerance)]
    [InlineData("lroc-wac-689", -85635, Tolerance)]
    [InlineData("kaguya-tc1", -131351, Tolerance)]
    [InlineData("chandrayaan-m3", -86520, 0.009)]
    [InlineData("clementine-uvvis", -40021, 0.3)]
    public void Preset_WholeDetector_IsThatOfTheKernel(string preset, int id, double tolerance)
    {
        CameraModel model = CameraFileReader.Read(Path.Combine(TestParts.RepositoryRoot, "cameras", preset + ".yaml"), preset).Model;
        string clementine = Uvvis.Replace("-40024", "-40021", StringComparison.Ordinal)
            .Replace("89.991267", "89.874444", StringComparison.Ordinal).Replace("-2.398624e-05", "-2.422842e-05", StringComparison.Ordinal)
            .Replace("+1.414502e-05 -1.372645e-04", "+2.255006e-05 +2.108941e-05", StringComparison.Ordinal);
        InstrumentAxes axes = InstrumentAxes.Parse(id is -40021 ? "+x,+y" : "-y,+x");
        (Func<(double Sample, double Line), Vector3D> direction, InstrumentAxes used) = id switch
        {
            -85600 or -85610 => (pixel => NacDirection(id, pixel.Sample), Lroc(id).Axes()),
            -131351 => (pixel => KaguyaDirection(id, Tc, pixel.Sample), axes),
            -86520 => (pixel => M3Direction(pixel.Sample), axes),
            -40021 => (pixel => Corrected(id, clementine, 0.023 * (pixel.Sample - 192.5), 0.023 * (pixel.Line - 144.5)), axes),
            _ => ((Func<(double Sample, double Line), Vector3D>)(pixel => WacDirection(
                id, (pixel.Sample + 160.0, pixel.Line + LrocNumbers(id, "FILTER_OFFSET")[0]))), Lroc(id).Axes()),
        };

        double worst = AssertPixels(
            model, used, model.Height == 1 ? Line(model.Width) : Frame(model.Width, model.Height), direction, tolerance);

        // A difference that is gone is not to be documented any more.
        Assert.True(tolerance == Tolerance || worst > 0.5 * tolerance, FormattableString.Invariant($"{worst}"));
    }

    [Theory]
    [InlineData("( -0.0725 0.0214 72.4500 )", "( -0.0725 0.0214 )", "INS-131351_BORESIGHT has 2 numbers, 3 expected")]
    [InlineData("( -9.6499e-4, 9.8441e-4 8.5773e-6, -3.7438e-6 )", "( 1 2 )", "DISTORTION_COEF_X of LISM_TC1_HEAD has 2 numbers; 3 (MI")]
    [InlineData("INS-131351_DISTORTION_COEF_Y", "INS-131351_OTHER", "No kernel has INS-131351_DISTORTION_COEF_Y of LISM_TC1_HEAD")]
    [InlineData("( 2048.5, 1.0 )", "( 2048.5, 7.0 )", "CENTER of LISM_TC1_HEAD puts the axis into line 7 of an image of one line")]
    [InlineData(
        "( 2048.5, 1.0 )",
        "( 2048.5, 1.0 )\nINS-131351_ITRANSS = ( 0 -142.857142857 0 )\nINS-131351_ITRANSL = ( 0 0 142.857142857 )",
        "ITRANSS of LISM_TC1_HEAD is not along y")]
    [InlineData("( 2048.5, 1.0 )", "( 2048.5, 1.0 )\nINS-131351_OD_K = 1", "OD_K of LISM_TC1_HEAD turns the rays of its pixels")]
    [InlineData("PIXEL_SIZE = ( 0.007 )", "PIXEL_SIZE = ( 0.0007 )", "PIXEL_SIZE of LISM_TC1_HEAD is 0.0007; in mm it lies between")]
    public void Kaguya_KeywordWrong_IsNamed(string right, string wrong, string expected) => Assert.Contains(
        expected,
        Assert.Throws<BadInputException>(
            () => Kernel(-131351, Tc.Replace(right, wrong, StringComparison.Ordinal)).Camera()).Message,
        StringComparison.Ordinal);

    /// <summary>The comment of the kernel: xd = (sample - BORESIGHT_SAMPLE) PIXEL_PITCH, xc = xd / (1 + k1 r2).</summary>
    private static Vector3D NacDirection(int id, double sample)
    {
        (double origin, double focal, double k) = id == -85600 ? (2548.0, 699.62, 1.81e-5) : (2496.0, 701.57, 1.83e-5);
        double y = (id == -85600 ? 7.0e-3 : -7.0e-3) * (sample - origin);
        return new Vector3D(0.0, y / (1.0 + (k * y * y)), focal);
    }

    /// <summary>The comment of the kernel, offsets 0: xd = (sample - BORESIGHT_SAMPLE - 1) PIXEL_PITCH, by TRANSX and TRANSY.</summary>
    private static Vector3D WacDirection(int id, (double Sample, double Line) pixel)
    {
        double sample = pixel.Sample - LrocNumbers(id, "BORESIGHT_SAMPLE")[0] - 1.0;
        double line = pixel.Line - LrocNumbers(id, "BORESIGHT_LINE")[0] - 1.0;
        (double[] transX, double[] transY, double[] k) = (LrocNumbers(id, "TRANSX"), LrocNumbers(id, "TRANSY"), LrocNumbers(id, "OD_K"));
        double x = transX[0] + (transX[1] * sample) + (transX[2] * line);
        double y = transY[0] + (transY[1] * sample) + (transY[2] * line);
        double r2 = (x * x) + (y * y);
        double factor = 1.0 + (k[0] * r2) + (k[1] * r2 * r2) + (k[2] * r2 * r2 * r2);
        return new Vector3D(x * factor, y * factor, LrocNumbers(id, "FOCAL_LENGTH")[0]);
    }

    private static Vector3D KaguyaDirection(int id, string keywords, double sample)
    {
        double r = -(sample - Numbers(id, keywords, "CENTER")[0]) * Numbers(id, keywords, "PIXEL_SIZE")[0];
        double Sum(string item) => Numbers(id, keywords, item).Select((a, i) => a * Math.Pow(r, i)).Sum();
        double[] boresight = Numbers(id, keywords, "BORESIGHT");
        return new Vector3D(boresight[0] + Sum("DISTORTION_COEF_X"), boresight[1] + r + Sum("DISTORTION_COEF_Y"), boresight[2]);
    }

    private static Vector3D M3Direction(double sample)
    {
        (double[] transX, double[] transY) = (Numbers(-86520, M3, "TRANSX"), Numbers(-86520, M3, "TRANSY"));
        return Corrected(-86520, M3, transX[0] + (transX[1] * (sample - 304.5)), transY[0] + (transY[1] * (sample - 304.5)));
    }

    /// <summary>The steps that the comment of Clementine's kernel prints.</summary>
    private static Vector3D Corrected(int id, string keywords, double xd, double yd)
    {
        double[] pp = Numbers(id, keywords, "PP");
        double[] k = Numbers(id, keywords, "OD_K");
        double[] p = Numbers(id, keywords, "DECENTER");
        (double x, double y) = (xd - pp[0], yd - pp[1]);
        double rr = (x * x) + (y * y);
        double dr = k[0] + (k[1] * rr) + (k[2] * rr * rr);
        double tx = (p[0] * (rr + (2.0 * x * x))) + (2.0 * p[1] * x * y);
        double ty = (2.0 * p[0] * x * y) + (p[1] * (rr + (2.0 * y * y)));
        return new Vector3D(xd + (x * dr) + tx, yd + (y * dr) + ty, Numbers(id, keywords, "FOCAL_LENGTH")[0]);
    }

    private static IEnumerable<(double Sample, double Line)> Line(int samples) =>
        Enumerable.Range(0, 65).Select(i => (1.0 + ((samples - 1.0) * i / 64.0), 1.0));

    private static IEnumerable<(double Sample, double Line)> Frame(int samples, int lines) =>
        from i in Enumerable.Range(0, 17)
        from j in Enumerable.Range(0, 13)
        select (1.0 + ((samples - 1.0) * i / 16.0), 1.0 + ((lines - 1.0) * j / 12.0));

    /// <summary>The greatest distance of a pixel from where the camera sees its direction.</summary>
    private static double AssertPixels(
        CameraModel model, InstrumentAxes axes, IEnumerable<(double Sample, double Line)> pixels,
        Func<(double Sample, double Line), Vector3D> direction, double tolerance = Tolerance)
    {
        FrameCamera camera = model.At(new CameraState(default, UnitQuaternion.Identity));
        UnitQuaternion cameraFromFrame = axes.InstrumentFromCamera.Conjugate;
        double worst = 0.0;
        foreach ((double Sample, double Line) pixel in pixels)
        {
            Assert.True(camera.TryProjectPoint(cameraFromFrame * direction(pixel), out RenderingPoint seen), pixel.ToString());
            double error = double.Hypot(seen.X - pixel.Sample, seen.Y - pixel.Line);
            Assert.True(error <= tolerance, FormattableString.Invariant($"{pixel} is seen at {seen}, {error} px off"));
            worst = Math.Max(worst, error);
        }

        return worst;
    }

    private static InstrumentKernel Lroc(int id) => new(KernelPool.Of(LroNac.TextKernels), id.ToString(CultureInfo.InvariantCulture));

    private static double[] LrocNumbers(int id, string item) => Numbers(id, LrocText.Value, item);

    /// <summary>The numbers of an assignment, read without the program's reader.</summary>
    private static double[] Numbers(int id, string keywords, string item)
    {
        Match match = Regex.Match(keywords, $@"INS{id}_{item}\s*=\s*(?:\(([^)]*)\)|(\S+))");
        Assert.True(match.Success, item);
        return
        [
            .. (match.Groups[1].Value + match.Groups[2].Value).Split([' ', ',', '\n', '\r', '\t'], StringSplitOptions.RemoveEmptyEntries)
                .Select(number => double.Parse(number, CultureInfo.InvariantCulture)),
        ];
    }

    private InstrumentKernel Kernel(int id, string data)
    {
        string path = _folder.Write("camera.ti", $"KPL/IK\n\\begindata\n{data}\n\\begintext\n");
        return new InstrumentKernel(KernelPool.Of([path]), id.ToString(CultureInfo.InvariantCulture));
    }
}
