using System.Globalization;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.CameraExport;

/// <summary>Camera models of scans: each file puts the point of each pixel into that pixel.</summary>
public sealed class ScanModelTests : IDisposable
{
    /// <summary>px: what is promised.</summary>
    private const double Tolerance = 1e-3;

    private const string Csm = "csm,isd,isd-body";

    private const string Tumbling = "{200,-900,1300,0.02,-0.05,0.08}";

    private const string Slow = "{20,-9,13,0.002,-0.004,0.003}";

    private const string OffCentre =
        "width: 40\nfocal-length: 6\npixel-pitch: [0.05, 0.06]\npixel-convention: opencv\nskew: 1.5\n";

    private const string LineScan = OffCentre + "height: 1\nprincipal-point: [23.5, 4.25]\nscan: {kind: line-scan, period: 0.05}\n";

    private const string Upwards =
        OffCentre + "height: 1\nprincipal-point: [23.5, 4.25]\nscan: {kind: line-scan, period: 0.05, order: up}\n";

    private const string OnAxis = OffCentre + "height: 1\nprincipal-point: [23.5, 0]\nscan: {kind: line-scan, period: 0.05}\n";

    private const string Framelets = OffCentre + "height: 14\nprincipal-point: [23.5, 4.25]\n";

    /// <summary>f of 120 px, as of the others, would be off by 0.2 px: a line-scan has one focal length for all rows.</summary>
    private const string Rolling =
        "width: 40\nheight: 30\nfocal-length: 120\npixel-pitch: [0.05, 0.06]\npixel-convention: opencv\nprincipal-point: [23.5, 12.25]\n";

    private const string Brown = "distortion: {model: opencv, k1: -0.1, k2: 0.02, k3: 0.01, p1: 0.002, p2: -0.001}\n";

    private const string Detector =
        "detector: {f-number: 4, exposure-time: 0.001, quantum-efficiency: 0.5, band: [400, 700], gain: 10, adc-bits: 10, seed: none}\n";

    /// <summary>A camera 100 km over the ground, whose rows move over it as fast as the charge of its four stages.</summary>
    private const string Tdi = "width: 40\nheight: 4\nfocal-length: 6\npixel-pitch: [0.05, 0.06]\npixel-convention: opencv\n"
        + "principal-point: [23.5, 1.25]\nscan: {kind: line-scan, period: 0.5, tdi: 4}\n"
        + Detector;

    private static readonly Scanned[] Scans =
    [
        new("tumbling", LineScan + Brown, "--lines 60 --jitter jitter.txt", Tumbling),
        new("upwards", Upwards, "--lines 60 --jitter jitter.txt", Tumbling),
        new("smooth", LineScan.Replace("0.05}", "0.5}", StringComparison.Ordinal)
            + "distortion: {model: owen, e2: 0.003, e5: 0.001, e6: -0.002}\n", "--lines 200 --jitter slow.txt", Slow) { MostNodes = 60 },
        new("radial", LineScan + "distortion: {model: radial, form: factor, k: [0.004, 0.0003]}\n", "--lines 30", Tumbling),
        new("polynomial", LineScan + "distortion: {model: polynomial, argument: radius, x: [0.01, 0.002, -0.003, 0.0005], "
            + "y: [-0.02, 0.001, 0.002]}\n", "--lines 30", Tumbling),
        new("along-row", LineScan + "distortion: {model: polynomial, argument: x, x: [0.01, 0.002, -0.003, 0.0005], "
            + "y: [-0.02, 0.001, 0.002]}\n", "--lines 30", Tumbling),
        new("wide", OnAxis.Replace("width: 40", "width: 300", StringComparison.Ordinal).Replace("23.5", "140", StringComparison.Ordinal)
            + "distortion: {model: radial, form: division, k: [0.002]}\n", "--lines 12", Tumbling),
        new("division", OnAxis + "distortion: {model: radial, form: division, k: [0.004]}\n", "--lines 30", Tumbling),
        new("three", LineScan, "--lines 3", Tumbling),
        new("one", LineScan, "--lines 1", Tumbling),
        new("tdi", Tdi, "--lines 40", "{0,0,1900,0,0,0}") { IsOverGround = true, HasDetector = true },
        new("framelets", Framelets + Brown + "scan: {kind: push-frame, period: 0.5}\n", "--framelets 5 --jitter jitter.txt", Tumbling),
        new("flipped", Framelets + "distortion: {model: radial, form: factor, k: [0.004]}\n"
            + "scan: {kind: push-frame, period: 0.5, order: up, flip: yes, framelet: [3, 8]}\n", "--framelets 5", Tumbling),
        new("shutter", Rolling + Detector[..^2] + ", shutter: rolling, line-time: 0.01}\n", "", Tumbling) { HasDetector = true },
        new("rolling", Rolling + "scan: {kind: rolling-shutter, period: 0.01}\n", "--jitter jitter.txt", Tumbling),
    ];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>
    /// Numpy projects by the published formulas, from the file alone. The layers of the frame "shutter" show one time; there numpy makes
    /// points along the rays of each row at its own time.
    /// </summary>
    [RequiresFact(Part.Ldem4, Part.Astropy, Part.CSpice)]
    public void EachScan_EachLens_PutsEachPointIntoItsPixel()
    {
        _folder.Write("jitter.txt", "roll 3 800 0\npitch 5 600 1.6\nyaw 2 400 0.3\n");
        _folder.Write("slow.txt", "roll 0.02 800 0\npitch 0.014 600 1.6\nyaw 0.01 400 0.3\n");
        foreach (Scanned scan in Scans)
        {
            Succeed(Arguments(scan, ["--layers-format", "npy", "--camera-model", scan.Name == "shutter" ? $"{Csm},opencv" : Csm]));
        }

        string[] lines = Project([.. Scans.Select(scan => scan.Name)]);

        Assert.Equal(3 * Scans.Length, lines.Length);
        Assert.All(lines, line =>
        {
            string[] words = line.Split(' ');
            Scanned scan = Scans.Single(scan => scan.Name == words[0]);
            Assert.True(int.Parse(words[2], CultureInfo.InvariantCulture) >= 40, line);
            Assert.True(double.Parse(words[3], CultureInfo.InvariantCulture) < Tolerance, line);
            Assert.InRange(int.Parse(words[4], CultureInfo.InvariantCulture), 25, scan.MostNodes);
            Assert.True(words[5] == "-", line);
        });
    }

    /// <summary>Whichever file has the states of the rows, the models have the same bytes.</summary>
    [RequiresFact(Part.Ldem4, Part.CSpice, Part.CFitsio)]
    public void Afterwards_FromArraysFitsOrMetaFile_SameBytes()
    {
        _folder.Write("jitter.txt", "roll 3 800 0\n");
        Scanned scan = Scans.Single(scan => scan.Name == "flipped");
        Succeed(Arguments(scan, ["--layers-format", "npy", "--camera-model", Csm]));
        string[] expected = Models("flipped");
        foreach ((string name, string[] more, string[] files) in ((string, string[], string[])[])
            [("npy", ["--layers-format", "npy"], ["frame.xml", "frame.rowstates.npy"]),
            ("fits", ["--layers-compression", "gzip"], ["frame.xml", "frame.fits"]),
            ("xml", ["--gridV", "1"], ["frame.xml"])])
        {
            Succeed(Arguments(scan with { Name = name }, more));
            string again = $"{name}-again";
            Directory.CreateDirectory(_folder[again]);
            foreach (string file in files)
            {
                File.Copy(_folder[$"{name}/{file}"], _folder[$"{again}/{file}"]);
            }

            CommandLineRun run = CommandLineRun.Of(["camera-model", _folder[$"{again}/frame.xml"], "--to", Csm]);

            Assert.True(run.ExitCode == 0, run.Error);
            Assert.Contains("nodes of its motion, ", run.Error);
            Assert.Equal(expected, Models(again));
        }
    }

    /// <summary>Rows that are too few, damaged, of another image, or read in an unknown way: one line, and no file.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("", "", "it has the states of 2 rows of 40, and all are needed", "--gridV 1.")]
    [InlineData("npy", "", "frame.rowstates.npy: it is damaged", "shorter than its head says")]
    [InlineData("head", "", "frame.rowstates.npy: it is damaged", "its head is not that of row states")]
    [InlineData("fits", "", "frame.fits: it is damaged", "shorter than its head says")]
    [InlineData("other", "", "belong to different images", "Make the image again.")]
    [InlineData("", " flip=\"yes\"", "did not write yet how framelets are read", "Make the image again.")]
    [InlineData("", "exposures=\"5\"|exposures=\"7\"", "7 exposures can't make 40 rows", "Name one (.xml).")]
    [InlineData("", "push-frame\"|whisk-broom\"", "the scan 'whisk-broom' is not known", "Name one (.xml).")]
    public void RowsThatAreMissing_AreOneLine(string file, string change, string problem, string remedy)
    {
        Scanned scan = Scans.Single(scan => scan.Name == "flipped");
        Succeed(Arguments(scan, ["--layers-format", "npy"]));
        string states = _folder["flipped/frame.rowstates.npy"];
        byte[] bytes = File.ReadAllBytes(states);
        switch (file)
        {
            case "npy":
                File.WriteAllBytes(states, bytes[..^1]);
                break;
            case "head":
                File.WriteAllBytes(states, File.ReadAllBytes(_folder["flipped/frame.position.npy"]));
                break;
            case "other":
                bytes[^1] ^= 1; // the last row is not one of the meta file's, so all before it too
                bytes[^(20 * 11 * sizeof(double) - 3)] ^= 64;
                Array.Reverse(bytes, bytes.Length - (40 * 11 * sizeof(double)), 40 * 11 * sizeof(double));
                File.WriteAllBytes(states, bytes);
                break;
            default:
                File.Delete(states);
                break;
        }

        if (file == "fits")
        {
            File.WriteAllBytes(_folder["flipped/frame.fits"], bytes[..100]);
        }

        string xml = _folder["flipped/frame.xml"];
        string[] parts = change.Split('|');
        string text = File.ReadAllText(xml);
        File.WriteAllText(xml, change.Length == 0 ? text : text.Replace(parts[0], parts.Skip(1).FirstOrDefault()));

        CommandLineRun run = CommandLineRun.Of(["camera-model", xml, "--to", "csm"]);

        Assert.True(run.ExitCode == 2, run.Error);
        Assert.Contains(problem, run.Error);
        Assert.Contains(remedy, run.Error);
        Assert.DoesNotContain("   at ", run.Error);
        Assert.False(File.Exists(_folder["flipped/frame.csm.json"]));
    }

    private string[] Models(string name) =>
        [.. ((string[])["csm", "isd", "isd-body"]).Select(model => File.ReadAllText(_folder[$"{name}/frame.{model}.json"]))];

    private string[] Project(string[] names) => ChildRun.Of(
        TestParts.Python!,
        [
            "-B", Path.Combine(TestParts.RepositoryRoot, "tests", "Msisf.Integration.Tests", "CameraExport", "project_scans.py"),
            .. names.Select(name => name == "shutter" ? $"{_folder[name]}:{Tumbling.Trim('{', '}')},0.01" : _folder[name]),
        ],
        _folder.Path).Succeeded().Output.TrimEnd().Split('\n');

    private string[] Arguments(Scanned scan, string[] more) =>
    [
        "--fixed-state", scan.IsOverGround ? "{55292.85,1.8374E6,0,0,0,0,0,1}" : "{55292.85,1.95E6,2E5,1E5,0.02,-0.03,0.3,0.9533}",
        "--normalize", "--motion", scan.Motion, "--camera", _folder.Write($"{scan.Name}.yaml", scan.Camera), "--renderer", "native",
        "--layers", "position", "--grid", "20", "--output-dir", _folder[scan.Name], "--output-name", "frame",
        "--ldem", TestParts.Ldem4Label!, "--batch", .. (scan.HasDetector ? (string[])[] : ["--reflectance", "lambert"]),
        .. scan.Options.Split(' ', StringSplitOptions.RemoveEmptyEntries)
            .Select(word => word.EndsWith(".txt", StringComparison.Ordinal) ? _folder[word] : word),
        .. more,
    ];

    private static void Succeed(string[] arguments)
    {
        CommandLineRun run = CommandLineRun.Of(arguments);
        Assert.True(run.ExitCode == 0, run.Error);
    }

    private sealed record Scanned(string Name, string Camera, string Options, string Motion)
    {
        public bool IsOverGround { get; init; }

        public bool HasDetector { get; init; }

        public int MostNodes { get; init; } = 200;
    }
}
