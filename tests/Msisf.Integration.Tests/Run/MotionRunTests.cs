using System.Globalization;
using System.Text.RegularExpressions;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>Runs with a camera that moves while its shutter is open.</summary>
public sealed class MotionRunTests : IDisposable
{
    private static readonly string[] Orbit =
    [
        "--kepler-set", "{2.0E6,0.01,0,0.3,1.2,0.5}", "--epoch", "55289", "--time-interval", "[55289:0.001:55289.002]",
        "--attitude", "{0,0.70710678118654757,0,0.70710678118654757}", "--attitude-transition", "{0.001,0.002,0}",
        "--attitude-frame", "lvlh", "--ephemeris", "builtin",
    ];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>The canonical command line has the motion, and it and a run in pieces make the same bytes.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("shutter: global", "fits: no")]
    [InlineData("shutter: rolling", "fits: no", "line-time: 0.003")]
    public void Run_OnAnOrbit_IsMadeAgainByItsCommandLine(params string[] shutter)
    {
        string camera = Camera(shutter);
        Succeed([.. Orbit, .. Common(camera, "whole"), "--jobs", "1"]);
        Succeed([.. Orbit, .. Common(camera, "pieces"), "--frames", "2:3", "--jobs", "2"]);
        Succeed([.. Orbit, .. Common(Camera("fits: no"), "instant")]);
        camera = Camera(shutter);
        string meta = File.ReadAllText(Output("whole", 2, ".xml"));
        string state = Regex.Match(meta, "--fixed-state '([^']*)' --motion").Groups[1].Value;
        string motion = Regex.Match(meta, "--motion '([^']*)'").Groups[1].Value;
        Succeed(["--fixed-state", state, "--motion", motion, .. Common(camera, "again"), "--ephemeris", "builtin"]);
        File.WriteAllText(_folder["states.tab"], $"{state} {motion}".Trim('{', '}').Replace("} {", " ").Replace(',', ' '));
        Succeed(["--batch-file", _folder["states.tab"], .. Common(camera, "batch"), "--ephemeris", "builtin"]);

        byte[] expected = File.ReadAllBytes(Output("whole", 2, ".png"));
        Assert.Equal(expected, File.ReadAllBytes(Output("pieces", 2, ".png")));
        Assert.Equal(expected, File.ReadAllBytes(Output("again", 1, ".png")));
        Assert.Equal(expected, File.ReadAllBytes(Output("batch", 1, ".png")));
        Assert.NotEqual(expected, File.ReadAllBytes(Output("instant", 2, ".png")));
    }

    /// <summary>A circular orbit in the Moon's axes: speed sqrt(GM / a), once around in the camera's turn.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_CircularOrbit_HasItsSpeedAndTurn()
    {
        Succeed(
        [
            "--kepler-set", "{2.0E6,0,0,0,0,0}", "--epoch", "55289", "--time", "55289.01", "--ephemeris", "builtin",
            .. Common(Camera("shutter: global", "fits: no"), "out"),
        ]);
        string motion = Regex.Match(File.ReadAllText(Output("out", 1, ".xml")), "--motion '{([^}]*)}'").Groups[1].Value;
        double[] numbers = [.. motion.Split(',').Select(text => double.Parse(text, CultureInfo.InvariantCulture))];

        const double Gm = 4.902799e12; // m^3/s^2, to 1e-6
        double speed = Math.Sqrt(Gm / 2e6);
        Assert.Equal(speed, Math.Sqrt((numbers[0] * numbers[0]) + (numbers[1] * numbers[1]) + (numbers[2] * numbers[2])), speed * 1e-4);
        Assert.Equal([0.0, 0.0, speed / 2e6], numbers[3..], (a, b) => Math.Abs(a - b) < 1e-7); // up is north
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_WithoutMotionOrShutter_SaysWhatIsMissing()
    {
        string[] state = ["--fixed-state", "{55289,2E6,2E6,0,0,0,3.826834323650898E-1,9.238795325112867E-1}"];
        string camera = Camera("shutter: global", "fits: no");
        CommandLineRun missing = CommandLineRun.Of([.. state, .. Common(camera, "a")]);
        Assert.Equal(1, missing.ExitCode);
        Assert.Contains(
            "has a shutter, but nothing says how the camera moves while it is open. Give --motion",
            missing.Error,
            StringComparison.Ordinal);
        CommandLineRun orbit = CommandLineRun.Of([.. Orbit, .. Common(camera, "a"), "--motion", "{0,0,0,0,0,0}"]);
        Assert.Equal(1, orbit.ExitCode);
        Assert.Contains("--motion is not allowed with --kepler-set", orbit.Error, StringComparison.Ordinal);
        CommandLineRun buried = CommandLineRun.Of([.. state, .. Common(camera, "a"), "--motion", "{-1e9,-1e9,0,0,0,0}"]);
        Assert.Equal(2, buried.ExitCode);
        Assert.Contains("the camera is inside the Moon: step 1", buried.Error, StringComparison.Ordinal);

        // The camera at rest: the bytes without a shutter.
        Succeed([.. state, .. Common(camera, "rest"), "--motion", "{0,0,0,0,0,0}"]);
        CommandLineRun needless = CommandLineRun.Of([.. state, .. Common(Camera("fits: no"), "a"), "--motion", "{0,0,0,0,0,0}"]);
        Assert.Equal(1, needless.ExitCode);
        Assert.Contains("--motion has no meaning without a camera file", needless.Error, StringComparison.Ordinal);
        Succeed([.. state, .. Common(Camera("fits: no"), "none")]);
        Assert.Equal(File.ReadAllBytes(Output("none", 1, ".png")), File.ReadAllBytes(Output("rest", 1, ".png")));
    }

    /// <summary>A flow from rows with places of their own is refused once, before anything is drawn; what the message says works.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("--flow", "next")]
    [InlineData("--stereo", "100")]
    public void Run_FlowWithARollingShutter_IsRefusedBeforeTheFirstFrame(params string[] flow)
    {
        string[] more = [.. flow, "--flow-format", "npy"];
        CommandLineRun refused = CommandLineRun.Of(
            [.. Orbit, .. Common(Camera("shutter: rolling", "fits: no", "line-time: 0.003"), "a"), .. more]);
        Assert.Equal(1, refused.ExitCode);
        Assert.Contains(
            $"{flow[0]} needs a camera whose rows are all taken at once, and the shutter of this one rolls while it moves. Leave it out, "
                + "or give the camera file a global 'shutter'.",
            refused.Error,
            StringComparison.Ordinal);
        Assert.Single(refused.Error.Split('\n'), line => line.Contains("error:", StringComparison.Ordinal));
        Assert.False(Directory.Exists(_folder["a"]));

        Succeed([.. Orbit, .. Common(Camera("shutter: global", "fits: no"), "a"), .. more]);
        Succeed([.. Orbit, .. Common(Camera("shutter: rolling", "fits: no", "line-time: 0.003"), "b")]);
    }

    [RequiresTheory(Part.Ldem4, Part.CFitsio)]
    [InlineData("rolling", "0.003", "shutter: rolling", "line-time: 0.003")]
    [InlineData("global", "0.", "shutter: global")]
    [InlineData(null, null)]
    public void Run_WithShutter_IsInTheFitsHeader(string? kind, string? lineTime, params string[] shutter)
    {
        Succeed(["--fixed-state", "{55289,2E6,2E6,0,0,0,3.826834323650898E-1,9.238795325112867E-1}", .. Common(Camera(shutter), "out"),
            .. shutter.Length > 0 ? (string[])["--motion", "{0,0,0,0,0,0}"] : []]);

        string header = File.ReadAllText(Output("out", 1, ".dn.fits"), System.Text.Encoding.Latin1);
        Assert.Equal(kind ?? string.Empty, Regex.Match(header, "SHUTTER = '([a-z]*) *'").Groups[1].Value);
        Assert.Equal(lineTime ?? string.Empty, Regex.Match(header, "LINETIME= *([0-9.]+) /").Groups[1].Value);
    }

    private static void Succeed(string[] arguments)
    {
        CommandLineRun run = CommandLineRun.Of(arguments);
        Assert.True(run.ExitCode == 0, run.Error);
    }

    private string Camera(params string[] more)
    {
        string path = _folder["camera.yaml"];
        string[] keys =
        [
            "f-number: 4", "exposure-time: 0.1", "band: [500, 650]", "quantum-efficiency: 0.45", "psf: gaussian", "psf-sigma: 0.9",
            "psf-radius: 3", "gain: 1000", "bias: 100", "adc-bits: 16", "read-noise: 10", .. more,
        ];
        string lines = string.Concat(keys.Select(line => $"  {line}\n"));
        File.WriteAllText(path, $"width: 48\nheight: 32\nfocal-length: 50\npixel-pitch: 0.05\ndetector:\n{lines}");
        return path;
    }

    private string Output(string folder, int step, string ending) => Path.Combine(
        _folder[folder], string.Create(CultureInfo.InvariantCulture, $"MoonSurfIllumSim_step_{step:00000}{ending}"));

    private string[] Common(string camera, string folder) =>
    [
        "--renderer", "native", "--camera", camera, "--grid", "16", "--ldem", TestParts.Ldem4Label!, "--output-dir", _folder[folder],
        "--batch",
    ];
}
