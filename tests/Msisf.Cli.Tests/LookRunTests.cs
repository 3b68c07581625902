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
    [InlineData("photo", "--renderer native --samples auto --shading smooth --sun disc --reflectance moon --refine 1")]
    [InlineData("truth", "--renderer native --samples 1 --shading facet --sun point --surface terrain")]
    [InlineData("photo --samples 4 --refine none", "--renderer native --samples 4 --shading smooth --sun disc --reflectance moon")]
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
    }

    /// <summary>Options of the file that has the look stay; those of the command line go before both.</summary>
    [RequiresFact(Part.Ldem4)]
    public void Run_LookOfAConfigurationFile_IsBehindItsOptions()
    {
        string config = _folder.Write("c.yaml", "look: photo\nsamples: 4\n");
        Assert.Equal((0, string.Empty), Draw("file", "--refine none", "--config", config));
        Assert.Equal((0, string.Empty), Draw("options", "--renderer native --samples 4 --shading smooth --sun disc --reflectance moon"));
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
            DataSet("options", "samples: 4\n  shading: smooth\n  sun: disc"));

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

    [Theory]
    [InlineData("--look photo --renderer povray", "--look photo is drawn by the native renderer. Leave --renderer povray out")]
    [InlineData("--look foto", "--look is 'foto'; one of thesis, truth, photo is needed: did you mean photo?")]
    public void Run_WrongLook_IsOneClearLine(string look, string message)
    {
        CommandLineRun run = CommandLineRun.Of([.. $"{View} {look}".Split(' ')]);

        Assert.Equal(1, run.ExitCode);
        Assert.StartsWith($"msis: error: {message}", run.Error, StringComparison.Ordinal);
    }

    private (int ExitCode, string Error) Draw(string folder, string options, params string[] more)
    {
        CommandLineRun run = CommandLineRun.Of(
            [.. $"{View} {options}".Split(' '), "--output-dir", _folder[folder], "--output-name", "frame", .. more]);
        return (run.ExitCode, run.ExitCode == 0 ? string.Empty : run.Error);
    }

    private byte[] Bytes(string folder, string extension) => File.ReadAllBytes(Path.Combine(_folder[folder], $"frame.{extension}"));
}
