using System.Globalization;
using System.Text.Json;
using System.Xml.Linq;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>The program as a user runs it: real elevation model, real kernels, real POV-Ray.</summary>
public sealed class RenderRunTests : IDisposable
{
    /// <summary>Degrees: the pixel of section 9.2 is printed with 16 digits.</summary>
    private const double CoordinateTolerance = 1e-12;

    /// <summary>Degrees: where the references of 50 digits end up when the frame's own rounding is in them.</summary>
    private const double DirectionTolerance = 1e-9;

    private const string Section92 =
        "{55289,2E6,2E6,0,-2.391176183943345e-001,+9.904576054128762e-002,+3.696438106143861e-001,+8.923991008325228e-001}";

    /// <summary>A small lit view, quickly rendered.</summary>
    private static readonly string[] SmallView = ["--fixed-state", Section92, "--width", "64", "--height", "48"];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Run_Section92_WritesThePublishedNumbers()
    {
        CommandLineRun run = Run(
            "--fixed-state", Section92, "--width", "1024", "--height", "1024", "--pov-options", "Antialias=Off", "--rendering-annotation");

        Assert.True(run.ExitCode == 0, run.Error);
        string stem = _folder["MoonSurfIllumSim_step_00001"];
        Assert.Equal(
            string.Join('\n', $"{stem}.png", $"{stem}.annotated.png", $"{stem}.pov", $"{stem}.xml"),
            run.Output.TrimEnd());
        XElement root = XDocument.Load($"{stem}.xml").Root!;
        XElement general = root.Element("GeneralInformation")!;

        // CSPICE N0067: (+1.074955473280880E+011, -1.042430734878980E+011, +4.036164305561260E+009) m, 15 digits.
        XElement sun = general.Element("SunPosition")!.Element("Vector3D")!;
        AssertDigits(1.07495547328088e11, Number(sun.Attribute("x")!.Value), Rounding.OfTurns);
        AssertDigits(-1.04243073487898e11, Number(sun.Attribute("y")!.Value), Rounding.OfTurns);
        AssertDigits(4.03616430556126e9, Number(sun.Attribute("z")!.Value), Rounding.OfTurns);
        Assert.Equal("+1.091277124746190E+006", general.Element("FlightAltitude")!.Value);
        Assert.Equal("+5.528900000000000E+004", general.Descendants("MJD").Single().Value);

        // Section 9.2 prints the coordinates; the directions are exact values from 50 digits (tests/reference/illumination.py).
        AssertPixel(root, 450, 44.58440049692400, 56.79090635326980, 280.850536814846401);
        AssertPixel(root, 500, 41.65137059729800, 58.68035440967800, 279.032828143072597);
        Assert.Equal((1024, 1024), SizeOf($"{stem}.png"));
        Assert.Equal((1024, 1024), SizeOf($"{stem}.annotated.png"));
    }

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Run_Twice_WritesTheSameBytes()
    {
        Assert.Equal(0, Run(SmallView).ExitCode);
        byte[][] first = ReadOutputs();

        Assert.Equal(0, Run(SmallView).ExitCode);

        Assert.Equal(first, ReadOutputs());
    }

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Run_BracesExpandedByTheShell_MeanTheSame()
    {
        Assert.Equal(0, Run([.. SmallView, "--output-name", "a"]).ExitCode);
        string[] words = ["--fixed-state", .. Section92.Trim('{', '}').Split(','), "--width", "64", "--height", "48", "--output-name", "b"];

        Assert.Equal(0, Run(words).ExitCode);

        Assert.Equal(File.ReadAllBytes(_folder["a.png"]), File.ReadAllBytes(_folder["b.png"]));
    }

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Run_BatchFileFromStandardInput_MakesOneFrameALineInOrder()
    {
        string state = Section92.Trim('{', '}').Replace(',', ' ');
        CommandLineRun run = CommandLineRun.Of(
            ["--batch-file", "-", "--width", "64", "--height", "48", .. RealMoon.Arguments(_folder.Path)],
            $"# two states\n{state}\n\n55289 -2E6 2E6 0 0 0 -9.238795325112867E-1 3.826834323650898E-1 # the second\n");

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Equal(
            ["MoonSurfIllumSim_step_00001.png", "MoonSurfIllumSim_step_00002.png"],
            run.Output.Split('\n').Where(line => line.EndsWith(".png", StringComparison.Ordinal)).Select(Path.GetFileName));
        Assert.Contains("2 of 2 done", run.Error, StringComparison.Ordinal);

        Assert.Equal(0, Run([.. SmallView, "--output-name", "alone"]).ExitCode);
        Assert.Equal(File.ReadAllBytes(_folder["alone.png"]), File.ReadAllBytes(_folder["MoonSurfIllumSim_step_00001.png"]));
    }

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Run_PathsWithBlanksQuotesAndUmlauts_Work()
    {
        string odd = _folder["M\u00f6nd 'a' \"b\" $HOME;x"];
        CommandLineRun run = CommandLineRun.Of(
        [
            .. SmallView, "--ldem", TestParts.Ldem4Label!, "--pattern-repos", Path.Combine(odd, "p\u00e4tterns"), "--output-dir", odd,
            "--ephemeris", "builtin", "--output-name", "M\u00f6nd 1", "--rendering-annotation",
        ]);

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Equal((64, 48), SizeOf(Path.Combine(odd, "M\u00f6nd 1.png")));
        Assert.Equal(0, Run([.. SmallView, "--output-name", "plain"]).ExitCode);
        Assert.Equal(File.ReadAllBytes(_folder["plain.png"]), File.ReadAllBytes(Path.Combine(odd, "M\u00f6nd 1.png")));
    }

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Run_IgnoreSun_NeedsNoEphemerisAndLightsFromTheCamera()
    {
        CommandLineRun run = Run([.. SmallView, "--ignore-sun", "--kernels", Path.Combine(TestParts.Kernels, "naif0012.tls")]);

        Assert.True(run.ExitCode == 0, run.Error);
        XElement general = XDocument.Load(_folder["MoonSurfIllumSim_step_00001.xml"]).Root!.Element("GeneralInformation")!;
        Assert.Equal("+2.000000000000000E+006", general.Element("SunPosition")!.Element("Vector3D")!.Attribute("x")!.Value);
    }

    // tests/reference/sun_aberration.py, MJD 55289; without the option it is the thesis's, +1.074955473281...E+011.
    [RequiresTheory(Part.Ldem4)]
    [InlineData("none", 107495547328.10955)]
    [InlineData("lt", 107495552584.33277)]
    [InlineData("lt+s", 107484946064.26609)]
    public void Run_Aberration_IsThatOfTheSunInTheMetaFile(string aberration, double x)
    {
        CommandLineRun run = CommandLineRun.Of(
        [
            .. SmallView, "--renderer", "native", "--reflectance", "lambert", "--aberration", aberration,
            "--ldem", TestParts.Ldem4Label!, "--output-dir", _folder.Path, "--ephemeris", "builtin",
        ]);

        Assert.True(run.ExitCode == 0, run.Error);
        XElement general = XDocument.Load(_folder["MoonSurfIllumSim_step_00001.xml"]).Root!.Element("GeneralInformation")!;
        string text = general.Element("SunPosition")!.Element("Vector3D")!.Attribute("x")!.Value;
        Assert.Equal(x, double.Parse(text, CultureInfo.InvariantCulture), 0.2);
        Assert.Contains($"--aberration {aberration}", general.Element("CommandLine")!.Value, StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Run_MoonOutOfView_IsAValidBlackFrame()
    {
        CommandLineRun run = Run(
            "--fixed-state", "{55289,2E6,2E6,0,0,0,0.9238795325112867,-0.3826834323650898}", "--width", "32", "--height", "32");

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.DoesNotContain("#include", File.ReadAllText(_folder["MoonSurfIllumSim_step_00001.pov"]), StringComparison.Ordinal);
        Assert.Empty(XDocument.Load(_folder["MoonSurfIllumSim_step_00001.xml"]).Descendants("Pixel"));
    }

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Run_OnePixel_IsAImage()
    {
        CommandLineRun run = Run("--fixed-state", Section92, "--width", "1", "--height", "1", "--grid", "1");

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Equal((1, 1), SizeOf(_folder["MoonSurfIllumSim_step_00001.png"]));
        Assert.Single(XDocument.Load(_folder["MoonSurfIllumSim_step_00001.xml"]).Descendants("Pixel"));
    }

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Run_Timing_IsOneLineOfJson()
    {
        CommandLineRun run = Run([.. SmallView, "--timing"]);

        string json = Assert.Single(run.Error.Split('\n'), line => line.StartsWith('{'));
        JsonElement times = JsonDocument.Parse(json).RootElement;
        Assert.Equal(1, times.GetProperty("frames").GetInt32());
        Assert.True(times.GetProperty("trace_s").GetDouble() <= times.GetProperty("pov_ray_s").GetDouble());
        string[] notParts = ["total_s", "parse_s", "trace_s"]; // POV-Ray's own times are within pov_ray_s
        double sum = times.EnumerateObject()
            .Where(time => time.Name.EndsWith("_s", StringComparison.Ordinal) && !notParts.Contains(time.Name))
            .Sum(time => time.Value.GetDouble());
        double total = times.GetProperty("total_s").GetDouble();
        bool isOneAfterTheOther = times.GetProperty("other_s").GetDouble() > 0.0;
        Assert.InRange(sum, total - 0.001, isOneAfterTheOther ? total + 0.001 : double.PositiveInfinity); // each is rounded to 0.0001 s
    }

    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Run_KeplerOrbitOverTheInterval_MakesAFrameAStep()
    {
        CommandLineRun run = Run(
            "--kepler-set", "{2.5E6,0,0,0,1.2,0.5}", "--epoch", "55289", "--time-interval", "[55289:0.1:55289.3]",
            "--width", "16", "--height", "16", "--output-name", "t{mjd:0.0}", "--pov-options", "Antialias=Off");

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Equal(
            ["t55289.0.png", "t55289.1.png", "t55289.2.png", "t55289.3.png"],
            Directory.EnumerateFiles(_folder.Path, "*.png").Select(Path.GetFileName).Order());
    }

    private CommandLineRun Run(params string[] arguments) => CommandLineRun.Of([.. arguments, .. RealMoon.Arguments(_folder.Path)]);

    private byte[][] ReadOutputs() => [.. Directory.EnumerateFiles(_folder.Path).Order().Select(File.ReadAllBytes)];

    private static (int Width, int Height) SizeOf(string path)
    {
        using FileStream stream = File.OpenRead(path);
        Adapters.Render.PngHeader header = Adapters.Render.PngFile.Check(stream, path);
        return (header.Width, header.Height);
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    private static void AssertDigits(double expected, double actual, double relative) =>
        Assert.InRange(Math.Abs(actual - expected), 0.0, relative * Math.Abs(expected));

    private static void AssertPixel(XElement root, int h, double latitude, double longitude, double direction)
    {
        XElement pixel = root.Descendants("Pixel").Single(candidate =>
            candidate.Attribute("h")!.Value == h.ToString(CultureInfo.InvariantCulture) && candidate.Attribute("v")!.Value == "100");
        XElement point = pixel.Element("SelenographicCoordinates")!;
        Assert.InRange(Number(point.Attribute("lat")!.Value) - latitude, -CoordinateTolerance, CoordinateTolerance);
        Assert.InRange(Number(point.Attribute("lon")!.Value) - longitude, -CoordinateTolerance, CoordinateTolerance);
        Assert.InRange(Number(pixel.Element("IlluminationDirection")!.Value) - direction, -DirectionTolerance, DirectionTolerance);
    }
}
