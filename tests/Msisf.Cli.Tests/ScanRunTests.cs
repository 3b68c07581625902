using System.Globalization;
using System.Xml.Linq;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Scanned images as a user makes them, against still images of each of their rows.</summary>
public sealed class ScanRunTests(SmallMoon moon) : IClassFixture<SmallMoon>, IDisposable
{
    private const string Line = "focal-length-px: [90, 95]\nwidth: 40\nheight: 1\nprincipal-point: [15, 1.2]\nskew: 0.5\n"
        + "distortion:\n  model: opencv\n  k1: -0.2\nscan:\n  kind: line-scan\n  period: 0.6\n";

    private const string Orbit = "--kepler-set {1.86E6,0.02,0.7,1.1,0.9,2.0} --epoch 55289 --time 55289.003 --attitude {0,0.1,0,1} "
        + "--normalize "
        + "--attitude-frame lvlh --attitude-transition {0.002,0.005,-0.003}";

    private const string Common = "--renderer native --reflectance lommel-seeliger --ephemeris builtin --grid 8 --batch";

    /// <summary>bytes.</summary>
    private const int HeadOfNpy = 128;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>
    /// Each row is the image of a camera of one row in the state that msis states writes. Its time is rounded to 0.6 microseconds there, so
    /// that some levels may differ by one.
    /// </summary>
    [Theory]
    [InlineData("")]
    [InlineData("pitch 0.4 9000 1\nroll 0.1 9000 0\n")]
    public void Run_LineScanOnAnOrbit_IsAStillImageOfEachLine(string jitter)
    {
        string[] scan =
        [
            .. Orbit.Split(' '), "--camera", _folder.Write("line.yaml", Line), "--lines", "24",
            .. jitter.Length > 0 ? ["--jitter", _folder.Write("jitter.txt", jitter)] : (string[])[],
        ];
        Draw("scan", scan);
        string states = _folder["states.tab"];
        CommandLineRun run = CommandLineRun.Of(
            ["states", .. scan, "--renderer", "native", "--to", states, .. moon.Options, "--ephemeris", "builtin"]);
        Assert.True(run.ExitCode == 0, run.Error);
        string stillCamera = Line[..Line.IndexOf("scan", StringComparison.Ordinal)];
        Draw("still", "--batch-file", states, "--camera", _folder.Write("still.yaml", stillCamera), "--output-name", "{step:00}");

        PngPixels scanned = PngPixels.Read(_folder["scan/MoonSurfIllumSim_step_00001.png"]);
        int differing = 0;
        for (int y = 0; y < 24; y++)
        {
            PngPixels row = PngPixels.Read(_folder[string.Create(CultureInfo.InvariantCulture, $"still/{y + 1:00}.png")]);
            for (int x = 0; x < 40; x++)
            {
                int difference = Math.Abs(scanned[x, y, 0] - row[x, 0, 0]);
                Assert.InRange(difference, 0, 1);
                differing += difference;
            }
        }

        Assert.InRange(differing, 0, 3);
        string[] second = File.ReadAllLines(states).Where(line => !line.StartsWith('#')).ToArray()[7].Split(' ');
        XElement rowOfMeta = MetaFileXml.Parse(File.ReadAllText(_folder["scan/MoonSurfIllumSim_step_00001.xml"]))
            .Descendants("Scan").Single().Elements("Row").First();
        Assert.Equal(["8", "16", "24"], rowOfMeta.Parent!.Elements("Row").Select(element => element.Attribute("v")!.Value));
        string[] names = ["mjd", "x", "y", "z", "qx", "qy", "qz", "q0"];
        foreach ((string name, string text) in names.Zip(second))
        {
            Assert.Equal(Number(text), Number(rowOfMeta.Attribute(name)!.Value), Rounding.OfPlaces * Math.Max(1.0, Math.Abs(Number(text))));
        }

        Assert.Equal(7 * 0.6, Number(rowOfMeta.Attribute("seconds")!.Value), Rounding.OfChains);
    }

    /// <summary>A scan whose states are all the same is the frame of as many equal rows; one along samples is that along the
    /// orbit.</summary>
    [Fact]
    public void Run_SameStates_AreTheSameImage()
    {
        string camera = _folder.Write("line.yaml", Line);
        Draw("orbit", [.. Orbit.Split(' '), "--camera", camera, "--lines", "16"]);
        string samples = _folder["samples.tab"];
        CommandLineRun run = CommandLineRun.Of(
            [
                "states", .. Orbit.Replace("--time 55289.003", "--time-interval [55289.003:1s:55289.0032]", StringComparison.Ordinal)
                    .Split(' '),
                "--to", samples, .. moon.Options, "--ephemeris", "builtin",
            ]);
        Assert.True(run.ExitCode == 0, run.Error);
        Draw("samples", "--trajectory", samples, "--trajectory-positions", "lagrange", "--camera", camera, "--lines", "16");
        PngPixels expected = PngPixels.Read(_folder["orbit/MoonSurfIllumSim_step_00001.png"]);
        PngPixels sampled = PngPixels.Read(_folder["samples/MoonSurfIllumSim_step_00001.png"]);
        int differing = 0;
        for (int pixel = 0; pixel < 16 * 40; pixel++)
        {
            differing += expected[pixel % 40, pixel / 40, 0] == sampled[pixel % 40, pixel / 40, 0] ? 0 : 1;
        }

        Assert.InRange(differing, 0, 16);
        CommandLineRun late = CommandLineRun.Of(
        [
            "--trajectory", samples, "--camera", camera, "--lines", "60", .. Common.Split(' '), .. moon.Options,
            "--output-dir", _folder["late"],
        ]);
        Assert.Equal(2, late.ExitCode);
        Assert.Contains("its states reach from", late.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(_folder["late"]));

        CommandLineRun povRay = CommandLineRun.Of(
        [
            "--trajectory", samples, "--lines", "4", "--camera",
            _folder.Write("pinhole.yaml", "field-of-view: 9\nwidth: 9\nheight: 1\nscan:\n  kind: line-scan\n  period: 0.6\n"),
        ]);
        Assert.Equal(1, povRay.ExitCode);
        Assert.Contains("which POV-Ray can't draw. Add --renderer native.", povRay.Error, StringComparison.Ordinal);
    }

    /// <summary>
    /// A large image is drawn in strips, and written so with its layers: its first rows are those of one that is drawn as a whole (a minute
    /// in its long form).
    /// </summary>
    [Fact]
    public void Run_LargeScan_IsDrawnInStrips()
    {
        // 2^23 px are drawn as a whole: 512 lines of this width. A strip has 16; the everyday form sees the Moon in a few columns.
        int lines = TestLength.IsLong ? 512 : 40;
        string wide = TestLength.IsLong ? "field-of-view: 20" : "field-of-view: 150";
        string camera = _folder.Write("wide.yaml", $"{wide}\nwidth: 16384\nheight: 1\nscan:\n  kind: line-scan\n  period: 0.05\n");
        string[] far =
        [
            "--fixed-state", "{55289,9E7,0,0,0,0,0,1}", "--motion", "{0,4E6,4E6,0,0,0}", "--camera", camera, "--layers", "depth",
            "--layers-precision", "single", "--layers-format", "npy",
        ];
        Draw("whole", [.. far, "--lines", lines.ToString(CultureInfo.InvariantCulture)]);
        Draw("strips", [.. far, "--lines", "513"]);
        byte[] expected = File.ReadAllBytes(_folder["whole/MoonSurfIllumSim_step_00001.depth.npy"]);
        byte[] written = File.ReadAllBytes(_folder["strips/MoonSurfIllumSim_step_00001.depth.npy"]);
        Assert.Equal(HeadOfNpy + (513 * 16384 * sizeof(float)), written.Length);
        Assert.True(written.AsSpan(HeadOfNpy, expected.Length - HeadOfNpy).SequenceEqual(expected.AsSpan(HeadOfNpy)), "depth");

        PngPixels whole = PngPixels.Read(_folder["whole/MoonSurfIllumSim_step_00001.png"]);
        PngPixels strips = PngPixels.Read(_folder["strips/MoonSurfIllumSim_step_00001.png"]);
        int lit = 0;
        for (int pixel = 0; pixel < lines * 16384; pixel++)
        {
            (int x, int y) = (pixel % 16384, pixel / 16384);
            Assert.True(whole[x, y, 0] == strips[x, y, 0], $"pixel {x}, {y}");
            lit += whole[x, y, 0] > 0 ? 1 : 0;
        }

        Assert.True(lit > lines / 2, $"{lit} lit pixels");
    }

    /// <summary>What the ground does over the detector is compared with what the charge does: it moves down by a row in 0.13 s.</summary>
    [Theory]
    [InlineData("0.13", "down", "", 0)]
    [InlineData("0.13", "down", "--dry-run", 0)]
    [InlineData("0.6", "down", "", 2)]
    [InlineData("0.13", "up", "", 2)]
    public void Run_Tdi_IsDrawnAlongTheImageOnly(string period, string direction, string option, int exitCode)
    {
        string camera = _folder.Write(
            "tdi.yaml",
            "focal-length: 10\npixel-pitch: 0.02\nwidth: 40\nheight: 4\ndetector:\n  f-number: 4\n  exposure-time: 0.001\n"
                + "  band: [500, 600]\n  quantum-efficiency: 0.5\n  gain: 10\n  adc-bits: 12\nscan:\n  kind: line-scan\n"
                + $"  period: {period}\n  tdi: 4\n  tdi-direction: {direction}\n");
        CommandLineRun run = CommandLineRun.Of(
        [
            "--kepler-set", "{1.8374E6,0,0,0.3,1.5,0.5}", "--epoch", "55289", "--time", "55289", "--camera", camera, "--lines", "8",
            .. Common.Split(' '), .. moon.Options, "--output-dir", _folder["tdi"],
            .. option.Split(' ', StringSplitOptions.RemoveEmptyEntries),
        ]);

        Assert.True(exitCode == run.ExitCode, run.Error);
        Assert.Equal(exitCode == 0 && option.Length == 0, Directory.Exists(_folder["tdi"]));
        if (exitCode != 0)
        {
            Assert.Contains(
                "TDI along the wrong axis or at the wrong speed: from line to line the image",
                run.Error, StringComparison.Ordinal);
        }
    }

    /// <summary>
    /// A frame under a rolling shutter is the scan by rows from its first row's time on: neither rounds that time, and its state, alike.
    /// </summary>
    [Fact]
    public void Run_RollingShutter_ExposesEachRowAtItsOwnTime()
    {
        const string Camera = "focal-length: 10\npixel-pitch: 0.02\nwidth: 40\nheight: 31\nprincipal-point: [18, 12]\ndetector:\n"
            + "  f-number: 4\n  exposure-time: 0.02\n  band: [500, 600]\n  quantum-efficiency: 0.5\n  gain: 8000\n  adc-bits: 12\n"
            + "  psf: gaussian\n  psf-sigma: 0.7\n  seed: none\n";
        const string Motion = "{200,4000,-3000,0.02,0.05,-0.03}";
        string shutter = _folder.Write("shutter.yaml", $"{Camera}  shutter: rolling\n  line-time: 0.2\n");
        string scan = _folder.Write("scan.yaml", $"{Camera}  shutter: global\nscan:\n  kind: rolling-shutter\n  period: 0.2\n");
        Draw("frame", "--fixed-state", "{55289,1.9E6,1E5,0,0,0,0,1}", "--motion", Motion, "--camera", shutter);

        // 15 rows of 0.2 s before the frame's time: 3 s. The turn about a fixed axis by quaternions.
        double[] axis = [0.02, 0.05, -0.03];
        double rate = Math.Sqrt(axis.Sum(part => part * part));
        double sine = Math.Sin(-1.5 * rate) / rate;
        double[] first = [1.9e6 - 600, 1e5 - 12000, 9000, axis[0] * sine, axis[1] * sine, axis[2] * sine, Math.Cos(1.5 * rate)];
        string time = (55289.0 - (3.0 / 86400.0)).ToString("R", CultureInfo.InvariantCulture);
        string state = $"{{{time},{string.Join(',', first.Select(number => number.ToString("R", CultureInfo.InvariantCulture)))}}}";
        Draw("rows", "--fixed-state", state, "--motion", Motion, "--camera", scan);
        Draw("still", "--fixed-state", "{55289,1.9E6,1E5,0,0,0,0,1}", "--motion", Motion, "--camera", _folder.Write(
            "still.yaml", $"{Camera}  shutter: global\n"));

        PngPixels frame = PngPixels.Read(_folder["frame/MoonSurfIllumSim_step_00001.png"]);
        PngPixels rows = PngPixels.Read(_folder["rows/MoonSurfIllumSim_step_00001.png"]);
        PngPixels still = PngPixels.Read(_folder["still/MoonSurfIllumSim_step_00001.png"]);
        (int others, int moved) = (0, 0);
        for (int pixel = 0; pixel < 40 * 31; pixel++)
        {
            (int x, int y) = (pixel % 40, pixel / 40);
            Assert.InRange(frame[x, y, 0] - rows[x, y, 0], -16, 16); // a DN is 16 levels of the file
            others += frame[x, y, 0] == rows[x, y, 0] ? 0 : 1;
            moved += frame[x, y, 0] == still[x, y, 0] ? 0 : 1;
        }

        Assert.InRange(others, 0, 12);
        Assert.True(moved > 600, $"{moved} pixels moved");
    }

    [Fact]
    public void Run_LinesApart_AreWarnedOf()
    {
        CommandLineRun run = CommandLineRun.Of(
        [
            .. Orbit.Split(' '), "--camera", _folder.Write("line.yaml", Line), "--lines", "3", "--scan-period", "5", .. Common.Split(' '),
            .. moon.Options, "--output-dir", _folder["apart"],
        ]);

        Assert.Equal(0, run.ExitCode);
        Assert.Contains("the lines do not overlap: the ground moves by ", run.Error, StringComparison.Ordinal);
    }

    private void Draw(string folder, params string[] words) => moon.Draw(_folder[folder], [.. words, .. Common.Split(' ')]);

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
