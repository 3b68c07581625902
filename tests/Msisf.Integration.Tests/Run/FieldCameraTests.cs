using System.Globalization;
using System.Text.Json;
using System.Xml.Linq;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>Cameras by instrument kernels from the command line: reproductions of faults, against their expected directions.</summary>
public sealed class FieldCameraTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>Part of the WAC's kernel: which pixel is counted from is not in it.</summary>
    [RequiresTheory(Part.Field, Part.CSpice, Part.Ldem4)]
    [InlineData("builtin")]
    [InlineData("cspice")]
    public void WideAngleCamera_PartOfItsKernel_IsRefused(string engine)
    {
        CommandLineRun run = Run("01", "wac.ti", "-85634", engine);

        Assert.Equal(2, run.ExitCode);
        Assert.Contains("No kernel has INS-85634_FILTER_OFFSET of WACX. Add its instrument kernel", run.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(_folder["out"]));
    }

    /// <summary>Directions in the instrument's axes, from the pixel by the meta file's K, R and lens alone.</summary>
    [RequiresTheory(Part.Field, Part.CSpice, Part.Ldem4)]
    [InlineData("builtin")]
    [InlineData("cspice")]
    public void KaguyaTerrainCamera_EachPixel_HasTheKernelsDirection(string engine)
    {
        const double Pixel = 0.007 / 72.45; // of the tangents

        CommandLineRun run = Run("04", "tc.ti", "-131351", engine);

        Assert.True(run.ExitCode == 0, run.Error);
        XElement camera = XDocument.Load(_folder["out/o.xml"]).Descendants("Camera").Single();
        double[] k = Numbers(camera.Element("K")!);
        double[] lens = Numbers(camera.Element("Distortion")!);
        Assert.Equal("polynomial-x", camera.Element("Distortion")!.Attribute("model")!.Value);
        using JsonDocument expected = JsonDocument.Parse(File.ReadAllText(Path.Combine(TestParts.Field!, "04", "expected.json")));
        JsonElement[] pixels = [.. expected.RootElement.GetProperty("pixels (sample, line), from 1").EnumerateArray()];
        JsonElement[] directions = [.. expected.RootElement.GetProperty("right x/z, y/z in instrument axes").EnumerateArray()];
        Assert.Equal(5, pixels.Length);
        foreach ((JsonElement pixel, JsonElement direction) in pixels.Zip(directions))
        {
            double x = (pixel[0].GetDouble() - 1.0 - k[2]) / k[0];
            double y = (pixel[1].GetDouble() - 1.0 - k[5]) / k[4];
            double right = x + lens[0] + (x * (lens[1] + (x * (lens[2] + (x * lens[3])))));
            double down = y + lens[4] + (x * (lens[5] + (x * (lens[6] + (x * lens[7])))));

            // The image's right is the instrument's -y, down its +x.
            Assert.Equal(direction[0].GetDouble(), down, 1e-6 * Pixel);
            Assert.Equal(direction[1].GetDouble(), -right, 1e-6 * Pixel);
        }
    }

    private static double[] Numbers(XElement element) =>
    [
        .. element.Value.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries)
            .Select(number => double.Parse(number, CultureInfo.InvariantCulture)),
    ];

    private CommandLineRun Run(string name, string kernel, string instrument, string engine)
    {
        string In(string file) => Path.Combine(TestParts.Field!, name, file);
        return CommandLineRun.Of(
        [
            "--spk", In("orbit.bsp"), "--spacecraft", "-777", "--ck", In("attitude.bc"), "--instrument", instrument, "--kernels",
            In("clock.tsc"), "--kernels", In("frames.tf"), "--kernels", In(kernel), "--time", "2010-04-06T20:11:35.5Z", "--renderer",
            "native", "--ephemeris", engine, "--output-dir", _folder["out"], "--output-name", "o", "--batch",
        ]);
    }
}
