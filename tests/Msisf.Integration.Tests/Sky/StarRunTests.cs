using System.Globalization;
using System.Xml.Linq;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Sky;

/// <summary>Runs with stars: where they are against ERFA (star_pixels.py), and what the files say.</summary>
public sealed class StarRunTests : IDisposable
{
    /// <summary>px: the meta file's numbers have 15 digits; real differences are a thousand times as large.</summary>
    private const double SamePixel = 1e-5;

    /// <summary>px: CSPICE's aberration is without special relativity, 0.5 mas, which is 2e-6 px here.</summary>
    private const double SamePixelAsStelab = 1e-4;

    /// <summary>Part of the electrons of a star: trapezoids of 0.001 nm against the program's own rule.</summary>
    private const double SameElectrons = 1e-5;

    private const string Lens = """
        width: 900
        height: 700
        field-of-view: 50
        principal-point: [500.2, 310.7]
        distortion: {model: brown-conrady, k1: -0.1, k2: 0.02, p1: 0.001, p2: -0.0007}
        """;

    private const string Detector = """

        detector: {f-number: 1.4, band: [420, 700], transmission: 0.8, quantum-efficiency: 0.5, exposure-time: 0.2, gain: 4,
                   adc-bits: 12, psf: gaussian, psf-sigma: 0.7}
        """;

    private const string Oem = """
        CCSDS_OEM_VERS = 2.0
        CREATION_DATE = 2026-01-01T00:00:00
        ORIGINATOR = TEST
        META_START
        OBJECT_NAME = TEST
        OBJECT_ID = 2026-001A
        CENTER_NAME = MOON
        REF_FRAME = EME2000
        TIME_SYSTEM = TDB
        START_TIME = 2010-04-06T20:00:00
        STOP_TIME = 2010-04-06T21:00:00
        META_STOP
        2010-04-06T20:00:00 20000 -24000 18000 0.9 1.1 0.4
        2010-04-06T21:00:00 23240 -20040 19440 0.9 1.1 0.4

        """;

    private readonly TemporaryFolder _folder = new();

    public StarRunTests()
    {
        _folder.Write("lens.yaml", Lens);
        _folder.Write("detector.yaml", "focal-length: 6\npixel-pitch: 0.0055\nwidth: 400\nheight: 300" + Detector);
        _folder.Write("path.oem", Oem);
    }

    public void Dispose() => _folder.Dispose();

    /// <summary>
    /// Some 2 000 stars, in the long form 10 000, through a pinhole and a lens off its centre, with each engine and each kind of
    /// aberration.
    /// </summary>
    [RequiresFact(Part.Ldem4, Part.CSpice, Part.Astropy)]
    public void Run_Stars_StandWhereErfaAndCSpiceHaveThem()
    {
        int times = TestLength.Of(1, 6);
        string[] pinhole = ["--fov", "60", "--width", "700", "--height", "600"];
        string[] place = ["--position", "10,20,1500000", "--look-at", "horizon:90"];
        string[] path = ["--oem", _folder["path.oem"], "--attitude", "{0.36,-0.2,0.54,0.74}", "--attitude-frame", "j2000", "--normalize"];
        double length = Math.Sqrt((0.36 * 0.36) + (0.2 * 0.2) + (0.54 * 0.54) + (0.74 * 0.74));
        string attitude = string.Join(',', new[] { 0.36, -0.2, 0.54, 0.74 }.Select(
            number => (number / length).ToString("R", CultureInfo.InvariantCulture)));
        List<string> folders = [];
        for (int index = 0; index < times; index++)
        {
            string clock = $"04-06T20:{24 + (6 * index)}:00Z";
            Run($"pinhole{index}", [.. place, .. pinhole, "--ephemeris", "builtin"], $"2010-{clock}");
            Run($"lens{index}", [.. place, "--camera", _folder["lens.yaml"], "--ephemeris", "cspice"], $"2030-{clock}");
            Run($"none{index}", [.. path, .. pinhole], $"2010-{clock}");
            Run($"lt{index}", [.. path, .. pinhole, "--ground-aberration", "lt"], $"2010-{clock}");
            Run($"lt+s{index}", [.. path, .. pinhole, "--ground-aberration", "lt+s"], $"2010-{clock}");
            folders.AddRange(
                $"{_folder[$"pinhole{index}"]}=none", $"{_folder[$"lens{index}"]}=none", $"{_folder[$"none{index}"]}=none",
                $"{_folder[$"lt{index}"]}=lt", $"{_folder[$"lt+s{index}"]}=lt+s:{attitude}:900,1100,400");
        }

        string lists = Path.Combine(TestParts.RepositoryRoot, "lib", "stars", "bright.csv");

        string[] lines = Python("star_pixels.py", [lists, TestParts.CSpiceLibrary!, .. folders]).Split('\n');

        Assert.Equal(5 * times, lines.Length);
        Assert.All(lines, line =>
        {
            string[] words = line.Split(' ');
            Assert.True(int.Parse(words[1], CultureInfo.InvariantCulture) > 250, line);
            Assert.True(double.Parse(words[2], CultureInfo.InvariantCulture) < SamePixel, line);
            Assert.True(double.Parse(words[3], CultureInfo.InvariantCulture) < SamePixelAsStelab, line);
        });
        Assert.True(!TestLength.IsLong || lines.Sum(line => int.Parse(line.Split(' ')[1], CultureInfo.InvariantCulture)) >= 10_000);
    }

    /// <summary>More than a hundred stars of all colours free the electrons that numpy's integration has.</summary>
    [RequiresFact(Part.Ldem4, Part.Astropy)]
    public void Run_WithDetector_FreesTheElectronsOfNumpy()
    {
        _folder.Write(
            "wide.yaml",
            "focal-length: 6\npixel-pitch: 0.011\nwidth: 500\nheight: 400"
                + Detector.Replace(", psf: gaussian, psf-sigma: 0.7", "", StringComparison.Ordinal));
        Run("wide", ["--position", "0,0,1500000", "--look-at", "horizon:90", "--camera", _folder["wide.yaml"]]);
        double area = 0.25 * Math.PI * Math.Pow(0.006 / 1.4, 2.0);

        string[] words = Python(
            "star_electrons.py",
            [
                FileOf("wide", ""), area.ToString("R", CultureInfo.InvariantCulture), "0.2", "420", "700", "0.8", "0.5",
            ]).Split(' ');

        Assert.True(int.Parse(words[0], CultureInfo.InvariantCulture) > 100, words[0]);
        Assert.InRange(double.Parse(words[1], CultureInfo.InvariantCulture), 0.0, SameElectrons);
    }

    /// <summary>The same stars in all files, with electrons that stand in the detector's numbers.</summary>
    [RequiresFact(Part.Ldem4, Part.CFitsio)]
    public void Run_WithDetector_WritesWhatIsDrawn()
    {
        string[] night = ["--position", "0,0,1500000", "--look-at", "horizon:90", "--camera", _folder["detector.yaml"]];
        Run("stars", [.. night, "--layers", "electrons", "--layers-format", "npy"]);
        Assert.Equal(0, CommandLineRun.Of(Arguments("none", [.. night, "--layers", "electrons", "--layers-format", "npy"])).ExitCode);
        XElement[] stars = [.. Xml("stars").Descendants("StarInformation").Single().Elements("Star")];
        string[][] lines = [.. File.ReadLines(FileOf("stars", ".stars.csv")).Select(line => line.Split(','))];

        Assert.True(stars.Length > 20);
        Assert.Equal(stars.Length, lines.Length - 1);
        for (int i = 0; i < stars.Length; i++)
        {
            foreach (string name in (string[])["id", "h", "v", "magnitude", "electrons", "visible", "rightAscension", "hByTurn"])
            {
                Assert.Equal(stars[i].Attribute(name)!.Value, lines[i + 1][Array.IndexOf(lines[0], name)]);
            }
        }

        double[] with = Reals("stars");
        double[] without = Reals("none");
        double sum = stars.Sum(star => double.Parse(star.Attribute("electrons")!.Value, CultureInfo.InvariantCulture));
        double edge = with.Sum() - without.Sum() - sum; // of stars beside the image
        Assert.InRange(edge, -1e-6 * sum, 0.05 * sum);
        Assert.Contains("kind=\"star-catalogue\" name=\"bright.csv\"", File.ReadAllText(FileOf("stars", ".xml")), StringComparison.Ordinal);
        Assert.DoesNotContain("Star", File.ReadAllText(FileOf("none", ".xml")), StringComparison.Ordinal);
    }

    /// <summary>A rig's cameras, a time without kernels, ...: an error that says what to do.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData(3, "outside the kernels", "--time", "2130-01-01T00:00:00Z")]
    [InlineData(1, "as bright as it is beside sunlit ground", "--ignore-sun")]
    [InlineData(1, "for --renderer native only", "--renderer", "povray")]
    [InlineData(1, "leaves no star: all of bright.csv are fainter than V -2", "--star-limit", "-2")]
    [InlineData(1, "neither a file nor 'bright'", "--stars", "no-such-catalogue.dat")]
    public void Run_WrongUse_IsNamed(int exitCode, string message, params string[] options)
    {
        string[] all =
        [
            "--renderer", "native", "--position", "0,0,1500000", "--time", "2010-04-06T20:24:00Z", "--stars", "--output-dir",
            _folder["wrong"],
        ];
        for (int i = 0; i < all.Length - 1; i++)
        {
            if (options.Length > 1 && all[i] == options[0] && !all[i + 1].StartsWith("--", StringComparison.Ordinal))
            {
                (all[i], all[i + 1]) = ("--width", "100");
            }
        }

        CommandLineRun run = CommandLineRun.Of([.. all.Where(word => word != "--stars" || options[0] != "--stars"), .. options]);

        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.Equal(exitCode, run.ExitCode);
    }

    /// <summary>
    /// The middle of a star's electrons in a rolling shutter that moves, and in TDI: where its list has it, at the time of the row that it
    /// is in. In a TDI that moves with the scene, rows above see what is below.
    /// </summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("height: 400\nscan: {kind: rolling-shutter, period: 0.001}", "{0,0,0,0,0.02,0.01}")]
    [InlineData(
        "height: 8\nscan: {kind: line-scan, period: 0.001, tdi: 8, tdi-direction: down}", "{0,0,0,0,0.34375,0}", "--lines", "400")]
    public void Run_ScannedStars_AreWhereTheirListSays(string camera, string motion, params string[] options)
    {
        const int Side = 400;
        const int Reach = 9; // px: further than the PSF
        const double SamePlace = 0.01; // px: the turn of the sky over the rows of a star
        bool isRolling = camera.Contains("rolling", StringComparison.Ordinal);
        string file = _folder.Write(
            "scan.yaml",
            $"width: {Side}\nfocal-length: 16\npixel-pitch: 0.0055\n{camera}\n"
                + Detector.Replace("exposure-time: 0.2", "exposure-time: 0.001, shutter: global", StringComparison.Ordinal));
        Run(
            "scan",
            [
                "--position=-29.83,164.74,400000", "--off-nadir", "100,30", "--motion", motion, "--camera", file, "--layers", "electrons",
                "--layers-format", "npy", .. options,
            ]);
        double[] electrons = Reals("scan");
        string[][] rows = [.. File.ReadLines(FileOf("scan", ".stars.csv")).Select(line => line.Split(','))];
        string Text(string[] row, string name) => row[Array.IndexOf(rows[0], name)];
        double Value(string[] row, string name) => double.Parse(Text(row, name), CultureInfo.InvariantCulture);

        // A streak that lies in a single exposure is the way from row to row.
        (double right, double down) = rows.Skip(1).Where(row => Text(row, "visible") == "yes").Select(Way).MinBy(way => Math.Abs(way.Down));
        int found = 0;
        foreach (string[] row in rows.Skip(1).Where(row => Text(row, "visible") == "yes"))
        {
            (double h, double v) = (Value(row, "h"), Value(row, "v"));
            (int x, int y) = ((int)Math.Round(h), (int)Math.Round(v));
            if (x <= Reach || x > Side - Reach || y <= Reach || y > Side - Reach)
            {
                continue;
            }

            (double sum, double sumX, double sumY) = (0.0, 0.0, 0.0);
            for (int line = y - Reach; line <= y + Reach; line++)
            {
                for (int sample = x - Reach; sample <= x + Reach; sample++)
                {
                    double light = electrons[((line - 1) * Side) + sample - 1];
                    (sum, sumX, sumY) = (sum + light, sumX + (light * sample), sumY + (light * line));
                }
            }

            // From row to row a star moves on; it is in the middle of the row that it is in when that is exposed.
            double shift = isRolling ? (v - y) / (1.0 - down) : y - v;
            Assert.Equal(isRolling ? h + (right * shift) : h, sumX / sum, SamePlace);
            Assert.Equal(y + shift, sumY / sum, SamePlace);
            found++;
        }

        Assert.True(found >= 4, $"{found}");

        (double Right, double Down) Way(string[] row)
        {
            double[] ends = [.. $"{Text(row, "start")} {Text(row, "end")}".Split(' ')
                .Select(word => double.Parse(word, CultureInfo.InvariantCulture))];
            return (ends[2] - ends[0], ends[3] - ends[1]);
        }
    }

    /// <summary>What a script beside this file prints.</summary>
    private string Python(string script, string[] arguments) => ChildRun.Of(
        TestParts.Python!,
        [
            "-B", Path.Combine(TestParts.RepositoryRoot, "tests", "Msisf.Integration.Tests", "Sky", script), TestParts.RepositoryRoot,
            .. arguments,
        ],
        _folder.Path).Succeeded().Output.TrimEnd();

    private void Run(string output, string[] options, string time = "2010-04-06T20:24:00Z")
    {
        CommandLineRun run = CommandLineRun.Of([.. Arguments(output, options, time), "--stars"]);
        Assert.True(run.ExitCode == 0, run.Error);
    }

    private string[] Arguments(string output, string[] options, string time = "2010-04-06T20:24:00Z") =>
        ["--renderer", "native", "--time", time, "--output-dir", _folder[output], .. options];

    private string FileOf(string folder, string ending) => Path.Combine(_folder[folder], "MoonSurfIllumSim_step_00001" + ending);

    private XDocument Xml(string folder) => MetaFileXml.Parse(File.ReadAllText(FileOf(folder, ".xml")));

    /// <summary>The doubles of an array of NumPy, version 1.</summary>
    private double[] Reals(string folder)
    {
        byte[] bytes = File.ReadAllBytes(FileOf(folder, ".electrons.npy"));
        int start = 10 + BitConverter.ToUInt16(bytes, 8);
        double[] values = new double[(bytes.Length - start) / sizeof(double)];
        Buffer.BlockCopy(bytes, start, values, 0, values.Length * sizeof(double));
        return values;
    }
}
