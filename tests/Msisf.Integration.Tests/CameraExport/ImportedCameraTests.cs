using Msisf.Adapters.Camera;
using Msisf.Core.Camera;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.CameraExport;

/// <summary>Each file that <c>--camera-model</c> writes is a camera file: the same camera as the one that was drawn.</summary>
public sealed class ImportedCameraTests : IDisposable
{
    /// <summary>Tangents: numbers are written to the last bit, some lenses in other units.</summary>
    private const double SameRay = 1e-12;

    private const string Rectangular = "width: 24\nheight: 18\nfocal-length: 6\npixel-pitch: [0.2, 0.24]\nprincipal-point: [13.5, 7.25]\n";

    private const string Square = "width: 24\nheight: 18\nfocal-length: 6\npixel-pitch: 0.2\nprincipal-point: [13.5, 7.25]\n";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.Ldem4)]
    [InlineData(Rectangular, "opencv,colmap,tsai,csm,isd,isd-body,isis")]
    [InlineData(Rectangular + "skew: 2.5\n", "csm,isd,isd-body,isis")]
    [InlineData(Rectangular + "distortion: {model: opencv, k1: -0.25, k2: 0.05, p1: 0.002, p2: -0.003, k3: 0.01}\n",
        "opencv,colmap,tsai,csm,isd,isd-body")]
    [InlineData(Rectangular + "distortion: {model: opencv, k1: -0.25, k4: 0.05, s1: 0.002, s4: -0.003}\n", "opencv")]
    [InlineData(Rectangular + "distortion: {model: fisheye, k1: -0.02, k2: 0.01, k4: 0.002}\n", "opencv,colmap,tsai")]
    [InlineData(Square + "distortion: {model: radial, form: factor, k: [0.001, 2.0e-5]}\n", "tsai,csm,isd,isd-body")]
    [InlineData(Square + "distortion: {model: radial, form: division, k: [0.001]}\n", "colmap")]
    [InlineData(Square + "distortion: {model: polynomial, argument: radius, x: [0.01, 0.001, -0.002], y: [0.02, 0.003]}\n",
        "csm,isd,isd-body")]
    [InlineData(Square + "distortion: {model: owen, e2: 0.0004, e5: 0.0005, e6: -0.0006}\n", "csm,isd,isd-body")]
    public void Frames_AreReadAsTheyWereDrawn(string camera, string formats) => RequireSame(camera, formats, []);

    [RequiresTheory(Part.Ldem4)]
    [InlineData("width: 24\nheight: 1\nfocal-length: 6\npixel-pitch: 0.2\nprincipal-point: [13.5, 1]\n"
            + "distortion: {model: radial, form: division, k: [0.001]}\nscan: {kind: line-scan, period: 0.05}\n",
        "csm,isd,isd-body", "--lines")]
    [InlineData("width: 24\nheight: 1\nfocal-length: 6\npixel-pitch: 0.2\nprincipal-point: [13.5, 3.25]\n"
            + "scan: {kind: line-scan, period: 0.05, order: up}\n", "csm,isd,isd-body", "--lines")]
    [InlineData("width: 24\nheight: 1\nfocal-length: 6\npixel-pitch: 0.2\nprincipal-point: [13.5, 3.25]\n"
            + "scan: {kind: line-scan, period: 0.05}\n", "isis", "--lines")]
    [InlineData("width: 24\nheight: 3\nfocal-length: 6\npixel-pitch: 0.2\nprincipal-point: [13.5, 3.25]\n"
            + "scan: {kind: push-frame, period: 0.05}\n", "csm,isd,isd-body", "--framelets")]
    [InlineData("width: 24\nheight: 3\nfocal-length: 6\npixel-pitch: 0.2\nprincipal-point: [13.5, 3.25]\n"
            + "scan: {kind: push-frame, period: 0.05, order: up, flip: yes}\n", "csm,isd,isd-body", "--framelets")]
    public void Scans_AreReadAsTheyWereDrawn(string camera, string formats, string count) =>
        RequireSame(camera, formats, [count, "6", "--motion", "{200,-900,1300,0.02,-0.05,0.08}"]);

    /// <summary>The program's own cubes: the twin is the image itself, of a frame and of a line-scan.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData(Rectangular, "")]
    [InlineData("width: 24\nheight: 1\nfocal-length: 6\npixel-pitch: 0.2\nprincipal-point: [13.5, 1.25]\n"
            + "scan: {kind: line-scan, period: 2}\n", "--lines 20 --motion {200,-900,1300,0.002,-0.005,0.008}")]
    public void Twin_OfTheProgramsOwnCube_IsTheImage(string camera, string scan)
    {
        Draw(camera, "isis", scan.Split(' ', StringSplitOptions.RemoveEmptyEntries));
        Succeed(
        [
            "twin", _folder["frame.cub"], "--output-dir", _folder["twin"], "--reflectance", "lambert", "--albedo-map", "none", "--ldem",
            TestParts.Ldem4Label!, "--aberration", "none", "--batch",
        ]);

        using System.Text.Json.JsonDocument found = System.Text.Json.JsonDocument.Parse(File.ReadAllText(_folder["twin/frame.twin.json"]));
        System.Text.Json.JsonElement comparison = found.RootElement.GetProperty("comparison");

        // float32 pixels, times of 2e-7 s: a wrong half of a line would make 1e-2.
        Assert.InRange(comparison.GetProperty("relativeRms").GetDouble(), 0.0, 1e-4);
        Assert.Equal(1.0, comparison.GetProperty("factor").GetDouble(), 1e-4);
    }

    private void RequireSame(string camera, string formats, string[] more)
    {
        CameraFile drawn = CameraFileReader.Read(Draw(camera, formats, more));
        string[] endings = [.. formats.Split(',').Select(format => format switch
        {
            "opencv" => ".opencv.yaml",
            "colmap" => ".cameras.txt",
            "isis" => ".cub",
            "tsai" => ".tsai",
            _ => $".{format}.json",
        })];
        foreach (string ending in endings)
        {
            CameraFile read = CameraFileReader.Read(
                _folder[$"frame{ending}"], size: ending == ".tsai" ? (drawn.Model.Width, drawn.Model.Height) : default);

            Assert.Equal((drawn.Model.Width, drawn.Model.Height), (read.Model.Width, read.Model.Height));
            Assert.Equal(drawn.Scan?.Kind, read.Scan?.Kind);
            Assert.Equal(drawn.Scan?.Period ?? 0.0, read.Scan?.Period ?? 0.0, 1e-12);
            Assert.Equal((drawn.Scan?.GrowsUpwards, drawn.Scan?.FlipsFramelets), (read.Scan?.GrowsUpwards, read.Scan?.FlipsFramelets));
            (double X, double Y)[] places = [(1.0, 1.0), (24.0, 1.0), (7.3, 2.6), (24.5, 18.5), (0.5, 9.0)];
            foreach ((double x, double y) in places)
            {
                double row = Math.Min(y, drawn.Model.Height);
                (double right, double down) = drawn.Model.ToIdeal(x, row);
                (double r, double d) = read.Model.ToIdeal(x, row);
                Assert.True(
                    Math.Abs(right - r) < SameRay && Math.Abs(down - d) < SameRay, $"{ending}: ({x}, {row}): {right - r}, {down - d}");
            }
        }
    }

    private string Draw(string camera, string formats, string[] more)
    {
        string file = _folder.Write("drawn.yaml", camera);
        Succeed(
        [
            "--renderer", "native", "--camera", file, "--position", "10,200,300000", "--time", "55292.85", "--reflectance", "lambert",
            "--ldem", TestParts.Ldem4Label!, "--aberration", "none", "--camera-model", formats, "--output-dir", _folder.Path,
            "--output-name", "frame", "--batch", .. more,
        ]);
        return file;
    }

    private static void Succeed(string[] arguments)
    {
        CommandLineRun run = CommandLineRun.Of(arguments);
        Assert.True(run.ExitCode == 0, run.Error);
    }
}
