using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Synthesis;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

public sealed class PyramidCommandTests : IDisposable
{
    private static readonly Lazy<(byte[] Label, byte[] Image)> Model = new(() =>
    {
        using TemporaryFolder folder = new();
        string label = SyntheticLdemWriter.Write(new SyntheticLdemOptions(4, Seed: 1, folder.Path), null, CancellationToken.None);
        return (File.ReadAllBytes(label), File.ReadAllBytes(Path.ChangeExtension(label, ".IMG")));
    });

    private readonly TemporaryFolder _folder = new();
    private readonly string _label;

    public PyramidCommandTests()
    {
        _label = _folder.Write("LDEM_4_SYNTHETIC.LBL", Model.Value.Label);
        _folder.Write("LDEM_4_SYNTHETIC.IMG", Model.Value.Image);
    }

    private string Sidecar => Path.ChangeExtension(_label, ".pyramid");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Pyramid_LabelThenFolder_MakesAndVerifiesTheFileBeside()
    {
        CommandLineRun made = CommandLineRun.Of(["ldem", "pyramid", _label, "--batch"]);
        CommandLineRun verified = CommandLineRun.Of(["ldem", "pyramid", _folder.Path, "--res", "4", "--verify"]);

        Assert.Equal((0, Sidecar + "\n"), (made.ExitCode, made.Output.ReplaceLineEndings("\n")));
        Assert.True(File.Exists(Sidecar));
        Assert.Equal((0, Sidecar + "\n"), (verified.ExitCode, verified.Output.ReplaceLineEndings("\n")));
        Assert.Contains("is whole, and made of the samples that LDEM_4_SYNTHETIC has", verified.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Verify_NoSidecar_SaysHowToMakeIt()
    {
        CommandLineRun run = CommandLineRun.Of(["ldem", "pyramid", _label, "--verify"]);

        Assert.Equal((2, string.Empty), (run.ExitCode, run.Output));
        Assert.Contains("LDEM_4_SYNTHETIC.pyramid: missing. Make it with 'msis ldem pyramid'.", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Verify_SidecarOfAnotherModel_SaysWhy()
    {
        File.WriteAllText(Sidecar, "not a pyramid");
        CommandLineRun run = CommandLineRun.Of(["ldem", "pyramid", _label, "--verify"]);

        Assert.Equal(2, run.ExitCode);
        Assert.Contains(
            "LDEM_4_SYNTHETIC.pyramid: it is damaged, or no pyramid of this version; it is not used.", run.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("auto", true)]
    [InlineData("off", false)]
    public void Render_DamagedSidecar_IsWarnedAboutWhereLevelsAreUsed(string levels, bool isWarned)
    {
        File.WriteAllText(Sidecar, "not a pyramid");
        CommandLineRun run = CommandLineRun.Of(
        [
            "--fixed-state", "{55289,2E6,2E6,0,0,0,3.826834323650898E-1,9.238795325112867E-1}", "--ignore-sun", "--fov", "1", "--width",
            "8", "--height", "8", "--lod", levels, "--ldem", _label,
            "--pattern-repos", Path.Combine(_folder.Path, "patterns"), "--output-dir", Path.Combine(_folder.Path, "out"), "--pov-path",
            "/bin/false", "--batch",
        ]);

        Assert.Equal(3, run.ExitCode); // that is no POV-Ray
        Assert.Contains("/bin/false", run.Error, StringComparison.Ordinal);
        Assert.Equal(isWarned, run.Error.Contains("LDEM_4_SYNTHETIC.pyramid: it is damaged", StringComparison.Ordinal));
    }
}
