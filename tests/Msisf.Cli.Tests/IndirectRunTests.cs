using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Light from the ground together with other options, as a user has it.</summary>
public sealed class IndirectRunTests(SmallMoon moon) : IClassFixture<SmallMoon>, IDisposable
{
    /// <summary>From 2 km; the Sun stands 8 degrees over the horizon.</summary>
    private const string View = "--renderer native --position=12,5,terrain+2000 --time 2000-01-01T00:00:00Z --ephemeris builtin "
        + "--sun-position {8E9,1.5E11,0} --width 16 --height 16 --fov 40 --exposure 20 --reflectance lambert --albedo 0.3 --batch "
        + "--layers-format npy --indirect --indirect-error 0.2";

    private const string Line = "focal-length: 10\npixel-pitch: 0.02\nwidth: 40\nheight: 1\nscan:\n  kind: line-scan\n  period: 0.6\n";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>Invented ground shades, and throws light into its shadows.</summary>
    [Fact]
    public void Run_Refined_InventedGroundThrowsLight()
    {
        moon.Draw(_folder["a"], [.. View.Split(' '), "--refine", "7", "--refine-cell", "32", "--layers", "mask,indirect,radiance-factor"]);
        moon.Draw(_folder["plain"], [.. View.Split(' '), "--layers", "mask,indirect"]);

        double[] light = Doubles("a", "indirect");
        double[] whole = Doubles("a", "radiance-factor");
        byte[] mask = File.ReadAllBytes(FileOf("a", "mask"))[^256..];
        int[] dark = [.. Enumerable.Range(0, 256).Where(pixel => mask[pixel] == 3)];
        Assert.InRange(dark.Length, 14, 242);
        Assert.All(dark, pixel => Assert.Equal(light[pixel], whole[pixel]));
        Assert.InRange(dark.Count(pixel => light[pixel] > 0.0), 0.75 * dark.Length, dark.Length);
        Assert.All(light, value => Assert.InRange(value, 0.0, 0.3 * 0.3));

        // The model's own facets, kilometres wide, are nearly flat here: they throw much less light on each other.
        Assert.InRange(Doubles("plain", "indirect").Average(), 0.0, 0.5 * light.Average());
    }

    /// <summary>A frame with light from the ground can take minutes: it tells how far it is, and how long it still takes.</summary>
    [Fact]
    public void Run_OneFrame_TellsItsProgress()
    {
        CommandLineRun run = CommandLineRun.Of(
            [.. View.Split(' '), "--layers", "mask", "--output-dir", _folder["a"], .. moon.Options]);
        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Contains("100 of 100 done (", run.Error, StringComparison.Ordinal);
        Assert.Contains("00:00:00 left", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Run_Scan_IsRefused()
    {
        using TemporaryFolder files = new();
        string[] scan =
        [
            "--kepler-set", "{1.86E6,0,0,0,0,0}", "--epoch", "55289", "--time", "55289", "--renderer", "native", "--camera",
            files.Write("line.yaml", Line), "--lines", "8", "--batch", "--indirect", .. moon.Options,
        ];
        RefusedRun.Check(
            _folder, scan, 1,
            "--indirect is not for cameras that scan: the ground around would have to be lit anew for each of their rows. "
                + "Leave it out, or take a camera that sees its image at once.");
    }

    private string FileOf(string folder, string layer) => Directory.GetFiles(_folder[folder], $"*.{layer}.npy").Single();

    private double[] Doubles(string folder, string layer)
    {
        byte[] file = File.ReadAllBytes(FileOf(folder, layer));
        return [.. Enumerable.Range(-256, 256).Select(pixel => BitConverter.ToDouble(file, file.Length + (8 * pixel)))];
    }
}
