using System.Text;
using Msisf.Adapters.Camera;
using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Camera;

public sealed class CameraFileReaderTests
{
    private const string Plain = "width: 640\nheight: 480\nfocal-length: 10\npixel-pitch: 0.01\n";

    [Fact]
    public void Parse_WholeFile_GivesTheCamera()
    {
        CameraFile file = Read(
            "description: a camera\nwidth: 640\nheight: 480\nfocal-length: 10\npixel-pitch: [0.01, 0.02]\nprincipal-point: [319, 240.5]\n"
                + "pixel-convention: opencv\nskew: 1.5\ndistortion:\n  model: opencv\n  k1: -0.1\n  s4: 0.001\n");

        Assert.Equal("a camera", file.Description);
        Assert.Equal(0.01, file.FocalLength!.Value, 1e-18); // m: half an ulp of mm turned into m
        Assert.Equal((1e-5, 2e-5), file.PixelPitch);
        Assert.Equal((640, 480), (file.Model.Width, file.Model.Height));
        Assert.Equal(1000.0, file.Model.FocalX, Rounding.OfSolutions);
        Assert.Equal(500.0, file.Model.FocalY, Rounding.OfSolutions);
        Assert.Equal((320.0, 241.5), (file.Model.PrincipalX, file.Model.PrincipalY)); // ours count from 1
        Assert.Equal(1.5, file.Model.Skew);
        Assert.Equal(
            [-0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.001],
            Assert.IsType<OpenCvDistortion>(file.Model.Distortion).Coefficients);
    }

    [Theory]
    [InlineData("msis", 1.0)]
    [InlineData("isis", 1.0)]
    [InlineData("matlab", 1.0)]
    [InlineData("opencv", 0.0)]
    [InlineData("colmap", 0.5)]
    public void Parse_PixelConvention_PutsTheFirstPixelsMiddleThere(string convention, double first)
    {
        CameraModel model = Read(FormattableString.Invariant(
            $"{Plain}pixel-convention: {convention}\nprincipal-point: [{first}, {first}]\n")).Model;

        Assert.Equal((1.0, 1.0), (model.PrincipalX, model.PrincipalY));
    }

    /// <summary>
    /// The same camera by its focal length in mm, in px and by its field of view; all are the thesis's, without distortion.
    /// </summary>
    [Theory]
    [InlineData("focal-length: 8\npixel-pitch: 0.01")]
    [InlineData("focal-length-px: 800")]
    [InlineData("focal-length-px: [800, 800]")]
    [InlineData("field-of-view: 43.60281897270362")]
    [InlineData("focal-length-px: 800\nprincipal-point: [320.5, 240.5]")]
    [InlineData("focal-length-px: 800\ndistortion:\n  model: none")]
    [InlineData("focal-length-px: 800\ndistortion:\n  model: opencv\n  k1: 0\n  k4: 0")]
    public void Parse_FormsOfThePinhole_AreTheSame(string lines)
    {
        CameraModel model = Read($"width: 640\nheight: 480\n{lines}\n").Model;

        Assert.Null(model.Distortion);
        Assert.Equal(2.0 * Math.Atan(0.4), model.FieldOfView, 1e-11);
        Assert.Equal(model.FocalX, model.FocalY);
    }

    [Fact]
    public void Parse_FieldOfView_IsTheNumberOfTheFile() =>
        Assert.Equal(40.0, Read("width: 64\nheight: 48\nfield-of-view: 40\n").FieldOfViewDegrees);

    /// <summary>LROC WAC, 643 nm: xc = xd (1 + k1 r2 + k2 r4 + k3 r6) of its kernel, counted by hand at sample 1, line 1.</summary>
    [Fact]
    public void Read_PresetOfWac_FollowsItsKernel()
    {
        CameraModel model = CameraFileReader.Read(Path.Combine(TestParts.RepositoryRoot, "cameras", "lroc-wac-643.yaml")).Model;
        double x = (1 + 160 - 509.5297 - 1) * 0.009;
        double y = (1 + 781 - 775.7545 - 1) * 0.009;
        double square = (x * x) + (y * y);
        double factor = 1.0 + (0.0113109452166359 * square) + (0.000144463288593614 * square * square)
            + (4.88754251291127e-6 * square * square * square);

        (double right, double down) = model.ToIdeal(1.0, 1.0);

        Assert.Equal(x * factor / 6.0308669, right, Rounding.OfTurns);
        Assert.Equal(y * factor / 6.0308669, down, Rounding.OfTurns);
    }

    [Fact]
    public void Read_Presets_AreRight()
    {
        string[] files = Directory.GetFiles(Path.Combine(TestParts.RepositoryRoot, "cameras"), "*.yaml");
        Assert.True(files.Length >= 10);
        Assert.All(files, file => Assert.NotNull(CameraFileReader.Read(file).Description));
    }

    [Theory]
    [InlineData("", 1, "a camera needs 'width'")]
    [InlineData("width: 640\n", 1, "a camera needs 'height'")]
    [InlineData("width: 640\nheight: 480\n", 1, "a camera needs 'focal-length'")]
    [InlineData("width: 640\nheight: 480\nfocal-length: 10\n", 1, "a camera needs 'pixel-pitch'")]
    [InlineData("width: 640\nheight: 480\npixel-pitch: 0.01\n", 1, "a camera needs 'focal-length'")]
    [InlineData("width: 640\nheight: 480\nfocal-length-px: 9\npixel-pitch: 0.01\n", 4, "no meaning without 'focal-length'")]
    [InlineData("width: 640\nheight: 480\nfocal-length-px: 9\nfield-of-view: 40\n", 4, "exclude each other")]
    [InlineData("widht: 640\nheight: 480\n", 1, "'widht' is not a key of a camera: did you mean width?")]
    [InlineData("width: 640\nheight: 480\nfocal-lenght: 10\n", 3, "did you mean focal-length?")]
    [InlineData("width: 640\nheight: 480\nfocallength-px: 10\n", 3, "did you mean focal-length-px?")]
    [InlineData(Plain + "principle-point: [1, 1]\n", 5, "did you mean principal-point?")]
    [InlineData(Plain + "distorsion:\n  model: none\n", 5, "did you mean distortion?")]
    [InlineData("width: 0\nheight: 480\n", 1, "'width' is 0; a whole number from 1 to 16384 is needed")]
    [InlineData("width: -640\nheight: 480\n", 1, "'width' is -640; a whole number")]
    [InlineData("width: 640.5\nheight: 480\n", 1, "'width' is 640.5; a whole number")]
    [InlineData("width: 20000\nheight: 480\n", 1, "'width' is 20000; a whole number")]
    [InlineData("width: [640, 480]\nheight: 480\n", 1, "'width' takes one value, not a list")]
    [InlineData("width: wide\nheight: 480\n", 1, "'wide' is not a number")]
    [InlineData("width: 640\nheight:\n", 2, "'height' has no value")]
    [InlineData("width: 640\nwidth: 640\n", 2, "'width' is there already, in line 1")]
    [InlineData(
        "width: 640\nheight: 480\nfocal-length: 0.05\npixel-pitch: 0.00001\n", 3,
        "'focal-length' is 0.05 mm; it is in millimetres (mm), from 0.1 on. Metres are to be multiplied by 1000.")]
    [InlineData("width: 640\nheight: 480\nfocal-length: -10\npixel-pitch: 0.01\n", 3, "'focal-length' is -10; a number above 0")]
    [InlineData("width: 640\nheight: 480\nfocal-length: 0\npixel-pitch: 0.01\n", 3, "'focal-length' is 0; a number above 0")]
    [InlineData("width: 640\nheight: 480\nfocal-length: 1,5\npixel-pitch: 0.01\n", 3, "has a comma")]
    [InlineData("width: 640\nheight: 480\nfocal-length: nan\npixel-pitch: 0.01\n", 3, "is not finite")]
    [InlineData("width: 640\nheight: 480\nfocal-length: 10\npixel-pitch: -0.01\n", 4, "'pixel-pitch' is not above 0")]
    [InlineData(
        "width: 640\nheight: 480\nfocal-length: 10\npixel-pitch: [0.01, 0.01, 0.01]\n", 4,
        "'pixel-pitch' has 3 numbers; 1 to 2 are needed")]
    [InlineData("width: 640\nheight: 480\nfocal-length-px: [800, 0]\n", 3, "'focal-length-px' is not above 0")]
    [InlineData("width: 640\nheight: 480\nfield-of-view: 170\n", 3, "'field-of-view' is 170; degrees above 0 and below 170")]
    [InlineData("width: 640\nheight: 480\nfield-of-view: -3\n", 3, "'field-of-view' is -3")]
    [InlineData("width: 640\nheight: 480\nfocal-length-px: 20\n", 3, "the field of view must stay below 170 degrees")]
    [InlineData(Plain + "principal-point: 320\n", 5, "'principal-point' has 1 number; 2 are needed")]
    [InlineData(Plain + "principal-point: [320, x]\n", 5, "'x' is not a number")]
    [InlineData(Plain + "pixel-convention: opncv\n", 5, "one of msis, opencv, colmap, isis, matlab is needed: did you mean opencv?")]
    [InlineData(Plain + "skew: [0]\n", 5, "'skew' takes one value")]
    [InlineData(Plain + "distortion: opencv\n", 5, "'distortion' is a section")]
    [InlineData(Plain + "distortion:\n  k1: 0.1\n", 5, "a distortion needs 'model'")]
    [InlineData(Plain + "distortion:\n  model: openvc\n  k1: 0.1\n", 6, "did you mean opencv?")]
    [InlineData(Plain + "distortion:\n  model: opencv\n", 5, "needs 'k1': at least one coefficient")]
    [InlineData(
        Plain + "distortion:\n  model: brown-conrady\n  k1: 0.1\n  k4: 0.1\n", 8,
        "'k4' is not a key of the distortion model 'brown-conrady'")]
    [InlineData(Plain + "distortion:\n  model: opencv\n  k1: [0.1]\n", 7, "'k1' takes one value")]
    [InlineData(Plain + "distortion:\n  model: opencv\n  k1:\n    value: 1\n", 8, "'k1' takes a value, or a list of values")]
    [InlineData(Plain + "distortion:\n  model: radial\n", 5, "needs 'k'")]
    [InlineData(Plain + "distortion:\n  model: radial\n  k: [1, 2, 3, 4]\n", 7, "'k' has 4 numbers; 1 to 3 are needed")]
    [InlineData(Plain + "distortion:\n  model: radial\n  k: [0.1]\n  form: divison\n", 8, "did you mean division?")]
    [InlineData(
        "width: 64\nheight: 48\nfocal-length-px: 99\ndistortion:\n  model: owen\n  e2: 0.1\n", 5,
        "is in mm and needs 'focal-length'")]
    [InlineData(Plain + "distortion:\n  model: opencv\n  k1: -9\n", 5, "do not invert inside the image")]
    [InlineData(Plain + "distortion:\n  model: fisheye\n  k1: -9\n", 5, "do not invert inside the image")]
    [InlineData(Plain + "distortion:\n  model: radial\n  k: [-0.1]\n", 5, "do not invert inside the image")]
    [InlineData(Plain + "distortion:\n  model: opencv\n  k1: &a 1\n", 7, "anchors and tags are not read here")]
    [InlineData("width: 640\n height: 480\n", 2, "this is not YAML")]
    [InlineData("- width\n", 1, "a line 'key: value' is needed")]
    public void Parse_WrongFile_IsOneLineThatNamesThePlace(string text, int line, string what)
    {
        string message = Assert.Throws<BadInputException>(() => Read(text)).Message;

        Assert.StartsWith($"a.yaml, line {line}, column ", message, StringComparison.Ordinal);
        Assert.Contains(what, message, StringComparison.Ordinal);
        Assert.DoesNotContain('\n', message);
    }

    [Fact]
    public void Read_NoSuchFile_IsRefused() => Assert.Throws<BadInputException>(() => CameraFileReader.Read("/nowhere/a.yaml"));

    private static CameraFile Read(string text) => CameraFileReader.Parse(Encoding.UTF8.GetBytes(text), "a.yaml");
}
