using System.Globalization;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.CameraExport;

/// <summary>Cubes of ISIS and PDS4 products, as GDAL and a parser in Python read them.</summary>
public sealed class CubeTests : IDisposable
{
    private const string Time = "55292.85";

    private const string Formats = "isis,pds4";

    private const string Camera =
        "width: 60\nheight: 40\nfocal-length: 6\npixel-pitch: [0.05, 0.06]\nprincipal-point: [33.5, 17.25]\npixel-convention: opencv\n";

    private const string Detector = "detector:\n  f-number: 4\n  band: [500, 650]\n  transmission: 0.8\n  quantum-efficiency: 0.45\n"
        + "  exposure-time: 0.004\n  psf: gaussian\n  psf-sigma: 0.8\n  gain: 12\n  read-noise: 15\n  bias: 64\n  full-well: 40000\n"
        + "  adc-bits: 12\n  seed: 7\n";

    private const string Scan = "width: 40\nheight: 1\nfocal-length: 6\npixel-pitch: [0.05, 0.06]\nskew: 1.5\n"
        + "principal-point: [23.5, 4.25]\npixel-convention: opencv\nscan: {kind: line-scan, period: 0.05ORDER}\n";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>I/F, digital numbers, and another body.</summary>
    [RequiresFact(Part.Ldem4, Part.Astropy, Part.Gdal, Part.CSpice, Part.CFitsio)]
    public void CubeAndPds4_HoldImageCameraAndSun()
    {
        string[] moon =
            ["--fixed-state", $"{{{Time},1.95E6,2E5,1E5,0.02,-0.03,0.3,0.9533}}", "--normalize", "--ldem", TestParts.Ldem4Label!];
        Draw("factors", [.. moon, "--camera", _folder.Write("plain.yaml", Camera), "--reflectance", "lambert"]);
        Draw("numbers", [.. moon, "--camera", _folder.Write("detector.yaml", Camera + "skew: 2.5\n" + Detector)]);
        foreach ((string name, string order) in (ReadOnlySpan<(string, string)>)[("scan", ""), ("scan-up", ", order: up")])
        {
            string camera = _folder.Write($"{name}.yaml", Scan.Replace("ORDER", order, StringComparison.Ordinal));
            Draw(name, [.. moon, "--camera", camera, "--lines", "30", "--motion", "{200,-900,1300,0.02,-0.05,0.08}"]);
        }

        Succeed(["ldem", "synthesize", "--res", "1", "--body", "mercury", "--seed", "1", "--output-dir", _folder.Path, "--batch"]);
        Draw(
            "mercury",
            [
                "--body", "mercury", "--res", "1", "--ldem", _folder["MERCURY_DEM_1_SYNTHETIC.LBL"], "--time", Time, "--position",
                "20,300,9000000", "--reflectance", "lambert", "--width", "50", "--height", "30",
            ]);

        string[] lines = ChildRun.Of(
            TestParts.Python!,
            [
                "-B", Path.Combine(TestParts.RepositoryRoot, "tests", "Msisf.Integration.Tests", "CameraExport", "cubes.py"),
                TestParts.CSpiceLibrary!, TestParts.Kernels, Time, _folder["factors"], _folder["numbers"], _folder["mercury"],
                _folder["scan"], _folder["scan-up"],
            ],
            _folder.Path).Succeeded().Output.TrimEnd().Split('\n');

        Assert.Equal(5, lines.Length);
        foreach ((string line, string begin, double least) in lines.Zip(
            ["factors Moon ", "numbers Moon ", "mercury Mercury ", "scan Moon ", "scan-up Moon "], [0.001, 65.0, 0.001, 1e-5, 1e-5]))
        {
            string[] words = line.Split(' ');
            Assert.StartsWith(begin, line);
            Assert.True(double.Parse(words[2], CultureInfo.InvariantCulture) > least, line);
            Assert.True(words[3] == "ok", line);
        }
    }

    /// <summary>The same bytes afterwards: digital numbers are in the PNG, I/F in the layer.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Afterwards_SameBytes()
    {
        string[] view = ["--position", "10,180,300000", "--time", Time, "--ldem", TestParts.Ldem4Label!];
        Draw("numbers", [.. view, "--camera", _folder.Write("detector.yaml", Camera + Detector + "  fits: no\n")], layers: null);
        Draw("factors", [.. view, "--camera", _folder.Write("plain.yaml", Camera)], layers: "npy");
        foreach (string name in (string[])["numbers", "factors"])
        {
            byte[][] written = Bytes(name);
            Succeed(["camera-model", _folder[$"{name}/frame.xml"], "--to", Formats]);
            Assert.Equal(written, Bytes(name));
        }

        File.Delete(_folder["factors/frame.radiance-factor.npy"]);
        CommandLineRun missing = CommandLineRun.Of(["camera-model", _folder["factors/frame.xml"], "--to", "isis"]);
        _folder.Write("factors/frame.radiance-factor.npy", "no array");
        CommandLineRun wrong = CommandLineRun.Of(["camera-model", _folder["factors/frame.xml"], "--to", "isis"]);

        Assert.Equal((2, 2), (missing.ExitCode, wrong.ExitCode));
        Assert.Contains("frame.radiance-factor.npy is not there, and the meta file alone has no pixels. Draw", missing.Error);
        Assert.Contains("frame.radiance-factor.npy: is not an array of 40 x 60 real numbers", wrong.Error);
    }

    [RequiresFact(Part.Ldem4)]
    public void PovRay_IsRefused()
    {
        CommandLineRun run = CommandLineRun.Of(
        [
            "--position", "10,180,300000", "--time", Time, "--ldem", TestParts.Ldem4Label!, "--renderer", "povray",
            "--camera-model", "pds4",
        ]);

        Assert.Equal(1, run.ExitCode);
        Assert.Contains("--camera-model pds4 holds I/F of each pixel, which POV-Ray does not tell. Add --renderer native.", run.Error);
    }

    private byte[][] Bytes(string name) =>
        [.. ((string[])["cub", "img", "lblx"]).Select(ending => File.ReadAllBytes(_folder[$"{name}/frame.{ending}"]))];

    private void Draw(string name, string[] arguments, string? layers = "fits") => Succeed(
    [
        "--renderer", "native", "--grid", "20", "--output-dir", _folder[name], "--output-name", "frame", "--camera-model", Formats,
        "--batch", .. arguments, .. layers is null ? (string[])[] : ["--layers", "position,radiance-factor", "--layers-format", layers],
    ]);

    private static void Succeed(string[] arguments)
    {
        CommandLineRun run = CommandLineRun.Of(arguments);
        Assert.True(run.ExitCode == 0, run.Error);
    }
}
