using System.Globalization;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.CameraExport;

/// <summary><c>--camera-model</c> and <c>msis camera-model</c>: each file puts the point of each pixel into that pixel.</summary>
public sealed class CameraModelTests : IDisposable
{
    /// <summary>px: what is promised.</summary>
    private const double Tolerance = 1e-6;

    private const string Time = "55292.85";

    private const string Csm = "csm,isd,isd-body";

    private const string All = "opencv,colmap,tsai,isis," + Csm;

    private const string OffCentre =
        "width: 60\nheight: 40\nfocal-length: 6\npixel-pitch: [0.05, 0.06]\nprincipal-point: [33.5, 17.25]\npixel-convention: opencv\n";

    private const string Square =
        "width: 60\nheight: 40\nfocal-length: 6\npixel-pitch: 0.05\nprincipal-point: [33.5, 17.25]\npixel-convention: opencv\n";

    private const string Skew = "skew: 1.5\n";

    private const string Brown = "distortion: {model: opencv, k1: -0.1, k2: 0.02, k3: 0.01, p1: 0.002, p2: -0.001}\n";

    /// <summary>Each lens that a format has, with the formats that have it.</summary>
    private static readonly (string Name, string Camera, string Formats)[] Cameras =
    [
        ("pinhole", OffCentre, All),
        ("skew", OffCentre + Skew, "isis," + Csm),
        ("brown", OffCentre + Brown, "opencv,colmap,tsai," + Csm),
        ("brown-skew", OffCentre + Skew + Brown, Csm),
        ("rational", OffCentre + "distortion: {model: opencv, k1: -0.1, k4: 0.03, k6: 0.01}\n", "opencv,colmap"),
        ("prism", OffCentre + "distortion: {model: opencv, k1: -0.1, s1: 0.003, s4: -0.002}\n", "opencv"),
        ("fisheye", OffCentre + "distortion: {model: fisheye, k1: -0.02, k2: 0.01, k3: 0.003, k4: -0.001}\n", "opencv,colmap,tsai"),
        ("radial", OffCentre + Skew + "distortion: {model: radial, form: factor, k: [0.004, 0.0003]}\n", Csm),
        ("factor", Square + "distortion: {model: radial, form: factor, k: [0.004, 0.0003, 0.00001]}\n", "tsai"),
        ("division", OffCentre + "distortion: {model: radial, form: division, k: [0.004]}\n", "colmap"),
        ("line", OffCentre.Replace("height: 40", "height: 1").Replace("17.25", "0") + Skew
            + "distortion: {model: radial, form: division, k: [0.004]}\n", Csm),
        ("wide-line", OffCentre.Replace("width: 60", "width: 400").Replace("height: 40", "height: 1").Replace("[33.5, 17.25]", "[203.5, 0]")
            + "distortion: {model: radial, form: division, k: [0.004]}\n", Csm),
        ("along-row", OffCentre.Replace("height: 40", "height: 1") + Skew + "distortion: {model: polynomial, argument: x, "
            + "x: [0.01, 0.002, -0.003, 0.0005], y: [-0.02, 0.001, 0.002]}\n", Csm),
        ("corrected", OffCentre + "distortion: {model: brown, k0: 0.002, k1: 0.004, k2: 0.0003}\n", Csm),
        ("polynomial", OffCentre + Skew + "distortion: {model: polynomial, argument: radius, x: [0.01, 0.002, -0.003, 0.0005], "
            + "y: [-0.02, 0.001, 0.002]}\n", Csm),
        ("owen", OffCentre + Skew + "distortion: {model: owen, e2: 0.003, e5: 0.001, e6: -0.002}\n", Csm),
    ];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>Numpy projects by the published formulas, from the file alone; CSPICE has the time and the Moon's rotation.</summary>
    [RequiresFact(Part.Ldem4, Part.Astropy, Part.CSpice)]
    public void EachFormat_EachLens_PutsEachPointIntoItsPixel()
    {
        List<string> folders = [];
        int models = 0;
        foreach ((string name, string camera, string formats) in Cameras)
        {
            Succeed(Arguments(name, camera, ["--camera-model", formats]));
            string again = $"{name}-again";
            Directory.CreateDirectory(_folder[again]);
            foreach (string file in (string[])["frame.xml", "frame.position.npy", "frame.radiance-factor.npy"])
            {
                File.Copy(_folder[$"{name}/{file}"], _folder[$"{again}/{file}"]);
            }

            Succeed(["camera-model", _folder[$"{again}/frame.xml"], "--to", formats]);
            string[] written =
                [.. Directory.GetFiles(_folder[again]).Where(path => !path.EndsWith(".npy", StringComparison.Ordinal))];
            Assert.All(written, path => Assert.Equal(
                File.ReadAllText(_folder[$"{name}/{Path.GetFileName(path)}"]), File.ReadAllText(path)));
            folders.AddRange([name, again]);
            models += 2 * formats.Split(',').Length;
        }

        string[] lines = ChildRun.Of(
            TestParts.Python!,
            [
                "-B", Path.Combine(TestParts.RepositoryRoot, "tests", "Msisf.Integration.Tests", "CameraExport", "project.py"),
                TestParts.CSpiceLibrary!, TestParts.Kernels, Time, .. folders.Select(folder => _folder[folder]),
            ],
            _folder.Path).Succeeded().Output.TrimEnd().Split('\n');

        Assert.Equal(models, lines.Length);
        Assert.All(lines, line =>
        {
            string[] words = line.Split(' ');
            Assert.True(words[2] == words[0].Replace("-again", "", StringComparison.Ordinal) switch
            {
                "line" or "along-row" => "60",
                "wide-line" => "280", // the others look past the Moon
                _ => "2400",
            }, line);
            Assert.True(double.Parse(words[3], CultureInfo.InvariantCulture) < Tolerance, line);
            Assert.True(words[4] == "-", line);
        });
    }

    /// <summary>The files belong to the frame: made again when one is missing; a run without them has the bytes it had.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Files_BelongToTheFrame()
    {
        Succeed(Arguments("run", OffCentre, ["--camera-model", "tsai,colmap"]));
        Succeed(["verify", _folder["run"]]);
        byte[] written = File.ReadAllBytes(_folder["run/frame.tsai"]);
        File.Delete(_folder["run/frame.tsai"]);
        CommandLineRun damaged = CommandLineRun.Of(["verify", _folder["run"]]);
        Succeed(Arguments("run", OffCentre, ["--camera-model", "tsai,colmap"]));
        Succeed(Arguments("plain", OffCentre, []));
        Succeed(["camera-model", _folder["plain/frame.xml"], "--to", "tsai"]);
        Succeed(["verify", _folder["plain"]]);
        Succeed(["camera-model", _folder["run/frame.xml"], "--to", "tsai"]);
        Succeed(["verify", _folder["run"]]);

        Assert.Equal(5, damaged.ExitCode);
        Assert.Contains("frame.tsai: missing", damaged.Output);
        Assert.Equal(written, File.ReadAllBytes(_folder["run/frame.tsai"]));
        Assert.Equal(File.ReadAllBytes(_folder["plain/frame.png"]), File.ReadAllBytes(_folder["run/frame.png"]));
        Assert.DoesNotContain("camera-model", File.ReadAllText(_folder["plain/frame.xml"]));
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData("distortion: {model: fisheye, k1: 0.1}", "csm", 2, "csm can't say the lens 'fisheye'", "can: opencv, colmap, tsai.")]
    [InlineData("distortion: {model: radial, form: division, k: [0.001]}", "isd", 2, "the lens 'radial-division'", "can: colmap.")]
    [InlineData("distortion: {model: radial, form: division, k: [0.001, 0.001]}", "colmap", 2, "the lens 'radial-division'", "No format")]
    [InlineData("distortion: {model: radial, form: factor, k: [0, 0, 0.1]}", "tsai", 2, "tsai can't say the lens 'radial-", "No format")]
    [InlineData("distortion: {model: opencv, k1: 0.1, k4: 0.1}", "opencv,tsai", 2, "tsai can't say the lens 'opencv'", "opencv, colmap.")]
    [InlineData("distortion: {model: owen, e1: 0.001}", "isd-body", 2, "isd-body can't say the lens 'owen'", "No format")]
    [InlineData("distortion: {model: radial, k: [0, 0, 0.1]}", "csm", 2, "no counterpart of k3 (its RADIAL ends with the", "No format")]
    [InlineData("distortion: {model: polynomial, argument: x, x: [0, 0, 0, 0.3], y: [0]}", "isd", 2, "of a polynomial of x", "No format")]
    [InlineData("distortion: {model: brown, s1: 0.1}", "csm,opencv", 2, "TRANSVERSE is off by up to 0.28 px", "No format")]
    [InlineData("skew: 1", "colmap", 2, "colmap can't say skew pixels", "can: csm, isd, isd-body, isis.")]
    [InlineData("scan: {kind: rolling-shutter, period: 0.001}", "isis", 2, "isis can't say a camera that scans", "can: csm, isd")]
    [InlineData("distortion: {model: opencv, k1: 0.1}", "isis", 2, "isis can't say the lens 'opencv'", "can: opencv, colmap, tsai, csm")]
    [InlineData("skew: 0", "csm,tsa", 1, "'tsa' is not a format", "Give some of opencv, colmap, tsai, csm")]
    [InlineData("scan: {kind: rolling-shutter, period: 0.001}", "csm,tsai", 2, "tsai can't say a camera that scans", "can: csm, isd, ")]
    public void CameraThatAFormatCannotSay_IsOneLine(string camera, string formats, int exitCode, string problem, string remedy)
    {
        CommandLineRun run = CommandLineRun.Of(
            Arguments("wrong", $"{OffCentre}{camera}\n", ["--camera-model", formats]));

        Assert.True(exitCode == run.ExitCode, run.Error);
        Assert.Contains(problem, run.Error);
        Assert.Contains(remedy, run.Error);
        Assert.DoesNotContain("   at ", run.Error);
        Assert.False(File.Exists(_folder["wrong/frame.png"]));
    }

    [Theory]
    [InlineData("<a/>", "there is no GeneralInformation in it")]
    [InlineData("width: 3", "is not a meta file of msis")]
    [InlineData("<M><GeneralInformation><SimulationTime/></GeneralInformation></M>", "did not write the camera yet")]
    [InlineData("<M><GeneralInformation><Camera width='x'/></GeneralInformation></M>", "Camera has no K.")]
    [InlineData(null, "can't be read")]
    public void MetaFileWithoutACamera_IsOneLine(string? content, string expected)
    {
        string path = content is null ? _folder["missing.xml"] : _folder.Write("meta.xml", content);

        CommandLineRun run = CommandLineRun.Of(["camera-model", path, "--to", "tsai"]);

        Assert.Equal(2, run.ExitCode);
        Assert.Contains($"{path}: ", run.Error);
        Assert.Contains(expected, run.Error);
        Assert.DoesNotContain("   at ", run.Error);
    }

    private string[] Arguments(string name, string camera, string[] more) =>
    [
        "--fixed-state", $"{{{Time},1.95E6,2E5,1E5,0.02,-0.03,0.3,0.9533}}", "--normalize",
        "--camera", _folder.Write($"{name}.yaml", camera),
        "--renderer", "native", "--reflectance", "lambert", "--layers", "position,radiance-factor", "--layers-format", "npy",
        "--grid", "20",
        "--output-dir", _folder[name], "--output-name", "frame", "--ldem", TestParts.Ldem4Label!, "--batch", .. more,
    ];

    private static void Succeed(string[] arguments)
    {
        CommandLineRun run = CommandLineRun.Of(arguments);
        Assert.True(run.ExitCode == 0, run.Error);
    }
}
