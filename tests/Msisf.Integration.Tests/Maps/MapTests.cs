using System.Globalization;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Maps;

/// <summary><c>--map</c>: each cell has the numbers of the pixel in which its middle is seen, and none where nothing is seen.</summary>
public sealed class MapTests : IDisposable
{
    private const string Time = "2010-04-06T20:24:00Z";

    private const string OffCentre =
        "width: 90\nheight: 60\nfocal-length: 9\npixel-pitch: [0.05, 0.06]\nprincipal-point: [33.5, 17.25]\npixel-convention: opencv\n";

    private const string Lens = "skew: 1.5\ndistortion: {model: opencv, k1: -0.1, k2: 0.02, p1: 0.002}\n";

    private const string Detector =
        "detector: {f-number: 4, band: [500, 650], quantum-efficiency: 0.45, exposure-time: 0.004, gain: 12, full-well: 40000, seed: 7, "
            + "adc-bits: 12, fits: no}\n";

    private const string Scan = "width: 60\nheight: 1\nfocal-length: 20\npixel-pitch: 0.05\nscan: {kind: line-scan, period: 0.08}\n";

    /// <summary>Name, camera file, view, map, projection of GDAL, longitude of its middle.</summary>
    private static readonly (string Name, string Camera, string View, string Map, string Projection, double Middle)[] Frames =
    [
        ("lens", OffCentre + Lens, "--position 10,200,300000 --look-at 12,203", "orthographic,2000", "Orthographic", double.NaN),
        ("meridian", OffCentre, "--position 20,181,400000", "equirectangular,3000", "Equirectangular", 180.0),
        ("polar", OffCentre + Detector, "--position=-76,200,400000", "polar-stereographic,3000", "Polar_Stereographic", 0.0),
        ("limb", "width: 100\nheight: 80\nfield-of-view: 30\n", "--position 10,200,300000 --look-at 22,225", "Orthographic, 6000",
            "Orthographic", double.NaN),
        ("other-scan", Scan, "--kepler-set {1.7874E6,0,0,0.3,1.5,0.52} --epoch 55289 --lines 60", "equirectangular,120",
            "Equirectangular", 0.0),
        ("other-body", OffCentre, "--body mercury --res 1 --position=-40,300,2000000", "orthographic,20000", "Orthographic", double.NaN),
    ];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>PROJ says where cells lie; numpy follows the lines of sight over the facets of LDEM_4.</summary>
    [RequiresFact(Part.Ldem4, Part.Gdal, Part.GdalLibrary)]
    public void Map_HasThePixelsInWhichCellsAreSeen()
    {
        Succeed(["ldem", "synthesize", "--res", "1", "--body", "mercury", "--seed", "1", "--output-dir", _folder.Path, "--batch"]);
        foreach ((string name, string camera, string view, string map, _, _) in Frames)
        {
            string model = name == "other-body" ? _folder["MERCURY_DEM_1_SYNTHETIC.LBL"] : TestParts.Ldem4Label!;
            Succeed(Arguments(name, camera, map, [
                .. view.Split(' '), "--time", Time, "--ldem", model, "--layers-format", "npy",
                "--layers",
                "position,latitude,longitude,incidence,emission,mask,pixel-scale,radiance-factor" + (name[0] == 'o' ? "" : ",cell"),
            ]));
            Succeed(["verify", _folder[name]]);
        }

        string[] lines = ChildRun.Of(
            TestParts.Python!,
            [
                "-B", Path.Combine(TestParts.RepositoryRoot, "tests", "Msisf.Integration.Tests", "Maps", "maps.py"),
                Path.Combine(TestParts.RepositoryRoot, "clients", "python", "tests"), .. Frames.Select(frame => _folder[frame.Name]),
            ],
            _folder.Path).Succeeded().Output.TrimEnd().Split('\n');

        Assert.Equal(Frames.Length, lines.Length);
        foreach ((string line, (string name, _, _, _, string projection, double middle)) in lines.Zip(Frames))
        {
            string[] words = line.Split(' ');
            Assert.Equal((name, projection), (words[0], words[1]));
            Assert.True(double.IsNaN(middle) || middle == double.Parse(words[2], CultureInfo.InvariantCulture), line);
            Assert.True(int.Parse(words[3], CultureInfo.InvariantCulture) > 1000, line);
            Assert.True(words[5] == "ok", line);
        }
    }

    [RequiresTheory(Part.Ldem4, Part.GdalLibrary)]
    [InlineData("--position 10,200,300000", "orthographic,0.01", 2, "50000000 cells are the limit. Choose wider ones.")]
    [InlineData("--position 10,200,300000", "equirectangular,1000000", 2, "the middle of no cell of 1000000 m. Choose smaller ones.")]
    [InlineData("--position 0,200,300000", "polar-stereographic,500", 2, "ground on both sides of the equator")]
    [InlineData("--position 10,200,300000", "orthographic,0", 1, "polar-stereographic|orthographic and the width of a cell")]
    [InlineData("--position 10,200,300000", "mercator,100", 1, "polar-stereographic|orthographic and the width of a cell")]
    [InlineData("--position 10,200,300000 --renderer povray", "orthographic,100", 1, "which POV-Ray does not tell. Add --renderer native.")]
    public void WrongMap_IsOneLine(string view, string map, int exitCode, string problem)
    {
        CommandLineRun run = CommandLineRun.Of(
            Arguments("wrong", "width: 30\nheight: 20\nfield-of-view: 10\n", map, [
                .. view.Split(' '), "--time", Time, "--ldem", TestParts.Ldem4Label!]));

        Assert.True(exitCode == run.ExitCode, run.Error);
        Assert.Contains("--map", run.Error);
        Assert.Contains(problem, run.Error);
        Assert.DoesNotContain("   at ", run.Error);
        Assert.False(File.Exists(_folder["wrong/frame.png"]) || File.Exists(_folder["wrong/frame.map.tif"]));
    }

    /// <summary>A frame of the sky has no map, and says so; the files of others are made again when one is missing.</summary>
    [RequiresFact(Part.Ldem4, Part.GdalLibrary)]
    public void Files_BelongToTheFrame()
    {
        string[] look = ["--time", Time, "--ldem", TestParts.Ldem4Label!, "--position", "10,200,300000"];
        CommandLineRun sky = CommandLineRun.Of(Arguments("sky", "width: 30\nheight: 20\nfield-of-view: 10\n", "orthographic,100", [
            .. look, "--off-nadir", "150"]));
        string[] ground = Arguments("run", OffCentre, "orthographic,3000", look);
        Succeed(ground);
        byte[] written = File.ReadAllBytes(_folder["run/frame.map.tif"]);
        File.Delete(_folder["run/frame.map.tif"]);
        Assert.Equal(5, CommandLineRun.Of(["verify", _folder["run"]]).ExitCode);
        Succeed(ground);

        Assert.Equal(written, File.ReadAllBytes(_folder["run/frame.map.tif"]));
        Assert.Contains("frame shows no ground, so there is no map of it.", sky.Error);
        Assert.False(File.Exists(_folder["sky/frame.map.tif"]));
    }

    private string[] Arguments(string name, string camera, string map, string[] more) =>
    [
        .. more.Contains("povray") ? (string[])[] : ["--renderer", "native"],
        .. more, "--camera", _folder.Write($"{name}.yaml", camera), "--map", map, "--grid", "20", "--output-dir", _folder[name],
        "--output-name", "frame", "--batch",
    ];

    private static void Succeed(string[] arguments)
    {
        CommandLineRun run = CommandLineRun.Of(arguments);
        Assert.True(run.ExitCode == 0, run.Error);
    }
}
