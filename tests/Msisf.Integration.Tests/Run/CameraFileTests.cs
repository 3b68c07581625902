using System.Text.RegularExpressions;
using System.Xml.Linq;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary><c>--camera</c> as a user runs it.</summary>
public sealed class CameraFileTests : IDisposable
{
    /// <summary>Levels of 255: what the two renderers may differ by at a pixel that shows the same facet.</summary>
    private const int GreyTolerance = 1;

    private const string State = "{55289,2E6,2E6,0,0,0,3.826834323650898E-1,9.238795325112867E-1}";

    private const string Lens =
        "width: 300\nheight: 200\nfocal-length: 6\npixel-pitch: [0.024, 0.03]\nprincipal-point: [160, 90]\n"
            + "pixel-convention: opencv\nskew: 2\n"
            + "distortion:\n  model: opencv\n  k1: -0.2\n  k2: 0.05\n  p1: 0.002\n  k4: 0.01\n  s1: 0.003\n";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>The lines of docs/cameras.md put the point of each pixel of a drawn frame into that pixel.</summary>
    [RequiresFact(Part.Ldem4, Part.Astropy)]
    public void Run_Lens_DocumentedLinesProjectEachPointToItsPixel()
    {
        Render("lens", Lens, "--renderer", "native", "--surface", "terrain");
        string page = File.ReadAllText(Path.Combine(TestParts.RepositoryRoot, "docs", "cameras.md"));
        string script = Regex.Match(page, "```python\n(.*?)```", RegexOptions.Singleline).Groups[1].Value
            + """

            import sys
            import xml.etree.ElementTree as ET
            root = ET.parse(sys.argv[1]).getroot()
            pixels = root.findall("PixelInformation/Pixel")
            points = np.array([[float(p.find("Position/Vector3D").get(axis)) for axis in "xyz"] for p in pixels])
            seen = np.array([[float(p.get("h")) - 1, float(p.get("v")) - 1] for p in pixels])
            error = np.abs(project(root.find("GeneralInformation/Camera"), points) - seen).max()
            print(len(pixels), "close" if error < 1e-7 else error)
            """;
        string path = _folder["project.py"];
        File.WriteAllText(path, script);

        ChildRun run = ChildRun.Of(TestParts.Python!, [path, _folder["lens.xml"]], _folder.Path);

        Assert.Equal((0, "close"), (run.ExitCode, run.Output.Trim().Split(' ')[^1]));
        Assert.True(int.Parse(run.Output.Split(' ')[0], System.Globalization.CultureInfo.InvariantCulture) > 10);
        Assert.Equal("camera", XElement.Load(_folder["lens.xml"]).Descendants("Input").Last().Attribute("kind")!.Value);
    }

    /// <summary>A pinhole off the axis, with rectangular and skew pixels, is the same picture by both renderers.</summary>
    [RequiresFact(Part.Ldem4, Part.PovRay)]
    public void Run_PinholeOffTheAxis_IsTheSameByBothRenderers()
    {
        string pinhole = Lens[..Lens.IndexOf("distortion", StringComparison.Ordinal)];
        Render("povray", pinhole, "--pov-options", "Antialias=Off", "--lod", "off", "--pattern-repos", RealMoon.Repository);
        Render("native", pinhole, "--renderer", "native", "--reflectance", "lambert", "--lod", "off");

        PngPixels expected = PngPixels.Read(_folder["povray.png"]);
        PngPixels image = PngPixels.Read(_folder["native.png"]);
        int differing = 0;
        for (int pixel = 0; pixel < 300 * 200; pixel++)
        {
            (int x, int y) = (pixel % 300, pixel / 300);
            differing += Math.Abs(expected[x, y, 0] - image[x, y, 0]) > GreyTolerance ? 1 : 0;
        }

        Assert.InRange(differing, 0, 3); // docs/native-renderer.md: single pixels at edges, and leaks of POV-Ray's floats
    }

    private void Render(string name, string camera, params string[] more)
    {
        File.WriteAllText(_folder["camera.yaml"], camera);
        CommandLineRun run = CommandLineRun.Of(
        [
            "--fixed-state", State, "--camera", _folder["camera.yaml"], "--gridH", "20", "--gridV", "20",
            "--output-name", name, .. more, "--ldem", TestParts.Ldem4Label!,
            "--output-dir", _folder.Path, "--ephemeris", "builtin", "--batch",
        ]);
        Assert.True(run.ExitCode == 0, run.Error);
    }
}
