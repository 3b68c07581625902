using System.Buffers.Binary;
using System.Text.RegularExpressions;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Fill values in a model of LOLA's format, as a user has them: no pits, one note, and a coarser model in the holes.</summary>
public sealed class FillValuesRunTests(SmallMoon moon) : IClassFixture<SmallMoon>, IDisposable
{
    private const string View = "--renderer native --position=3,7,90000 --time 2026-01-08T00:00:00Z --ignore-sun --width 60 --height 60 "
        + "--fov 60 --lod off --layers height,source --layers-format npy --batch";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Run_ModelWithFillValues_LeavesThemToTheModelAround()
    {
        string label = Holed();
        string around = Directory.GetFiles(moon.Options[1], "*.LBL").Single();
        CommandLineRun run = Draw("both", "--ldem", label, "--ldem", around);

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Single(Regex.Matches(run.Error, "256 pixels cannot be heights, though the file does not say that they have no data"));
        Assert.Contains(" (-32768)", run.Error, StringComparison.Ordinal);
        double[] heights = [.. Layer("both", "height", 8).Select(value => BitConverter.ToDouble(value))];
        Assert.All(heights, height => Assert.InRange(height, -9_500.0, 11_500.0));
        int[] models = [.. Layer("both", "source", 8).Select(value => BitConverter.ToInt32(value))];
        Assert.Equal([0, 1], models.Distinct().Order());

        CommandLineRun alone = Draw("alone", "--ldem", label);
        Assert.Equal(2, alone.ExitCode);
        Assert.Contains("line 341, sample 21: no data there. Put a coarser model around it", alone.Error, StringComparison.Ordinal);
    }

    /// <summary>A model of the whole Moon whose label allows all numbers of 16 bits, with 16 x 16 in view that are no heights.</summary>
    private string Holed()
    {
        CommandLineRun made = CommandLineRun.Of(["ldem", "synthesize", "--res", "4", "--seed", "1", "--output-dir", _folder["holed"]]);
        Assert.True(made.ExitCode == 0, made.Error);
        string label = Directory.GetFiles(_folder["holed"], "*.LBL").Single();
        string text = Regex.Replace(File.ReadAllText(label), "MINIMUM( +)= -?[0-9]+", "MINIMUM$1= -32768");
        File.WriteAllText(label, Regex.Replace(text, "PRODUCT_ID( +)= .*", "PRODUCT_ID$1= \"LDEM_4\"")); // no synthetic product
        string image = Directory.GetFiles(_folder["holed"], "*.IMG").Single();
        byte[] samples = File.ReadAllBytes(image);
        for (int i = 0; i < 256; i++)
        {
            (int line, int sample) = (340 + (i / 16), 20 + (i % 16)); // around 3 degrees north, 7 east
            BinaryPrimitives.WriteInt16LittleEndian(samples.AsSpan(2 * ((line * 1440) + sample)), -32768);
        }

        File.WriteAllBytes(image, samples);
        return label;
    }

    private CommandLineRun Draw(string name, params string[] models) =>
        CommandLineRun.Of([.. View.Split(' '), .. models, "--output-dir", _folder["out"], "--output-name", name]);

    private byte[][] Layer(string name, string layer, int bytes) =>
        [.. File.ReadAllBytes(_folder[$"out/{name}.{layer}.npy"])[^(60 * 60 * bytes)..].Chunk(bytes)];
}
