using System.Globalization;
using System.Text.RegularExpressions;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>Runs whose exposure time is given, found, or wrong.</summary>
public sealed class ExposureRunTests : IDisposable
{
    private const int Width = 48;
    private const int Height = 32;
    private const int Frames = 40;
    private const double Gain = 10.0;
    private const double Bias = 64.0;

    private static readonly string[] Saturated =
    [
        "f-number: 40", "exposure-time: 0.05", "band: [500, 650]", "quantum-efficiency: 0.45", "psf: gaussian", "psf-sigma: 0.9",
        "psf-radius: 4", "gain: 10", "bias: 64", "read-noise: 12", "seed: 7", "fits: no",
    ];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>From the layers of all 40 frames, of which 32 are looked at: full well, converter and fewer bits decide in turn.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_Automatic_BringsTheBrightestPixelsToTheLowerLimit()
    {
        CommandLineRun run = Run(
            ["full-well: 20000", "adc-bits: 12"], "out", "--exposure-time", "auto", "--layers", "electrons,saturated,radiance-factor",
            "--layers-format", "npy");
        Assert.True(run.ExitCode == 0, run.Error);
        List<double> electrons = [];
        int saturated = 0;
        for (int step = 1; step <= Frames; step++)
        {
            double[] light = Doubles(step, "radiance-factor");
            double[] counted = Doubles(step, "electrons");
            byte[] marks = File.ReadAllBytes(Output("out", step, ".saturated.npy"))[^(Width * Height)..];
            electrons.AddRange(counted.Where((_, i) => light[i] > 0.0));
            saturated += marks.Where((mark, i) => mark != 0 && light[i] > 0.0).Count();
        }

        electrons.Sort();
        Assert.InRange(saturated / (double)electrons.Count, 0.002, 0.008); // of all frames, in place of those that were looked at
        double perSecond = electrons[(int)(0.995 * electrons.Count)] / Number(Time("out", 1));
        foreach ((string fullWell, string bits, double limit) in ((string, string, double)[])
        [
            ("full-well: 20000", "adc-bits: 12", 20000.0),
            ("full-well: 60000", "adc-bits: 12", (4095.0 - 0.5 - Bias) * Gain),
            ("full-well: 20000", "adc-bits: 8", (255.0 - 0.5 - Bias) * Gain),
        ])
        {
            string note = Run([fullWell, bits], "dry", "--exposure-time", "auto", "--frames", "3", "--dry-run").Error;
            string time = Regex.Match(note, "--exposure-time auto: (\\S+) s, from 32 of 40 frames").Groups[1].Value;
            double brightest = perSecond * Number(time);

            // The noise wants up to 3 of its standard deviations as room.
            Assert.InRange(brightest, limit - (3.0 * Math.Sqrt(limit)) - (0.01 * limit), 1.01 * limit);
        }
    }

    /// <summary>Pieces, a restart and the frame's own command line: one exposure time, the same bytes.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_Automatic_IsTheSameInPiecesAndAgain()
    {
        string[] camera = ["full-well: 20000", "adc-bits: 12"];
        Assert.Equal(0, Run(camera, "whole", "--exposure-time", "auto").ExitCode);
        Assert.Equal(0, Run(camera, "pieces", "--exposure-time", "auto", "--frames", "39:40", "--jobs", "1").ExitCode);
        Assert.Equal(0, Run(camera, "pieces", "--exposure-time", "AUTO", "--frames", "1:3").ExitCode);
        byte[] kept = File.ReadAllBytes(Output("whole", 7, ".png"));
        File.Delete(Output("whole", 7, ".png"));
        CommandLineRun restart = Run(camera, "whole", "--exposure-time", "auto");

        Assert.Equal(0, restart.ExitCode);
        Assert.Contains("Frames: 40, of which 39 there and complete", restart.Error, StringComparison.Ordinal);
        Assert.Equal(kept, File.ReadAllBytes(Output("whole", 7, ".png")));
        foreach (int step in (int[])[1, 3, 39, 40])
        {
            Assert.Equal(File.ReadAllBytes(Output("whole", step, ".png")), File.ReadAllBytes(Output("pieces", step, ".png")));
            Assert.Equal(File.ReadAllBytes(Output("whole", step, ".xml")), File.ReadAllBytes(Output("pieces", step, ".xml")));
        }

        string[] times = [.. Enumerable.Range(1, Frames).Select(step => Time("whole", step)).Distinct()];
        string time = Assert.Single(times);
        Assert.Contains($"--exposure-time auto: {time} s, from 32 of 40 frames of the run.", restart.Error, StringComparison.Ordinal);
        Assert.Equal(0, Run(camera, "number", "--exposure-time", time, "--frames", "5").ExitCode);
        Assert.Equal(File.ReadAllBytes(Output("whole", 5, ".png")), File.ReadAllBytes(Output("number", 5, ".png")));
        Assert.Equal(File.ReadAllBytes(Output("whole", 5, ".xml")), File.ReadAllBytes(Output("number", 5, ".xml")));
    }

    /// <summary>A number goes before the camera file's: as if the file had it, but for its checksum and the words of the call.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_Number_GoesBeforeTheCameraFile()
    {
        string[] camera = ["adc-bits: 12", "dark-current: 1000", "shutter: global"];
        string[] changed = [.. Saturated.Select(key => key.Replace("0.05", "0.0004", StringComparison.Ordinal)), .. camera];
        Assert.Equal(0, Run(camera, "option", "--exposure-time", "0.0004", "--frames", "4").ExitCode);
        Assert.Equal(0, RunOf(changed, "file", "--frames", "4").ExitCode);

        Assert.Equal(File.ReadAllBytes(Output("file", 4, ".png")), File.ReadAllBytes(Output("option", 4, ".png")));
        Assert.Equal("0.0004", Time("option", 4));
        Assert.DoesNotContain("--exposure-time", File.ReadAllText(Output("file", 4, ".xml")), StringComparison.Ordinal);
    }

    /// <summary>Run and dry run name the same first and worst frame, and a time that leaves nothing to note.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("0.05", "saturated")]
    [InlineData("1e-7", "empty")]
    public void Run_WrongTime_IsNotedOnceWithTheRightOne(string time, string what)
    {
        string[] camera = ["full-well: 20000", "adc-bits: 12"];
        CommandLineRun drawn = Run(camera, "out", "--exposure-time", time, "--frames", "3:8");
        CommandLineRun dry = Run(camera, "dry", "--exposure-time", time, "--frames", "3:8", "--dry-run");

        foreach (CommandLineRun run in (CommandLineRun[])[drawn, dry])
        {
            string note = Assert.Single(run.Error.Split('\n'), line => line.Contains("of the lit pixels", StringComparison.Ordinal));
            Assert.Matches(
                what == "empty"
                    ? @"^msis: Exposure of 1E-07 s: 0 % of the lit pixels are saturated, 100 % \(first step 3; worst step 3, 100 %\) are e"
                    : @"^msis: Exposure of 0.05 s: 100 % \(first step 3; worst step 3, 100 %\) of the lit pixels are saturated, 0 % are ",
                note);
            string right = Regex.Match(note, @"use --exposure-time ([0-9.E-]+)\.$").Groups[1].Value;
            CommandLineRun better = Run(camera, "better", "--exposure-time", right, "--frames", "3:8", "--overwrite");
            Assert.Equal(0, better.ExitCode);
            Assert.DoesNotContain("of the lit pixels", better.Error, StringComparison.Ordinal);
        }
    }

    /// <summary>A small camera shows the numbers of the large one, also through a lens and with skew.</summary>
    [RequiresTheory(Part.Ldem4)]
    [InlineData("")]
    [InlineData("skew: 15\nprincipal-point: [100, 160]\ndistortion:\n  model: fisheye\n  k1: 0.05\n")]
    public void DryRun_ExpectedNumbers_AreThoseOfTheDrawnFrame(string lens)
    {
        string[] detector = [.. Saturated, "full-well: 40000", "adc-bits: 12"];
        string camera = Camera(detector, $"width: 400\nheight: 300\nfocal-length: 5\npixel-pitch: [0.02, 0.015]\n{lens}");
        string[] words = Words(camera, "out", "--exposure-time", "0.03", "--frames", "1,20,40");
        Assert.Equal(0, CommandLineRun.Of([.. words, "--layers", "radiance-factor", "--layers-format", "npy"]).ExitCode);
        CommandLineRun dry = CommandLineRun.Of([.. words, "--dry-run", "--format", "csv"]);

        string[][] lines = [.. dry.Output.TrimEnd().Split('\n').Select(line => line.TrimEnd().Split(','))];
        int median = Array.IndexOf(lines[0], "expected_dn_median");
        int high = Array.IndexOf(lines[0], "expected_dn_99");
        Assert.Equal(4, lines.Length);
        foreach (string[] line in lines[1..])
        {
            int step = int.Parse(line[0], CultureInfo.InvariantCulture);
            PngPixels png = PngPixels.Read(Output("out", step, ".png"));
            byte[] light = File.ReadAllBytes(Output("out", step, ".radiance-factor.npy"))[^(400 * 300 * sizeof(double))..];
            int[] lit = [.. Enumerable.Range(0, 400 * 300).Where(i => BitConverter.ToDouble(light, i * sizeof(double)) > 0.0)
                .Select(i => png[i % 400, i / 400, 0] >> 4).Order()];

            // The small image has no blur, and few pixels to tell the last percent from (docs/command-line.md).
            Assert.Equal(lit[lit.Length / 2], Number(line[median]), 0.02 * lit[lit.Length / 2]);
            Assert.Equal(lit[(int)(0.99 * lit.Length)], Number(line[high]), 0.06 * lit[^1]);
            Assert.InRange(lit[lit.Length / 2], 300, 4000);
        }
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_WhatCantBe_IsRefusedWithAClearLine()
    {
        string camera = Camera([.. Saturated, "adc-bits: 12"]);
        string[] run = ["--renderer", "native", "--ldem", TestParts.Ldem4Label!, "--ephemeris", "builtin", "--output-dir", _folder["no"]];
        string[] fixedState = ["--fixed-state", "{55289,2E6,2E6,0,0,0,3.826834323650898E-1,9.238795325112867E-1}"];
        string[] night = ["--fixed-state", "{55289,-2E6,2E6,0,0,0,9.238795325112867E-1,3.826834323650898E-1}"];
        string[] detector = [.. fixedState, "--camera", camera];
        foreach ((string[] words, int code, string message) in ((string[], int, string)[])
        [
            ([.. fixedState, "--exposure-time", "0.01"], 1, "--exposure-time has no meaning without a camera file that has the section"),
            ([.. fixedState, "--noise-seed", "1"], 1, "--noise-seed has no meaning without a camera file that has the section 'detector'"),
            ([.. detector, "--exposure-time", "0"], 1, "--exposure-time is '0'; seconds above 0, up to 86400, or auto, are needed."),
            ([.. detector, "--exposure-time", "5ms"], 1, "--exposure-time is '5ms'; seconds above 0"),
            ([.. detector, "--noise-seed", "-1"], 1, "--noise-seed: '-1' is not a noise seed; a whole number from 0 on"),
            (["--batch-file", "-", "--camera", camera, "--exposure-time", "auto"], 1, "standard input can be read once. Give seconds"),
            ([.. night, "--camera", camera, "--exposure-time", "auto"], 2, "auto: no pixel of the frames that were looked at is lit"),
        ])
        {
            CommandLineRun refused = CommandLineRun.Of([.. words, .. run], "55289 2E6 2E6 0 0 0 3.826834323650898E-1 9.238795325112867E-1");
            Assert.Equal(code, refused.ExitCode);
            Assert.Contains(message, refused.Error, StringComparison.Ordinal);
            Assert.False(Directory.Exists(_folder["no"]));
        }
    }

    /// <summary>A band far from the visible light is drawn, with one note.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_UnusualBand_IsNoted()
    {
        string[] keys = [.. Saturated.Select(key => key.Replace("[500, 650]", "[250, 3000]", StringComparison.Ordinal)), "adc-bits: 12"];
        CommandLineRun run = RunOf(keys, "out", "--frames", "1:2");

        Assert.Equal(0, run.ExitCode);
        Assert.Single(run.Error.Split('\n'), line => line.StartsWith(
            "msis: The detector's band is 250 to 3000 nm; what lies outside 300 to 2,600 nm is less certain", StringComparison.Ordinal));
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    private string Camera(IEnumerable<string> detector, string? geometry = null)
    {
        string path = _folder["camera.yaml"];
        string keys = string.Concat(detector.Select(line => $"  {line}\n"));
        File.WriteAllText(path, string.Create(
            CultureInfo.InvariantCulture,
            $"{geometry ?? $"width: {Width}\nheight: {Height}\nfocal-length: 5\npixel-pitch: 0.1\n"}detector:\n{keys}"));
        return path;
    }

    private string Output(string folder, int step, string ending) =>
        Path.Combine(_folder[folder], $"MoonSurfIllumSim_step_{step:00000}{ending}");

    private string Time(string folder, int step) =>
        Regex.Match(File.ReadAllText(Output(folder, step, ".xml")), "--exposure-time ([^ <]*)").Groups[1].Value;

    private CommandLineRun Run(string[] camera, string folder, params string[] more) => RunOf([.. Saturated, .. camera], folder, more);

    private CommandLineRun RunOf(string[] detector, string folder, params string[] more) =>
        CommandLineRun.Of(Words(Camera(detector), folder, more));

    private string[] Words(string camera, string folder, params string[] more) =>
    [
        "--kepler-set", "{2.0E6,0.01,0,0.3,1.2,4.6}", "--epoch", "55289", "--time-interval", "[55289:0.0005:55289.0195]", "--renderer",
        "native", "--camera", camera, "--grid", "48", "--ldem", TestParts.Ldem4Label!, "--ephemeris", "builtin", "--output-dir",
        _folder[folder], "--batch", "--albedo-map", "none", .. more,
    ];

    private double[] Doubles(int step, string layer)
    {
        byte[] file = File.ReadAllBytes(Output("out", step, $".{layer}.npy"));
        return [.. Enumerable.Range(0, Width * Height).Select(
            i => BitConverter.ToDouble(file, file.Length - (sizeof(double) * ((Width * Height) - i))))];
    }
}
