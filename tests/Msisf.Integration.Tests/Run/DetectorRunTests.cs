using System.Buffers.Binary;
using System.Globalization;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>Runs with a camera that has a detector.</summary>
public sealed class DetectorRunTests : IDisposable
{
    private const int Width = 48;
    private const int Height = 32;

    private static readonly string[] Detector =
    [
        "f-number: 4", "exposure-time: 0.004", "band: [500, 650]", "quantum-efficiency: 0.45", "psf: gaussian", "psf-sigma: 0.9",
        "psf-radius: 4", "gain: 1", "bias: 100", "adc-bits: 16",
    ];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.Ldem4, Part.CFitsio)]
    public void Run_NoiseInPieces_MakesTheBytesOfOneRun()
    {
        string camera = Camera(
            [.. Detector, "read-noise: 10", "prnu: 0.02", "dark-current: 1000", "dsnu: 0.3", "cosmic-rays: 1e6", "seed: 3"]);
        Assert.Equal(0, Run(camera, "whole", "--jobs", "1").ExitCode);
        Assert.Equal(0, Run(camera, "pieces", "--frames", "2:3", "--jobs", "2").ExitCode);
        Assert.Equal(0, Run(camera, "pieces", "--frames", "1").ExitCode);
        for (int step = 1; step <= 3; step++)
        {
            Assert.Equal(File.ReadAllBytes(Output("whole", step, ".png")), File.ReadAllBytes(Output("pieces", step, ".png")));
            Assert.Equal(File.ReadAllBytes(Output("whole", step, ".dn.fits")), File.ReadAllBytes(Output("pieces", step, ".dn.fits")));
        }

        Assert.NotEqual(File.ReadAllBytes(Output("whole", 1, ".png")), File.ReadAllBytes(Output("whole", 2, ".png")));
    }

    /// <summary>Without noise the DN are the electrons of the layer, as many as the formula gives for the radiance.</summary>
    [RequiresFact(Part.Ldem4, Part.CFitsio)]
    public void Run_WithoutNoise_CountsTheElectronsOfTheRadiance()
    {
        string camera = Camera([.. Detector, "seed: none"]);
        CommandLineRun run = Run(
            camera, "out", "--frames", "1", "--layers", "electrons,radiance,saturated", "--layers-format", "npy", "--band", "566");
        Assert.Equal(0, run.ExitCode);
        double[] electrons = Doubles(Output("out", 1, ".electrons.npy"), Width * Height);
        double[] radiance = Doubles(Output("out", 1, ".radiance.npy"), Width * Height);
        PngPixels png = PngPixels.Read(Output("out", 1, ".png"));
        int[] numbers = FitsNumbers(Output("out", 1, ".dn.fits"));
        for (int i = 0; i < electrons.Length; i++)
        {
            int expected = Math.Min(65535, (int)Math.Floor(electrons[i] + 100.5));
            Assert.Equal(expected, numbers[i]);
            Assert.Equal(expected, png[i % Width, i / Width, 0]);
        }

        // A = pi (50 mm / 4)^2 / 4, Omega = (10 um / 50 mm)^2, 4 ms, QE 0.45; mean of lambda E(lambda) / E(566) from 500 to 650 nm is
        // 575 nm x 0.99 within 3 %: ASTM E490-00a has 1.91 to 1.60 W m^-2 nm^-1 there, and 1.84 at 566 nm.
        const double Photons = 150.0 * 575e-9 * 0.99 / (6.62607015e-34 * 299792458.0);
        double perRadiance = Math.PI / 4.0 * 0.0125 * 0.0125 * 4e-8 * 0.004 * 0.45 * Photons;
        Assert.InRange(electrons.Sum() / radiance.Sum() / perRadiance, 0.97, 1.03);
        Assert.True(electrons.Max() > 1000.0);
    }

    /// <summary>A smaller detector in the middle of a larger one: its borders get the light that the larger one sees beyond them.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_ImageBorder_HasTheLightFromBeyond()
    {
        const int Border = 4;
        const double Relative = 1e-9; // rays of the two cameras are rounded differently
        string[] detector = [.. Detector, "fits: no"];
        string[] layers = ["--frames", "1", "--layers", "electrons,range", "--layers-format", "npy"];
        Assert.Equal(0, Run(Camera(detector), "large", layers).ExitCode);
        Assert.Equal(0, Run(Camera(detector, Width - (2 * Border), Height - (2 * Border)), "small", layers).ExitCode);
        foreach (string layer in (string[])[".electrons.npy", ".range.npy"])
        {
            double[] large = Doubles(Output("large", 1, layer), Width * Height);
            double[] small = Doubles(Output("small", 1, layer), (Width - (2 * Border)) * (Height - (2 * Border)));
            for (int i = 0; i < small.Length; i++)
            {
                (int y, int x) = Math.DivRem(i, Width - (2 * Border));
                double expected = large[((y + Border) * Width) + x + Border];
                Assert.InRange(small[i], expected * (1.0 - Relative), expected * (1.0 + Relative));
            }
        }
    }

    [RequiresFact(Part.Ldem4)]
    public void Run_WrongCombinations_AreRefusedWithAClearLine()
    {
        string camera = Camera([.. Detector, "fits: no"]);
        CommandLineRun povRay = CommandLineRun.Of([.. State("a"), "--camera", camera]);
        Assert.Equal(1, povRay.ExitCode);
        Assert.Equal(
            "msis: error: --camera camera.yaml has a detector, which needs the radiance of each pixel. Add --renderer native.",
            povRay.Error.Split('\n')[0].Trim());
        CommandLineRun lamp = CommandLineRun.Of([.. State("a"), "--camera", camera, "--renderer", "native", "--ignore-sun"]);
        Assert.Equal(1, lamp.ExitCode);
        Assert.Contains("counts electrons of sunlight. Leave --ignore-sun out.", lamp.Error, StringComparison.Ordinal);
        CommandLineRun layer = CommandLineRun.Of(
            [.. State("a"), "--width", "8", "--height", "8", "--renderer", "native", "--layers", "electrons"]);
        Assert.Equal(1, layer.ExitCode);
        Assert.Contains("--layers: electrons needs a camera with a detector.", layer.Error, StringComparison.Ordinal);
    }

    private string Camera(IEnumerable<string> detector, int width = Width, int height = Height)
    {
        string path = _folder["camera.yaml"];
        string keys = string.Concat(detector.Select(line => $"  {line}\n"));
        File.WriteAllText(path, string.Create(
            CultureInfo.InvariantCulture,
            $"width: {width}\nheight: {height}\nfocal-length: 50\npixel-pitch: 0.01\ndetector:\n{keys}"));
        return path;
    }

    private string Output(string folder, int step, string ending) =>
        Path.Combine(_folder[folder], $"MoonSurfIllumSim_step_{step:00000}{ending}");

    private CommandLineRun Run(string camera, string folder, params string[] more) => CommandLineRun.Of(
    [
        "--kepler-set", "{2.0E6,0.01,0,0.3,1.2,0.5}", "--epoch", "55289", "--time-interval", "[55289:0.001:55289.002]", "--renderer",
        "native", "--camera", camera, "--grid", "16", "--ldem", TestParts.Ldem4Label!, "--ephemeris", "builtin", "--output-dir",
        _folder[folder], "--batch", .. more,
    ]);

    private string[] State(string folder) =>
    [
        "--fixed-state", "{55289,2E6,2E6,0,0,0,3.826834323650898E-1,9.238795325112867E-1}", "--ldem", TestParts.Ldem4Label!, "--batch",
        "--output-dir", _folder[folder],
    ];

    private static double[] Doubles(string path, int count)
    {
        byte[] file = File.ReadAllBytes(path);
        return [.. Enumerable.Range(0, count).Select(
            i => BitConverter.ToDouble(file, file.Length - (sizeof(double) * (count - i))))];
    }

    /// <summary>BITPIX 16, BZERO 32768; the header's length is found by its END card.</summary>
    private static int[] FitsNumbers(string path)
    {
        byte[] file = File.ReadAllBytes(path);
        int card = 0;
        while (!file.AsSpan(card, 8).SequenceEqual("END     "u8))
        {
            card += 80;
        }

        int data = ((card / 2880) + 1) * 2880;
        return [.. Enumerable.Range(0, Width * Height).Select(
            i => BinaryPrimitives.ReadInt16BigEndian(file.AsSpan(data + (2 * i))) + 32768)];
    }
}
