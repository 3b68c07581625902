using System.Globalization;
using System.Text;
using Msisf.Adapters.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Detector.Psf;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Camera;

public sealed class DetectorSectionTests : IDisposable
{
    private const string Head = "width: 64\nheight: 48\nfocal-length: 50\npixel-pitch: 0.01\ndetector:\n";

    private static readonly string[] Right =
        ["aperture: 10", "exposure-time: 0.01", "band: [500, 600]", "quantum-efficiency: 0.5", "gain: 2", "adc-bits: 12"];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Read_AllKeys_BecomeTheSettings()
    {
        DetectorSettings settings = Read([
            "f-number: 5", "exposure-time: 0.02", "wavelengths: [400, 500, 700]", "quantum-efficiency: [0.1, 0.5, 0.2]",
            "transmission: 0.9", "vignetting: none", "psf: airy", "psf-wavelength: 550", "psf-radius: 4", "wing-fraction: 0.1",
            "wing-radius: 1", "wing-exponent: 3", "prnu: 0.02", "dead-pixels: [3, 4, 5, 6]", "dead-fraction: 0.001", "dark-current: 30",
            "dark-temperature: 25", "temperature: 12", "dark-doubling: 6.5", "dsnu: 0.2", "hot-pixels: [7, 8, 1000]", "hot-fraction: 0.01",
            "hot-rate: 500", "smear-row-time: 1e-6", "smear-direction: up", "smear-before-exposure: no", "cosmic-rays: 5",
            "cosmic-ray-depth: 12", "full-well: 30000", "blooming: yes", "gain: 2.5", "read-noise: 8", "bias: 50", "column-offset: 1",
            "adc-bits: 14", "seed: 18446744073709551615", "fits: no",
        ]).Settings;
        Assert.Equal(Math.PI / 4.0 * 0.01 * 0.01, settings.ApertureArea, 15); // decimals: a millionth of a millionth of it
        Assert.Equal((400.0, 700.0, 0.02), (settings.Response.Shortest, settings.Response.Longest, settings.ExposureTime));
        Assert.True(settings.IsFlatFielded && settings.IsBlooming);
        Assert.Equal(4, settings.PointSpread!.Radius);
        Assert.Equal((0.02, 0.001, 2, 2.5, 8.0), (
            settings.ResponseNonuniformity, settings.DeadFraction, settings.DeadPixels.Count, settings.Gain, settings.ReadNoise));
        Assert.Equal(new DeadPixel(5, 6), settings.DeadPixels[1]);
        Assert.Equal((30.0, 0.25, 0.2), (settings.Dark.Rate, settings.Dark.TemperatureFactor, settings.Dark.Nonuniformity));
        Assert.Equal(new HotPixel(7, 8, 1000.0), settings.Dark.HotPixels[0]);
        Assert.Equal(new Smear { RowTime = 1e-6, TowardsBottom = false, BeforeExposure = false }, settings.Smear);
        Assert.Equal(new CosmicRays { Rate = 5.0, Thickness = 12.0 }, settings.CosmicRays);
        Assert.Equal((30000.0, 50.0, 1.0, 16383, ulong.MaxValue), (
            settings.FullWell, settings.Bias, settings.ColumnOffset, settings.MaxNumber, settings.Seed));
    }

    [Fact]
    public void Read_FarWings_BecomeTheSettings()
    {
        string[] wings = [.. Right, "psf-wings: 0.05", "psf-wings-radius: 1.5", "psf-wings-exponent: 2.4", "psf-wings-reach: 900"];

        Assert.Null(Read(Right).Settings.FarWings);
        Assert.Equal(new FarWings(0.05, 1.5, 2.4, 900.0), Read(wings).Settings.FarWings);
        Assert.Contains(
            "needs 'psf-wings-exponent'", Assert.Throws<BadInputException>(() => Read([.. Right, "psf-wings: 0.1"])).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            "'psf-wings-exponent' is 2; a number above 2",
            Assert.Throws<BadInputException>(() => Read([.. wings.Select(line => line.Replace(": 2.4", ": 2", StringComparison.Ordinal))]))
                .Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Read_Shutter_BecomesTheSettings()
    {
        Assert.Null(Read(Right).Settings.Shutter);
        Assert.Equal(new Shutter { LineTime = 0.0, MaxStep = 0.25 }, Read([.. Right, "shutter: global"]).Settings.Shutter);
        Assert.Equal(
            new Shutter { LineTime = 2e-5, MaxStep = 0.1 },
            Read([.. Right, "shutter: rolling", "line-time: 2e-5", "motion-step: 0.1"]).Settings.Shutter);
    }

    /// <summary>Numbers in another unit, which would make a black image.</summary>
    [Theory]
    [InlineData("band: [500, 600]", "band: [0.5, 0.6]", "line 8, column 3: the band begins at 0.5 nm; wavelengths are in nanometres (nm)")]
    [InlineData("band: [500, 600]", "band: [99.9, 600]", "the band begins at 99.9 nm")]
    [InlineData("band: [500, 600]", "wavelengths: [0.5, 0.6]", "the band begins at 0.5 nm")]
    [InlineData("aperture: 10", "f-number: 0.4", "line 6, column 3: the f-number is 0.4, and no lens has one below 0.5")]
    [InlineData("aperture: 10", "aperture: 10000", "the f-number is 0.005, and no lens has one below 0.5")]
    public void Read_AnotherUnit_IsRefusedByTheUnitsName(string right, string wrong, string expected)
    {
        BadInputException error = Assert.Throws<BadInputException>(
            () => Parse(Text([.. Right.Select(line => line == right ? wrong : line)])));
        Assert.Contains(expected, error.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("0.6", "line 12, column 3: 'psf-wavelength' is 0.6 nm; wavelengths are in nanometres (nm), from 100 to 100000: "
        + "did you mean 600 nm, from micrometres?")]
    [InlineData("99.9", "did you mean 99900 nm, from micrometres?")]
    [InlineData("5.5e-7", "did you mean 550 nm, from metres?")]
    [InlineData("600000", "did you mean 600 nm, from picometres?")]
    [InlineData("1e30", "from 100 to 100000.")]
    public void Read_WavelengthOfThePsfInAnotherUnit_IsRefusedWithAGuess(string wavelength, string expected)
    {
        BadInputException error = Assert.Throws<BadInputException>(
            () => Parse(Text([.. Right, $"psf-wavelength: {wavelength}", "psf: airy", "psf-radius: 4"])));
        Assert.Contains(expected, error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_UnusualButPossible_IsTaken()
    {
        string[] others = [.. Right.Where(line => !line.StartsWith("band", StringComparison.Ordinal))];
        Assert.Equal(100.0, Read([.. others, "band: [100, 14000]"]).Settings.Response.Shortest);
        Assert.Equal(
            Math.PI / 4.0 * 0.1 * 0.1,
            Read(["f-number: 0.5", .. others[1..], "band: [500, 600]"]).Settings.ApertureArea, 15);
    }

    [Theory]
    [InlineData("shutter: global", "line-time: 1e-5", "'line-time' has no meaning with a global shutter")]
    [InlineData("shutter: rolling", "line-time: 0", "'line-time' is 0; a number above 0")]
    [InlineData("shutter: global", "motion-step: 0", "'motion-step' is 0; a number from 0.01 to 1")]
    public void Read_WrongShutter_SaysWhatAndWhere(string shutter, string line, string expected)
    {
        BadInputException error = Assert.Throws<BadInputException>(() => Parse(Text([.. Right, shutter, line])));
        Assert.Contains("camera.yaml, line 13, ", error.Message, StringComparison.Ordinal);
        Assert.Contains(expected, error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_SeedNone_HasNoSeed() => Assert.Null(Read([.. Right, "seed: none"]).Settings.Seed);

    [Fact]
    public void Read_NoSection_HasNoDetector() => Assert.Null(Parse("width: 64\nheight: 48\nfield-of-view: 40\n").Detector);

    // 4 sigma where they are more than 7 px, whatever 'psf-radius' would say otherwise; 3.4e-4 of a Gaussian's light lie beyond.
    [Theory]
    [InlineData("psf-sigma: 0.8", "fits: no", 7)]
    [InlineData("psf-sigma: 1.75", "fits: no", 7)]
    [InlineData("psf-sigma: 8", "fits: no", 32)]
    [InlineData("psf-sigma: 16", "fits: no", 64)]
    [InlineData("psf-sigma: 20", "psf-radius: 40", 40)]
    public void Read_GaussianWithoutRadius_ReachesFourSigma(string sigma, string other, int radius) =>
        Assert.Equal(radius, Read([.. Right, "psf: gaussian", sigma, other]).Settings.PointSpread!.Radius);

    [Fact]
    public void Read_GaussianThatPassesTheLargestKernel_IsRefused() => Assert.Contains(
        "'psf-sigma' is 16.1 px; 4 of them, 65 px, pass 64. Give 'psf-radius' to cut it off",
        Assert.Throws<BadInputException>(() => Read([.. Right, "psf: gaussian", "psf-sigma: 16.1"])).Message,
        StringComparison.Ordinal);

    /// <summary>The same weights as FITS and as NumPy file; both have the checksum in that of the camera.</summary>
    [Fact]
    public void Read_KernelFile_GivesItsWeights()
    {
        File.WriteAllBytes(_folder["k.npy"], Npy([0, 1, 0, 2, 4, 0, 0, 1, 0]));
        File.WriteAllBytes(_folder["k.fits"], Fits([0, 1, 0, 2, 4, 0, 0, 1, 0]));
        CameraFile npy = Parse(Text([.. Right, "psf: kernel", "psf-kernel: k.npy"]));
        CameraFile fits = Parse(Text([.. Right, "psf: kernel", "psf-kernel: k.fits"]));
        Assert.Equal([0.0, 0.125, 0.0, 0.25, 0.5, 0.0, 0.0, 0.125, 0.0], npy.Detector!.Settings.PointSpread!.Weights.ToArray());
        Assert.Equal(npy.Detector.Settings.PointSpread.Weights.ToArray(), fits.Detector!.Settings.PointSpread!.Weights.ToArray());
        string before = npy.Sha256;
        File.WriteAllBytes(_folder["k.npy"], Npy([0, 1, 0, 2, 4, 0, 0, 2, 0]));
        Assert.NotEqual(before, Parse(Text([.. Right, "psf: kernel", "psf-kernel: k.npy"])).Sha256);
    }

    /// <summary>A line in place of the right one of the same key, or one more; the message and the line that it names.</summary>
    [Theory]
    [InlineData("apertur: 10", 6, "'apertur' is not a key of a detector: did you mean aperture?")]
    [InlineData("aperture: -1", 6, "'aperture' is -1; a number above 0")]
    [InlineData("aperture: 0", 6, "'aperture' is 0")]
    [InlineData("aperture: wide", 6, "'aperture'")]
    [InlineData("f-number: 4", 12, "'aperture' and 'f-number' exclude each other")]
    [InlineData("exposure-time: -0.1", 7, "'exposure-time' is -0.1")]
    [InlineData("exposure-time: nan", 7, "'exposure-time'")]
    [InlineData("band: [600, 500]", 8, "the shorter one first")]
    [InlineData("band: 500", 8, "'band' has 1 number")]
    [InlineData("band: [0, 500]", 8, "above 0")]
    [InlineData("quantum-efficiency: 45", 9, "numbers from 0 to 1")]
    [InlineData("quantum-efficiency: [0.1, 0.2]", 9, "needs as many 'wavelengths'")]
    [InlineData("transmission: -0.5", 12, "numbers from 0 to 1")]
    [InlineData("wavelengths: [400, 500, 450]", 12, "number 3 of 'wavelengths' is 450; wavelengths are above 0 and increase")]
    [InlineData("wavelengths: 400", 12, "'wavelengths' has 1 number")]
    [InlineData("vignetting: some", 12, "one of natural, none is needed")]
    [InlineData("psf: gausian", 12, "did you mean gaussian?")]
    [InlineData("psf: gaussian", 6, "needs 'psf-sigma'")]
    [InlineData("psf: airy", 6, "needs 'psf-wavelength'")]
    [InlineData("psf: wings", 6, "needs 'wing-exponent'")]
    [InlineData("psf: kernel", 6, "needs 'psf-kernel'")]
    [InlineData("psf-sigma: 1", 12, "'psf-sigma' has no meaning with the PSF 'none'")]
    [InlineData("psf-radius: 100", 12, "'psf-radius' has no meaning with the PSF 'none'")]
    [InlineData("psf-wings: 1.5", 12, "a number from 0 to 1")]
    [InlineData("psf-wings-reach: 500", 12, "'psf-wings-reach' has no meaning without 'psf-wings'")]
    [InlineData("prnu: 0.5", 12, "a number from 0 to 0.2")]
    [InlineData("dead-pixels: [1, 2, 3]", 12, "2 of each pixel are needed")]
    [InlineData("dead-pixels: [65, 1]", 12, "columns go from 1 to 64")]
    [InlineData("dead-pixels: [1.5, 1]", 12, "pixel (1.5, 1)")]
    [InlineData("dead-fraction: 2", 12, "a number from 0 to 1")]
    [InlineData("dark-current: -1", 12, "a number from 0 on")]
    [InlineData("temperature: -300", 12, "a number from -273.15 to 200")]
    [InlineData("dark-doubling: 0", 12, "a number above 0")]
    [InlineData("dsnu: 0.1", 12, "'dsnu' has no meaning without 'dark-current'")]
    [InlineData("hot-pixels: [1, 1, -5]", 12, "a rate below 0")]
    [InlineData("hot-fraction: 0.1", 12, "'hot-fraction' has no meaning without 'hot-rate'")]
    [InlineData("smear-direction: down", 12, "'smear-direction' has no meaning without 'smear-row-time'")]
    [InlineData("cosmic-ray-depth: 5", 12, "no meaning without 'cosmic-rays'")]
    [InlineData("blooming: yes", 12, "'blooming' has no meaning without 'full-well'")]
    [InlineData("full-well: 0", 12, "a number above 0")]
    [InlineData("gain: 0", 10, "a number above 0")]
    [InlineData("read-noise: -3", 12, "a number from 0 on")]
    [InlineData("adc-bits: 17", 11, "a whole number from 1 to 16")]
    [InlineData("adc-bits: 12.5", 11, "a whole number from 1 to 16")]
    [InlineData("seed: -1", 12, "a whole number from 0 on, or none")]
    [InlineData("seed: random", 12, "a whole number from 0 on, or none")]
    [InlineData("fits: maybe", 12, "one of yes, no")]
    [InlineData("shutter: rollin", 12, "one of global, rolling is needed: did you mean rolling?")]
    [InlineData("shutter: rolling", 12, "a rolling shutter needs 'line-time'")]
    [InlineData("line-time: 0.001", 12, "'line-time' has no meaning without 'shutter'")]
    [InlineData("motion-step: 0.1", 12, "'motion-step' has no meaning without 'shutter'")]
    [InlineData("detector: 5", 12, "'detector'")]
    public void Read_WrongLine_SaysWhatAndWhere(string line, int expectedLine, string expected)
    {
        string key = line.Split(':')[0];
        string[] lines = key == "apertur"
            ? [line, .. Right[1..]]
            : Right.Any(right => right.Split(':')[0] == key)
                ? [.. Right.Select(right => right.Split(':')[0] == key ? line : right)]
                : [.. Right, line];
        BadInputException error = Assert.Throws<BadInputException>(() => Parse(Text(lines)));
        Assert.Contains(expected, error.Message, StringComparison.Ordinal);
        Assert.DoesNotContain('\n', error.Message);
        string place = string.Create(CultureInfo.InvariantCulture, $"camera.yaml, line {Line(expectedLine, line)}, ");
        Assert.Contains(place, error.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("aperture")]
    [InlineData("exposure-time")]
    [InlineData("band")]
    [InlineData("quantum-efficiency")]
    [InlineData("gain")]
    [InlineData("adc-bits")]
    public void Read_MissingKey_NamesItAndTheSection(string key)
    {
        BadInputException error = Assert.Throws<BadInputException>(
            () => Parse(Text([.. Right.Where(line => line.Split(':')[0] != key)])));
        Assert.Contains($"a detector needs '{key}'", error.Message, StringComparison.Ordinal);
        Assert.Contains("line 5, column 1", error.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("f-number: 4", "'f-number' needs 'focal-length' in mm")]
    [InlineData("cosmic-rays: 5", "'cosmic-rays' needs 'focal-length' and 'pixel-pitch' in mm")]
    public void Read_NoFocalLengthInMillimetres_SaysWhatNeedsIt(string line, string expected)
    {
        IEnumerable<string> lines = line.StartsWith('f') ? Right[1..].Append(line) : Right.Append(line);
        string text = $"width: 64\nheight: 48\nfield-of-view: 40\ndetector:\n{string.Concat(lines.Select(one => $"  {one}\n"))}";
        Assert.Contains(expected, Assert.Throws<BadInputException>(() => Parse(text)).Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("none.npy", "can't be read")]
    [InlineData("short.npy", "can't be used")]
    [InlineData("text.npy", "neither a FITS nor a NumPy file")]
    [InlineData("even.npy", "odd number of rows")]
    public void Read_WrongKernelFile_SaysWhatIsWrong(string name, string expected)
    {
        File.WriteAllBytes(_folder["short.npy"], Npy([1, 2, 3, 4, 5, 6, 7, 8, 9])[..130]);
        File.WriteAllText(_folder["text.npy"], "1 2 3");
        File.WriteAllBytes(_folder["even.npy"], Npy([1, 2, 3, 4]));
        BadInputException error = Assert.Throws<BadInputException>(
            () => Parse(Text([.. Right, "psf: kernel", $"psf-kernel: {name}"])));
        Assert.Contains(expected, error.Message, StringComparison.Ordinal);
    }

    /// <summary>Line of a message: of the line itself, or of the section for a key that is missing.</summary>
    private static int Line(int expected, string line) =>
        line.StartsWith("psf: ", StringComparison.Ordinal) && expected == 6 ? 5 : expected;

    private static string Text(IReadOnlyList<string> lines) => Head + string.Concat(lines.Select(line => $"  {line}\n"));

    private CameraFileDetector Read(IReadOnlyList<string> lines) => Parse(Text(lines)).Detector!;

    private CameraFile Parse(string text)
    {
        File.WriteAllText(_folder["camera.yaml"], text);
        return CameraFileReader.Read(_folder["camera.yaml"]);
    }

    private static byte[] Npy(float[] weights)
    {
        int side = (int)Math.Sqrt(weights.Length);
        string head = $"{{'descr': '<f4', 'fortran_order': False, 'shape': ({side}, {side}), }}".PadRight(117) + "\n";
        return [0x93, .. "NUMPY"u8, 1, 0, 118, 0, .. Encoding.ASCII.GetBytes(head), .. weights.SelectMany(BitConverter.GetBytes)];
    }

    private static byte[] Fits(double[] weights)
    {
        string[] cards = ["SIMPLE  =                    T", "BITPIX  =                  -64", "NAXIS   =                    2",
            "NAXIS1  =                    3", "NAXIS2  =                    3 / rows", "END"];
        byte[] header = Encoding.ASCII.GetBytes(string.Concat(cards.Select(card => card.PadRight(80))).PadRight(2880));
        return [.. header, .. weights.SelectMany(weight => BitConverter.GetBytes(weight).Reverse()), .. new byte[2808]];
    }
}
