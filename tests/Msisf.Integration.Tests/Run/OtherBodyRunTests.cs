using System.Globalization;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>Images of another body as a user makes them: a synthetic model of Mercury, drawn with its own kernels.</summary>
public sealed class OtherBodyRunTests : IDisposable
{
    private const double Radius = 2_439_400.0;

    private static readonly string[] View =
    [
        "--body", "mercury", "--renderer", "native", "--res", "2", "--width", "60", "--height", "60", "--grid", "6", "--surface", "terrain",
        "--ephemeris", "builtin", "--batch",
    ];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Run_Mercury_IsMercury()
    {
        string model = Model();
        Succeed(
            [
                .. View, "--ldem", model, "--position", "20,300,400000", "--time", "2020-11-23T06:00:00Z", "--fov", "40", "--output-dir",
                _folder["a"],
            ]);

        string path = Path.Combine(_folder["a"], "MoonSurfIllumSim_step_00001");
        XElement general = XDocument.Load($"{path}.xml").Root!.Element("GeneralInformation")!;
        XElement body = general.Element("Body")!;
        Assert.Equal(("Mercury", "IAU_MERCURY"), (body.Attribute("name")!.Value, body.Attribute("frame")!.Value));
        Assert.Equal(Radius, Number(body.Attribute("referenceRadius")!.Value));
        Assert.Equal(400_000.0, Number(general.Element("FlightAltitude")!.Value), 1e-6); // m: thousands of ulps of the place
        XElement sun = general.Element("SunPosition")!.Element("Vector3D")!;
        Assert.Equal(56037155921.851873, Number(sun.Attribute("x")!.Value), 1.0); // tests/reference/mercury_sun.py
        XElement[] pixels = [.. XDocument.Load($"{path}.xml").Root!.Descendants("Pixel")];
        Assert.True(pixels.Length > 30);
        foreach (XElement pixel in pixels)
        {
            XElement point = pixel.Element("Position")!.Element("Vector3D")!;
            double[] at = [.. new[] { "x", "y", "z" }.Select(axis => Number(point.Attribute(axis)!.Value))];
            double radius = Math.Sqrt((at[0] * at[0]) + (at[1] * at[1]) + (at[2] * at[2]));
            Assert.Equal(radius - Radius, Number(pixel.Element("Height")!.Value), 1e-6);
            Assert.InRange(radius - Radius, -12_000.0, 12_000.0);
        }

        // The canonical arguments make the same image again.
        string state = Regex.Match(general.Element("CommandLine")!.Value, "--fixed-state '([^']*)'").Groups[1].Value;
        Assert.Contains("--body mercury", general.Element("CommandLine")!.Value, StringComparison.Ordinal);
        Succeed([.. View, "--ldem", model, "--fixed-state", state, "--fov", "40", "--output-dir", _folder["b"]]);
        Assert.Equal(
            File.ReadAllBytes($"{path}.png"), File.ReadAllBytes(Path.Combine(_folder["b"], "MoonSurfIllumSim_step_00001.png")));
    }

    [Fact]
    public void Run_WrongModelOrPlace_IsRefused()
    {
        string model = Model();
        string[] place = ["--position", "20,300,400000", "--time", "55289", "--output-dir", _folder["c"]];
        CommandLineRun moon = CommandLineRun.Of(
            ["--renderer", "native", "--res", "2", "--ldem", model, "--batch", .. place]);
        Assert.Equal(2, moon.ExitCode);
        Assert.Contains("a model of Mercury, but one of the Moon is needed here", moon.Error, StringComparison.Ordinal);

        CommandLineRun inside = CommandLineRun.Of(
            [.. View, "--ldem", model, "--fixed-state", "{55289,2E6,0,0,0,0,0,1}", "--output-dir", _folder["c"]]);
        Assert.Equal(2, inside.ExitCode);
        Assert.Contains("the camera is inside Mercury: step 1", inside.Error, StringComparison.Ordinal);

        CommandLineRun kernels = CommandLineRun.Of(
            [.. View, "--ldem", model, "--kernels", Path.Combine(TestParts.Kernels, "msisf.tm"), .. place]);
        Assert.Equal(2, kernels.ExitCode);
        Assert.Contains("No text kernel gives the orientation of Mercury", kernels.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(_folder["c"]) && Directory.EnumerateFiles(_folder["c"], "*.png").Any());
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    private static void Succeed(string[] arguments)
    {
        CommandLineRun run = CommandLineRun.Of(arguments);
        Assert.True(run.ExitCode == 0, run.Error);
    }

    private string Model()
    {
        Succeed(["ldem", "synthesize", "--body", "mercury", "--res", "2", "--seed", "7", "--output-dir", _folder["model"], "--batch"]);
        return Path.Combine(_folder["model"], "MERCURY_DEM_2_SYNTHETIC.LBL");
    }
}
