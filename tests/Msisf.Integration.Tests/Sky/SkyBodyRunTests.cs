using System.Globalization;
using System.Xml.Linq;
using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Time;
using Msisf.Integration.Tests.Ephemeris;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Sky;

/// <summary>Runs with the Earth behind the Moon and on its night.</summary>
public sealed class SkyBodyRunTests : IDisposable
{
    private const string Time = "2010-04-06T20:24:00Z";

    private const string Camera = """
        width: 400
        height: 300
        focal-length: 16
        pixel-pitch: 0.011
        detector: {f-number: 1.4, band: [420, 700], transmission: 0.8, quantum-efficiency: 0.5, exposure-time: 0.001, gain: 4, adc-bits: 12,
                   psf: gaussian, psf-sigma: 0.7}
        """;

    private readonly TemporaryFolder _folder = new();

    public SkyBodyRunTests() => _folder.Write("camera.yaml", Camera);

    public void Dispose() => _folder.Dispose();

    /// <summary>The Earth over the limb: where the ephemeris has it, with the electrons of its magnitude.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_Earth_IsWhereTheEphemerisHasIt()
    {
        Run("earth", "--position", "5,125,400000", "--look-at", "horizon:274", "--earth", "--planets", "--camera", _folder["camera.yaml"]);
        string stem = Path.Combine(_folder["earth"], "MoonSurfIllumSim_step_00001");
        string[][] rows = [.. File.ReadLines($"{stem}.bodies.csv").Select(line => line.Split(','))];
        string[] earth = rows.Single(row => row[0] == "Earth");
        double Value(string name) => double.Parse(earth[Array.IndexOf(rows[0], name)], CultureInfo.InvariantCulture);
        XElement general = MetaFileXml.Parse(File.ReadAllText($"{stem}.xml")).Root!.Element("GeneralInformation")!;
        double[] k = Numbers(general.Descendants("K").Single().Value);
        double[] r = Numbers(general.Descendants("R").Single().Value);
        double[] t = Numbers(general.Descendants("t").Single().Value);
        using OpenedEphemeris opened = Engines.BuiltIn();
        double mjd = double.Parse(general.Descendants("MJD").Single().Value, CultureInfo.InvariantCulture);
        IEphemeris engine = opened.Engine;
        Vector3D place = engine.BodyFromJ2000(engine.TimeScale.InstantOfMjd(mjd).Tdb)
            * engine.StateOf(399, engine.TimeScale.InstantOfMjd(mjd).Tdb).Position;
        double[] seen = [.. Enumerable.Range(0, 3).Select(
            i => (r[3 * i] * place.X) + (r[(3 * i) + 1] * place.Y) + (r[(3 * i) + 2] * place.Z) + t[i])];

        // Light time and aberration nearly cancel for a body that flies with the Moon: 1 km/s is 0.7 arcseconds, 0.005 px.
        Assert.Equal((k[0] * seen[0] / seen[2]) + k[2] + 1.0, Value("h"), 0.01);
        Assert.Equal((k[4] * seen[1] / seen[2]) + k[5] + 1.0, Value("v"), 0.01);
        double distance = Math.Sqrt(seen.Sum(x => x * x));
        Assert.Equal(k[0] * Math.Tan(Math.Asin(6_378_136.6 / distance)), Value("radius"), 0.6); // off the axis pixels are smaller
        Assert.Equal(1.0, Value("visible"));
        Assert.InRange(Value("phase"), 80.0, 90.0);
        Assert.Equal(-15.43, Value("magnitude"), 0.03); // -3.99 - 1.06e-3 a + 2.054e-4 a^2, a = 85.3, from 0.002694 au; and its nearness
        Assert.InRange(Value("electrons"), 1e8, 1e10);
    }

    /// <summary>The layer of objects: the Earth's whole disc, stars where their list has them, ground where there is a depth.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_ObjectLayer_NamesWhatPixelsShow()
    {
        const int Width = 400;
        Run(
            "object", "--position", "5,125,400000", "--look-at", "horizon:274", "--sky", "--camera", _folder["camera.yaml"], "--layers",
            "depth,object", "--layers-format", "npy");
        string stem = Path.Combine(_folder["object"], "MoonSurfIllumSim_step_00001");
        byte[] bytes = File.ReadAllBytes($"{stem}.object.npy");
        int[] objects = new int[Width * 300];
        Buffer.BlockCopy(bytes, bytes.Length - (sizeof(int) * objects.Length), objects, 0, sizeof(int) * objects.Length);
        double[] depths = Reals($"{stem}.depth.npy");
        string[][] bodies = [.. File.ReadLines($"{stem}.bodies.csv").Select(line => line.Split(','))];
        string[][] stars = [.. File.ReadLines($"{stem}.stars.csv").Select(line => line.Split(','))];
        string[] earth = bodies.Single(row => row[0] == "Earth");
        double Number(string[][] rows, string[] row, string name) =>
            double.Parse(row[Array.IndexOf(rows[0], name)], CultureInfo.InvariantCulture);

        double radius = Number(bodies, earth, "radius");
        double area = Math.PI * radius * radius * Number(bodies, earth, "visible");
        Assert.Equal(1.0, objects.Count(number => number == 399) / area, 0.03);
        Assert.All(objects.Zip(depths), pair => Assert.True(pair.First == 2 || (pair.First == 1) == !double.IsNaN(pair.Second)));
        string[][] seen = [.. stars.Skip(1).Where(row => row[Array.IndexOf(stars[0], "visible")] == "yes")];
        Assert.True(seen.Length > 10);
        Assert.All(seen, row => Assert.Equal(
            2, objects[(((int)Math.Round(Number(stars, row, "v")) - 1) * Width) + (int)Math.Round(Number(stars, row, "h")) - 1]));
        Assert.InRange(objects.Count(number => number == 2), seen.Length - 1, seen.Length); // two may share a pixel
    }

    /// <summary>Lambert's ground in the night: as bright as the Earth's light falls on it, in a frame and in a scan.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("height: 64\n")]
    [InlineData("height: 1\nscan: {kind: line-scan, period: 0.05}\n", "--lines", "64", "--motion", "{0,1600,0,0,0,0}")]
    public void Run_Earthshine_LightsTheNight(string camera, params string[] options)
    {
        string file = _folder.Write("night.yaml", $"field-of-view: 20\nwidth: 64\n{camera}");
        Run(
            "shine",
            [
                "--position", "0,30,100000", "--earthshine", "--reflectance", "lambert", "--albedo", "0.2", "--camera", file, "--layers",
                "position,normal,radiance-factor", "--layers-format", "npy", .. options,
            ]);
        using OpenedEphemeris opened = Engines.BuiltIn();
        string stem = Path.Combine(_folder["shine"], "MoonSurfIllumSim_step_00001");
        XElement general = MetaFileXml.Parse(File.ReadAllText($"{stem}.xml")).Root!.Element("GeneralInformation")!;
        double mjd = double.Parse(general.Descendants("MJD").Single().Value, CultureInfo.InvariantCulture);
        IEphemeris engine = opened.Engine;
        TdbTime tdb = engine.TimeScale.InstantOfMjd(mjd).Tdb;
        RotationMatrix axes = engine.BodyFromJ2000(tdb);
        Vector3D earth = axes * engine.StateOf(399, tdb).Position;
        Vector3D sun = axes * engine.StateOf(10, tdb).Position;
        double[] positions = Reals($"{stem}.position.npy");
        double[] normals = Reals($"{stem}.normal.npy");
        double[] factors = Reals($"{stem}.radiance-factor.npy");
        List<double> ratios = [];
        for (int i = 0; i < factors.Length; i++)
        {
            Vector3D ground = new(positions[3 * i], positions[(3 * i) + 1], positions[(3 * i) + 2]);
            Vector3D normal = new(normals[3 * i], normals[(3 * i) + 1], normals[(3 * i) + 2]);
            ratios.Add(factors[i] / (0.2 * Light(earth - ground, sun - ground, normal)));
        }

        ratios.Sort();
        Assert.Equal(1.0, ratios[ratios.Count / 2], 5e-3);
    }

    /// <summary>Light of the Earth over sunlight on a facet of the Moon: a sum over its surface, scaled to its magnitude.</summary>
    private static double Light(Vector3D earth, Vector3D sun, Vector3D normal)
    {
        const double Radius = 6_371_000.0;
        const double Au = 149_597_870_700.0;
        const int Net = 24;
        Vector3D toSun = (sun - earth).Normalized();
        Vector3D back = -earth.Normalized();
        double sum = 0.0;
        double far = 0.0;
        for (int i = 0; i < Net; i++)
        {
            double z = (((2.0 * i) + 1.0) / Net) - 1.0;
            for (int j = 0; j < 2 * Net; j++)
            {
                (double y, double x) = Math.SinCos(Math.PI * (j + 0.5) / Net);
                Vector3D point = new(x * Math.Sqrt(1.0 - (z * z)), y * Math.Sqrt(1.0 - (z * z)), z);
                double lit = Math.Max(0.0, Vector3D.Dot(point, toSun));
                Vector3D way = earth + (Radius * point);
                double leaves = Math.Max(0.0, -Vector3D.Dot(point, way.Normalized()));
                sum += lit * leaves * Math.Max(0.0, Vector3D.Dot(normal, way.Normalized())) * earth.LengthSquared / way.LengthSquared;
                far += lit * Math.Max(0.0, Vector3D.Dot(point, back));
            }
        }

        double phase = double.RadiansToDegrees(Vector3D.AngleBetween(toSun, back));
        double magnitude = -3.99 - (1.060e-3 * phase) + (2.054e-4 * phase * phase)
            + (5.0 * Math.Log10((sun - earth).Length * earth.Length / (Au * Au)));
        return sum / far * Math.Pow(10.0, -0.4 * (magnitude + 26.76)) * (sun.LengthSquared / (Au * Au));
    }

    /// <summary>A camera that hardly moves while its shutter is open frees the electrons of one at rest.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("global")]
    [InlineData("rolling, line-time: 1.0e-5")]
    public void Run_EarthshineWithAShutter_HasTheLightOfAStillCamera(string shutter)
    {
        const double SameLight = 1e-3; // the camera flies 1.6 m in an exposure, 5 m until the last row; a pixel has 70 m
        string[] night = ["--position", "0,30,100000", "--layers", "electrons", "--layers-format", "npy", "--camera"];
        string[] motion = ["--motion", "{0,1600,0,0,0,0}"];
        string open = Camera.Replace("psf: gaussian", $"shutter: {shutter}, psf: gaussian", StringComparison.Ordinal);
        Run("moving", [.. night, _folder.Write("shutter.yaml", open), .. motion, "--earthshine"]);
        Run("still", [.. night, _folder.Write("camera.yaml", Camera), "--earthshine"]);
        Run("dark", [.. night, _folder["shutter.yaml"], .. motion]);

        double still = Electrons("still");

        Assert.True(still > 0.0);
        Assert.Equal(0.0, Electrons("dark"), SameLight * still);
        Assert.Equal(1.0, Electrons("moving") / still, SameLight);
        double Electrons(string folder) => Reals(Path.Combine(_folder[folder], "MoonSurfIllumSim_step_00001.electrons.npy")).Sum();
    }

    /// <summary>A scan that is too large for the memory has the Earth's light in its strips as one that is drawn as a whole.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_EarthshineInStrips_IsThatOfTheWhole()
    {
        const int Width = 16_384; // 2^23 px are drawn as a whole: 512 lines
        const int Lines = 8;
        string camera = _folder.Write(
            "wide.yaml", $"field-of-view: 150\nwidth: {Width}\nheight: 1\nscan:\n  kind: line-scan\n  period: 0.05\n");
        string[] far =
        [
            "--fixed-state", "{55289,9E7,0,0,0,0,0,1}", "--motion", "{0,4E6,4E6,0,0,0}", "--camera", camera, "--layers",
            "radiance-factor", "--layers-format", "npy",
        ];
        Draw("whole", ["--lines", $"{Lines}", "--earthshine"]);
        Draw("strips", ["--lines", "513", "--earthshine"]);
        Draw("sunlit", ["--lines", $"{Lines}"]);

        double[] whole = Factors("whole");

        Assert.Equal(whole, Factors("strips")[..whole.Length]);
        Assert.Contains(whole.Zip(Factors("sunlit")), pair => pair.First > pair.Second);

        void Draw(string output, string[] options)
        {
            CommandLineRun run = CommandLineRun.Of(["--renderer", "native", "--output-dir", _folder[output], .. far, .. options]);
            Assert.True(run.ExitCode == 0, run.Error);
        }

        double[] Factors(string folder) => Reals(Path.Combine(_folder[folder], "MoonSurfIllumSim_step_00001.radiance-factor.npy"));
    }

    /// <summary>Kernels without a body: the option that wants it is named, with each engine.</summary>
    [RequiresTheory(Part.Ldem4, Part.CSpice)]
    [InlineData("builtin", 399, "--earth: ", "--earth")]
    [InlineData("builtin", 399, "--earth: ", "--sky")]
    [InlineData("builtin", 399, "--earthshine: ", "--earthshine")]
    [InlineData("builtin", 4, "--planets: ", "--planets")]
    [InlineData("cspice", 399, "--earth: ", "--earth")]
    public void Run_KernelsWithoutTheBody_AreNamed(string engine, int number, string message, string option)
    {
        const int TargetsFrom = 2_088; // summaries of 40 bytes in the third record, after 24 bytes and two doubles of the first
        const int Summary = 40;
        byte[] kernel = File.ReadAllBytes(Path.Combine(TestParts.Kernels, "de421.bsp"));
        int at = Enumerable.Range(0, 15).Select(index => TargetsFrom + (index * Summary))
            .Single(offset => BitConverter.ToInt32(kernel, offset) == number);
        BitConverter.GetBytes(number + 1_000_000).CopyTo(kernel, at);
        _folder.Write("without.bsp", kernel);
        string list = File.ReadAllText(Path.Combine(TestParts.Kernels, "msisf.tm"))
            .Replace("de421.bsp'", "without.bsp'", StringComparison.Ordinal);
        foreach (string name in (string[])["naif0012.tls", "moon_080317.tf", "moon_assoc_me.tf", "moon_pa_de421_1900-2050.bpc"])
        {
            File.CreateSymbolicLink(_folder[name], Path.Combine(TestParts.Kernels, name));
        }

        CommandLineRun run = CommandLineRun.Of(
        [
            "--renderer", "native", "--time", Time, "--output-dir", _folder["without"], "--position", "5,125,400000", "--width", "32",
            "--height", "24", "--kernels", _folder.Write("without.tm", list), "--ephemeris", engine, option,
        ]);

        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.Contains(
            $"No kernel leads from body {number.ToString(CultureInfo.InvariantCulture)} to the Moon", run.Error, StringComparison.Ordinal);
        Assert.Contains("the kernels have nothing of that body. Use kernels that have it.", run.Error, StringComparison.Ordinal);
        Assert.Equal(3, run.ExitCode);
    }

    private void Run(string output, params string[] options)
    {
        CommandLineRun run = CommandLineRun.Of(["--renderer", "native", "--time", Time, "--output-dir", _folder[output], .. options]);
        Assert.True(run.ExitCode == 0, run.Error);
    }

    private static double[] Numbers(string text) =>
        [.. text.Split((char[])[' ', '\n'], StringSplitOptions.RemoveEmptyEntries)
            .Select(word => double.Parse(word, CultureInfo.InvariantCulture))];

    /// <summary>The doubles of an array of NumPy, version 1.</summary>
    private static double[] Reals(string path)
    {
        byte[] bytes = File.ReadAllBytes(path);
        int start = 10 + BitConverter.ToUInt16(bytes, 8);
        double[] values = new double[(bytes.Length - start) / sizeof(double)];
        Buffer.BlockCopy(bytes, start, values, 0, values.Length * sizeof(double));
        return values;
    }
}
