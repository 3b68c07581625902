using System.Globalization;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Looks, as a user has them.</summary>
public sealed class LookRunTests : IDisposable
{
    private const string View = "--position=-43.3,348.8,60000 --look-at Tycho --time 2010-04-24T00:00:00Z --width 48 --height 32 --batch";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.Ldem4)]
    [InlineData("photo", "--renderer native --samples auto --shading smooth --sun disc --reflectance moon --refine 1 --exposure auto")]
    [InlineData("truth", "--renderer native --samples 1 --shading facet --sun point --surface terrain")]
    [InlineData(
        "photo --samples 4 --refine none", "--renderer native --samples 4 --shading smooth --sun disc --reflectance moon --exposure auto")]
    public void Run_Look_HasTheBytesAndTheCommandOfItsOptions(string look, string options)
    {
        Assert.Equal((0, string.Empty), Draw("look", $"--look {look}"));
        Assert.Equal((0, string.Empty), Draw("options", options));

        Assert.Equal(Bytes("options", "png"), Bytes("look", "png"));
        Assert.Equal(Bytes("options", "xml"), Bytes("look", "xml"));
        Assert.DoesNotContain("--look ", File.ReadAllText(Path.Combine(_folder["look"], "frame.xml")), StringComparison.Ordinal);
        Assert.NotEmpty(Bytes("look", "png"));
    }

    [RequiresFact(Part.Ldem4)]
    public void BatchConvert_Look_IsWrittenAsItsOptions()
    {
        string batch = _folder.Write("run.tab", "55289 2E6 2E6 0 0 0 0 1\n");
        CommandLineRun run = CommandLineRun.Of(
            ["batchconvert", "--format", "sh", "--script", _folder["b.sh"], "--pieces", "1", "--batch-file", batch, "--look", "photo",
             "--shading", "facet", "--output-dir", _folder["out"]]);

        Assert.True(run.ExitCode == 0, run.Error);
        string script = File.ReadAllText(_folder["b.sh"]);
        Assert.Contains("--samples=auto", script, StringComparison.Ordinal);
        Assert.Contains("--refine=1", script, StringComparison.Ordinal);
        Assert.Contains("--shading=facet", script, StringComparison.Ordinal);
        Assert.DoesNotContain("--look=", script, StringComparison.Ordinal);
        Assert.Matches("--exposure=[0-9]", script); // found once for all pieces
    }

    /// <summary>Options of the file that has the look stay; those of the command line go before both.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_LookOfAConfigurationFile_IsBehindItsOptions()
    {
        string config = _folder.Write("c.yaml", "look: photo\nsamples: 4\n");
        Assert.Equal((0, string.Empty), Draw("file", "--refine none", "--config", config));
        Assert.Equal((0, string.Empty), Draw(
            "options", "--renderer native --samples 4 --shading smooth --sun disc --reflectance moon --exposure auto"));
        Assert.Equal(Bytes("options", "xml"), Bytes("file", "xml"));

        Assert.Equal((0, string.Empty), Draw("line", "--look truth --samples 9", "--config", config));
        Assert.Equal((0, string.Empty), Draw("truth", "--look truth --samples 9"));
        Assert.Equal(Bytes("truth", "xml"), Bytes("line", "xml"));
    }

    [RequiresFact(Part.Ldem4)]
    public void DataSet_Look_IsItsOptions()
    {
        Assert.Equal(
            DataSet("look", "look: photo\n  samples: 4\n  refine: none"),
            DataSet("options", "samples: 4\n  shading: smooth\n  sun: disc\n  exposure: auto"));

        byte[] DataSet(string name, string options)
        {
            string file = _folder.Write(
                $"{name}.yaml",
                "name: set\ncount: 1\nseed: 1\nstates:\n  altitude: 200e3\n  sun-elevation: [20, 40]\n"
                + $"options:\n  width: 32\n  height: 24\n  {options}\n");
            CommandLineRun run = CommandLineRun.Of(["dataset", file, "--output-dir", _folder[name], "--batch"]);
            Assert.True(run.ExitCode == 0, run.Error);
            return File.ReadAllBytes(Path.Combine(_folder[name], "000001.xml"));
        }
    }

    /// <summary>
    /// The exposure of a small image without several samples is counted again from its own radiance factors: 99.5 % of the lit pixels stay
    /// below white, half of them at 0.35 or below. A low Sun needs more of it, and the frames of a series have one.
    /// </summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_ExposureAuto_FitsTheLitPixelsOfTheRun()
    {
        const string Auto = "--renderer native --exposure auto --layers radiance-factor --layers-format npy --time";
        (double high, float[] bright) = Exposed("high", $"{Auto} 2010-04-29T00:00:00Z");
        (double low, float[] faint) = Exposed("low", $"{Auto} 2010-04-23T12:00:00Z");
        (double both, _) = Exposed("both", $"{Auto}s {{2010-04-29T00:00:00Z,2010-04-23T12:00:00Z}}");

        Assert.Equal(Expected(bright), high, 0.005 * high); // three digits
        Assert.Equal(Expected(faint), low, 0.005 * low);
        Assert.True(low > 2.0 * high, $"{low} and {high}");
        Assert.InRange(both, high, low);
        Assert.Equal(Expected([.. bright, .. faint]), both, 0.005 * both);

        static double Expected(float[] radianceFactors)
        {
            float[] lit = [.. radianceFactors.Where(factor => factor > 0.0f).Order()];
            return Math.Min(1.0 / lit[(int)(0.995 * (lit.Length - 1))], 0.35 / lit[lit.Length / 2]);
        }
    }

    [Theory]
    [InlineData("--look photo --renderer povray", "--look photo is drawn by the native renderer. Leave --renderer povray out")]
    [InlineData("--look foto", "--look is 'foto'; one of thesis, truth, photo is needed: did you mean photo?")]
    public void Run_WrongLook_IsOneClearLine(string look, string message)
    {
        CommandLineRun run = CommandLineRun.Of([.. $"{View} {look}".Split(' ')]);

        Assert.Equal(1, run.ExitCode);
        Assert.StartsWith($"msis: error: {message}", run.Error, StringComparison.Ordinal);
    }

    /// <summary>The exposure in the first frame's arguments, and its radiance factors.</summary>
    private (double Exposure, float[] RadianceFactors) Exposed(string folder, string options)
    {
        CommandLineRun run = CommandLineRun.Of(
            [.. $"{View.Replace("--time 2010-04-24T00:00:00Z ", string.Empty, StringComparison.Ordinal)} {options}".Split(' '),
             "--output-dir", _folder[folder], "--output-name", "{step:0}"]);
        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Contains("msis: --exposure auto: ", run.Error, StringComparison.Ordinal);
        string arguments = File.ReadAllText(Path.Combine(_folder[folder], "1.xml"));
        byte[] layer = File.ReadAllBytes(Path.Combine(_folder[folder], "1.radiance-factor.npy"));
        double[] numbers = new double[48 * 32];
        Buffer.BlockCopy(layer, layer.Length - (sizeof(double) * numbers.Length), numbers, 0, sizeof(double) * numbers.Length);
        return (
            double.Parse(arguments.Split("--exposure ")[1].Split(' ')[0], CultureInfo.InvariantCulture),
            [.. numbers.Select(number => (float)number)]);
    }

    private (int ExitCode, string Error) Draw(string folder, string options, params string[] more)
    {
        CommandLineRun run = CommandLineRun.Of(
            [.. $"{View} {options}".Split(' '), "--output-dir", _folder[folder], "--output-name", "frame", .. more]);
        return (run.ExitCode, run.ExitCode == 0 ? string.Empty : run.Error);
    }

    private byte[] Bytes(string folder, string extension) => File.ReadAllBytes(Path.Combine(_folder[folder], $"frame.{extension}"));
}
