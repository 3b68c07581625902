using System.Globalization;
using System.Xml;
using System.Xml.Linq;
using MathNet.Numerics.LinearAlgebra;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Runs with several cameras on one body, against runs with one camera each.</summary>
public sealed class RigRunTests : IClassFixture<SmallMoon>, IDisposable
{
    private const string Left =
        "  left:\n    camera: lens.yaml\n    quaternion: [0.02, -0.3, 0.1, 0.9484724561103501]\n    offset: [3, -250, 40]\n";

    private const string Plain = "  plain:\n    fov: 25\n    width: 30\n    height: 20\n    quaternion: [0, 0, 0, 1]\n";

    private const string Shutter = "  shutter:\n    camera: shutter.yaml\n    quaternion: [0, 0, 0.28, 0.96]\n    offset: [0, 900, 0]\n";

    private const string Orbit = "--kepler-set {1.86E6,0.02,0.7,1.1,0.9,2.0} --epoch 55289 --attitude {0,0.1,0,1} --normalize "
        + "--attitude-frame lvlh --attitude-transition {0.002,0.005,-0.003}";

    private const string Common = "--renderer native --reflectance lommel-seeliger --ephemeris builtin --grid 8 --batch --layers "
        + "depth,cell,normal --layers-format npy --shading smooth --sun disc";

    private readonly TemporaryFolder _folder = new();
    private readonly SmallMoon _moon;

    public RigRunTests(SmallMoon moon)
    {
        _moon = moon;
        _folder.Write(
            "lens.yaml",
            "focal-length-px: [90, 95]\nwidth: 40\nheight: 24\nprincipal-point: [15, 17]\nskew: 0.5\ndistortion:\n  model: opencv\n"
                + "  k1: -0.2\n");
        _folder.Write(
            "shutter.yaml",
            "width: 32\nheight: 16\nfocal-length: 0.4\npixel-pitch: 0.008\ndetector:\n  f-number: 40\n  exposure-time: 0.4\n"
                + "  band: [500, 600]\n  quantum-efficiency: 0.5\n  gain: 200\n  adc-bits: 12\n  fits: no\n  seed: 3\n  shutter: global\n");
        _folder.Write(
            "line.yaml",
            "focal-length-px: 90\nwidth: 40\nheight: 1\nprincipal-point: [15, 1.2]\nscan:\n  kind: line-scan\n  period: 0.6\n");
    }

    public void Dispose() => _folder.Dispose();

    /// <summary>Image, layers and truth of each camera are those of a run with that camera in the pose that the mounting means.</summary>
    [Theory]
    [InlineData("--batch-file FILE:body.tab")]
    [InlineData(Orbit + " --times {55289.003,55289.01}")]
    public void Run_Rig_IsARunWithEachCamera(string states)
    {
        _folder.Write(
            "body.tab",
            "55289 1.9E6 1E5 5E4 0.1 0.02 -0.3 0.9484724561103501 1600 90 -20 0.01 -0.02 0.005\n"
                + "55289.004 1.88E6 -2E5 7E4 0.1 0.02 -0.3 0.9484724561103501 1500 90 -20 0.03 -0.02 0.1\n");
        string[] words = [.. states.Split(' ')
            .Select(word => word.StartsWith("FILE:", StringComparison.Ordinal) ? _folder[word[5..]] : word)];
        Draw("rig", [.. words, "--rig", _folder.Write("rig.yaml", $"cameras:\n{Left}{Plain}{Shutter}"), "--output-name", "{camera}{step}"]);
        Draw("body", [.. words, "--fov", "25", "--width", "30", "--height", "20", "--output-name", "plain{step}"]);
        Assert.Equal(
            ["left1", "left2", "plain1", "plain2", "shutter1", "shutter2"],
            Directory.GetFiles(_folder["rig"], "*.png").Select(path => Path.GetFileNameWithoutExtension(path)).Order());

        foreach (int step in (int[])[1, 2])
        {
            CompareFiles("rig", "body", $"plain{step}"); // a mounting that changes nothing: no digit is another
            foreach (string camera in (string[])["left", "shutter"])
            {
                XElement meta = Meta(camera, step);
                RequirePose(Meta("plain", step), meta, meta.Descendants("Mounting").Single());
                RequireRelative(meta, Meta("plain", step), "plain");
                string command = meta.Descendants("CommandLine").Single().Value;
                CommandLineRun single = CommandLineRun.Of(
                [
                    .. command.Replace("'", string.Empty, StringComparison.Ordinal).Split(' ')
                        .Select(word => word.Contains(".yaml#", StringComparison.Ordinal) ? _folder[word] : word),
                    .. _moon.Options[..2], "--batch", "--output-dir", _folder["single"], "--output-name", $"{camera}{step}",
                ]);
                Assert.True(single.ExitCode == 0, single.Error);
                CompareFiles("rig", "single", $"{camera}{step}");
            }
        }
    }

    /// <summary>A scan on a rig: with a mounting that changes nothing the scan without a rig; else that of the camera's own
    /// samples.</summary>
    [Fact]
    public void Run_RigWithAScan_IsTheScanOfTheCamerasOwnMotion()
    {
        const string Mounting = "    quaternion: [0.02, -0.1, 0.1, 0.9897474425326898]\n    offset: [30, -2500, 400]\n";
        string line = "    camera: line.yaml\n    lines: 20\n";
        string rig = _folder.Write(
            "scans.yaml",
            $"cameras:\n  own:\n{line}    quaternion: [0, 0, 0, 1]\n  turned:\n{line}"
                + $"{Mounting}{Plain}");
        string jitter = _folder.Write("jitter.txt", "pitch 0.4 9000 1\nroll 0.1 9000 0\n");
        string[] orbit = [.. Orbit.Split(' '), "--time", "55289.003", "--jitter", jitter];
        Draw("rig", [.. orbit, "--rig", rig, "--output-name", "{camera}"]);
        Draw("own", [.. orbit, "--camera", _folder["line.yaml"], "--lines", "20", "--output-name", "own"]);
        CompareFiles("rig", "own", "own");

        string states = _folder["{camera}.tab"];
        CommandLineRun export = CommandLineRun.Of(
        [
            "states", .. orbit, "--rig", rig, "--renderer", "native", "--to", states, .. _moon.Options, "--ephemeris",
            "builtin",
        ]);
        Assert.True(export.ExitCode == 0, export.Error);
        double[][] body = Rows("own.tab");
        double[][] camera = Rows("turned.tab");
        Assert.Equal(20, camera.Length);
        Matrix<double> mounted = Rotation([0.02, -0.1, 0.1, 0.9897474425326898]);
        foreach ((double[] of, double[] turned) in body.Zip(camera))
        {
            Matrix<double> moonFromBody = Rotation(of[4..8]);
            Vector<double> position = Vector<double>.Build.DenseOfArray(of[1..4])
                + (moonFromBody * Vector<double>.Build.Dense([30.0, -2500.0, 400.0]));
            Assert.True((position - Vector<double>.Build.DenseOfArray(turned[1..4])).L2Norm() < Rounding.OfConvertedPlaces);
            Assert.True(((moonFromBody * mounted) - Rotation(turned[4..8])).FrobeniusNorm() < Rounding.OfTurns);
        }

        Draw("stills", "--batch-file", _folder["turned.tab"], "--camera", _folder.Write(
            "row.yaml", "focal-length-px: 90\nwidth: 40\nheight: 1\nprincipal-point: [15, 1.2]\n"), "--output-name", "{step:00}");
        PngPixels scan = PngPixels.Read(_folder["rig/turned.png"]);
        for (int pixel = 0; pixel < 20 * 40; pixel++)
        {
            (int x, int y) = (pixel % 40, pixel / 40);
            PngPixels row = PngPixels.Read(_folder[string.Create(CultureInfo.InvariantCulture, $"stills/{y + 1:00}.png")]);
            Assert.InRange(scan[x, y, 0] - row[x, 0, 0], -1, 1);
        }
    }

    /// <summary>COLMAP gets one model of all cameras, in which no identity and no name of an image is there twice.</summary>
    [Fact]
    public void States_RigForColmap_IsOneModel()
    {
        string lens = Left.Replace("lens.yaml", "straight.yaml", StringComparison.Ordinal);
        _folder.Write("straight.yaml", "focal-length-px: [90, 95]\nwidth: 40\nheight: 24\ndistortion:\n  model: opencv\n  k1: -0.2\n");
        string rig = _folder.Write("rig.yaml", $"cameras:\n{lens}{Plain}");
        string[] words =
        [
            "states", "--format", "colmap", .. Orbit.Split(' '), "--time-interval", "[55289:0.001:55289.003]", "--rig", rig, "--renderer",
            "native", .. _moon.Options, "--ephemeris", "builtin",
        ];
        CommandLineRun single = CommandLineRun.Of([.. words, "--to", _folder["{camera}"]]);
        Assert.Equal(1, single.ExitCode);
        Assert.Contains("Give --to a folder without {camera}.", single.Error, StringComparison.Ordinal);
        CommandLineRun run = CommandLineRun.Of([.. words, "--to", _folder["model"]]);
        Assert.True(run.ExitCode == 0, run.Error);
        string[][] Read(string name) =>
            [.. File.ReadLines(_folder[$"model/{name}"]).Where(line => line.Length > 0 && line[0] != '#').Select(line => line.Split(' '))];
        string[][] cameras = Read("cameras.txt");
        string[][] images = Read("images.txt");

        Assert.Equal([("1", "OPENCV", "40"), ("2", "PINHOLE", "30")], cameras.Select(line => (line[0], line[1], line[2])));
        Assert.Equal(Enumerable.Range(1, images.Length).Select(number => $"{number}"), images.Select(line => line[0]));
        Assert.Equal(images.Length, images.Select(line => line[9]).Distinct().Count());
        Assert.Equal(2, images.GroupBy(line => line[8]).Count(group => group.Count() == images.Length / 2));

        // Both see the Moon's centre from places 250 m apart, but for rounding: of the mounting's offset [3, -250, 40].
        double[] Centre(string camera) => [.. images.First(line => line[8] == camera)[5..8]
            .Select(number => double.Parse(number, CultureInfo.InvariantCulture))];
        double Distance(string camera) => Math.Sqrt(Centre(camera).Sum(part => part * part));
        Assert.InRange(Math.Abs(Distance("1") - Distance("2")), 1e-3, 254.0);
    }

    /// <summary>A part of a rig's run is what the whole run makes, a missing image is made again, and pieces make the same.</summary>
    [Fact]
    public void Run_RigInParts_IsTheWholeRun()
    {
        string rig = _folder.Write("rig.yaml", $"cameras:\n{Left}{Plain}");
        string[] words = [.. Orbit.Split(' '), "--time-interval", "[55289:0.001:55289.003]", "--rig", rig];
        Draw("whole", words);
        Draw("parts", [.. words, "--frames", "2:3"]);
        Assert.Equal(4, Directory.GetFiles(_folder["parts"], "*.png").Length);
        File.Delete(_folder["parts/MoonSurfIllumSim_step_00002_left.png"]);
        CommandLineRun status = CommandLineRun.Of(["status", _folder["parts"]]);
        Assert.Equal(5, status.ExitCode);
        Assert.Contains("2\tMoonSurfIllumSim_step_00002_left\t", status.Output, StringComparison.Ordinal);
        CommandLineRun left = CommandLineRun.Of(["status", _folder["parts"], "--print-frames"]);
        Assert.Equal("1:2,4", left.Output.Trim());
        Draw("parts", words);
        string script = _folder["pieces.sh"];
        CommandLineRun convert = CommandLineRun.Of(
        [
            "batchconvert", "--format", "sh", "--pieces", "2", "--script", script, .. words, .. Common.Split(' '), .. _moon.Options,
            "--output-dir", _folder["pieces"],
        ]);
        Assert.True(convert.ExitCode == 0, convert.Error);
        Assert.Contains("1:2", File.ReadAllText(script), StringComparison.Ordinal);
        Draw("pieces", "--batch-file", $"{script}.states.tab", "--rig", rig);
        foreach (string path in Directory.GetFiles(_folder["whole"], "*_step_*"))
        {
            string name = Path.GetFileName(path);
            Assert.True(File.ReadAllBytes(path).AsSpan().SequenceEqual(File.ReadAllBytes(_folder[$"parts/{name}"])), name);
            Assert.True(File.ReadAllBytes(path).AsSpan().SequenceEqual(File.ReadAllBytes(_folder[$"pieces/{name}"])), name);
        }

        CommandLineRun dry = CommandLineRun.Of(
            [
                .. words, "--renderer", "native", .. _moon.Options, "--ephemeris", "builtin", "--dry-run",
                "--format", "csv",
            ]);
        Assert.True(dry.ExitCode == 0, dry.Error);
        string[] rows = dry.Output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.StartsWith("step,camera,utc,", rows[0], StringComparison.Ordinal);
        Assert.Equal(["1,left", "1,plain", "2,left", "2,plain"], rows[1..5].Select(row => row[..row.IndexOf(',', 2)]));
    }

    private void Draw(string folder, params string[] words) => _moon.Draw(_folder[folder], [.. words, .. Common.Split(' ')]);

    /// <summary>Valid by the grammar in the file itself.</summary>
    private XElement Meta(string camera, int step)
    {
        XmlReaderSettings settings = new() { DtdProcessing = DtdProcessing.Parse, ValidationType = ValidationType.DTD };
        using XmlReader reader = XmlReader.Create(_folder[$"rig/{camera}{step}.xml"], settings);
        return XDocument.Load(reader).Root!;
    }

    private double[][] Rows(string file) =>
        [.. File.ReadLines(_folder[file]).Where(line => !line.StartsWith('#')).Select(line => line.Split(' ').Select(Number).ToArray())];

    /// <summary>Image and layers have the same bytes; the meta files differ in what only a rig has.</summary>
    private void CompareFiles(string folder, string other, string stem)
    {
        foreach (string end in (string[])[".png", ".depth.npy", ".cell.npy", ".normal.npy"])
        {
            Assert.True(
                File.ReadAllBytes(_folder[$"{folder}/{stem}{end}"]).AsSpan()
                    .SequenceEqual(File.ReadAllBytes(_folder[$"{other}/{stem}{end}"])),
                stem + end);
        }

        (XDocument one, XDocument two) = (Parsed(folder), Parsed(other));
        one.Descendants("Rig").Remove();
        one.Descendants("Input").Where(input => input.Attribute("kind")!.Value == "rig").Remove();
        Assert.Equal(Lines(two), Lines(one));

        XDocument Parsed(string of) => MetaFileXml.Parse(File.ReadAllText(_folder[$"{of}/{stem}.xml"]));

        static IEnumerable<string> Lines(XDocument meta) =>
            meta.Root!.ToString().Split('\n').Select(line => line.Trim()).Where(line => line.Length > 0);
    }

    /// <summary>The pose of a camera is that of the body (its mounting changes nothing) with the mounting, by matrices.</summary>
    private static void RequirePose(XElement body, XElement camera, XElement mounting)
    {
        Matrix<double> moonFromBody = Rotation(Numbers(body.Descendants("CameraOrientation").Single().Element("Quaternion")!));
        Matrix<double> moonFromCamera = Rotation(Numbers(camera.Descendants("CameraOrientation").Single().Element("Quaternion")!));
        Vector<double> position = Vector<double>.Build.Dense(Numbers(body.Descendants("CameraPosition").Single().Element("Vector3D")!))
            + (moonFromBody * Vector<double>.Build.Dense(Numbers(mounting.Element("Vector3D")!)));
        Assert.True(
            ((moonFromBody * Rotation(Numbers(mounting.Element("Quaternion")!))) - moonFromCamera).FrobeniusNorm() < Rounding.OfTurns);
        Assert.True(
            (position - Vector<double>.Build.Dense(Numbers(camera.Descendants("CameraPosition").Single().Element("Vector3D")!))).L2Norm()
                < 1e-8);
    }

    /// <summary>Where another camera is, in this one's axes, from the poses of both.</summary>
    private static void RequireRelative(XElement camera, XElement other, string name)
    {
        Matrix<double> cameraFromMoon =
            Rotation(Numbers(camera.Descendants("CameraOrientation").Single().Element("Quaternion")!)).Transpose();
        XElement relative = camera.Descendants("OtherCamera").Single(element => element.Attribute("name")!.Value == name);
        Vector<double> expected = cameraFromMoon * Vector<double>.Build.Dense(
        [
            .. Numbers(other.Descendants("CameraPosition").Single().Element("Vector3D")!)
                .Zip(Numbers(camera.Descendants("CameraPosition").Single().Element("Vector3D")!), (of, from) => of - from),
        ]);
        Assert.True((expected - Vector<double>.Build.Dense(Numbers(relative.Element("Vector3D")!))).L2Norm() < Rounding.OfConvertedPlaces);
        Matrix<double> moonFromOther = Rotation(Numbers(other.Descendants("CameraOrientation").Single().Element("Quaternion")!));
        Assert.True(
            ((cameraFromMoon * moonFromOther) - Rotation(Numbers(relative.Element("Quaternion")!))).FrobeniusNorm() < Rounding.OfTurns);
    }

    /// <summary>The matrix of a quaternion, scalar last.</summary>
    private static Matrix<double> Rotation(double[] q)
    {
        (double x, double y, double z, double w) = (q[0], q[1], q[2], q[3]);
        return Matrix<double>.Build.DenseOfArray(new[,]
        {
            { (w * w) + (x * x) - (y * y) - (z * z), 2 * ((x * y) - (w * z)), 2 * ((x * z) + (w * y)) },
            { 2 * ((x * y) + (w * z)), (w * w) - (x * x) + (y * y) - (z * z), 2 * ((y * z) - (w * x)) },
            { 2 * ((x * z) - (w * y)), 2 * ((y * z) + (w * x)), (w * w) - (x * x) - (y * y) + (z * z) },
        });
    }

    private static double[] Numbers(XElement element) => element.Name.LocalName == "Quaternion"
        ? [.. new[] { "x", "y", "z", "r" }.Select(name => Number(element.Attribute(name)!.Value))]
        : [.. new[] { "x", "y", "z" }.Select(name => Number(element.Attribute(name)!.Value))];

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
