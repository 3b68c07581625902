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

    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Pyramid_LargeMap_KeepsWhatItsPixelsAreAndChecksIt()
    {
        // 4100 x 4100 px, of which one block is not 0; another map is small.
        const string Script = """
            import sys
            from osgeo import gdal, osr
            system = osr.SpatialReference()
            system.ImportFromProj4('+proj=stere +lat_0=-90 +R=1737400')
            for name, size in (('large.tif', 4100), ('small.tif', 100)):
                data = gdal.GetDriverByName('GTiff').Create(
                    sys.argv[1] + '/' + name, size, size, 1, gdal.GDT_Int16, ['TILED=YES', 'SPARSE_OK=TRUE'])
                data.SetGeoTransform([50000, 5, 0, 50000, 0, -5])
                data.SetProjection(system.ExportToWkt())
                data.GetRasterBand(1).WriteRaster(8, 8, 1, 1, b'\x64\x00')
            """;
        ChildRun.Of(TestParts.Python!, ["-c", Script, _folder.Path], _folder.Path).Succeeded();
        string scan = _folder["large.scan"];
        string[] words = ["ldem", "pyramid", _folder["large.tif"]];

        CommandLineRun missing = CommandLineRun.Of([.. words, "--verify"]);
        CommandLineRun made = CommandLineRun.Of([.. words, "--batch"]);
        CommandLineRun verified = CommandLineRun.Of([.. words, "--verify"]);
        byte[] bytes = File.ReadAllBytes(scan);
        bytes[^1000] ^= 1;
        File.WriteAllBytes(scan, bytes);
        CommandLineRun damaged = CommandLineRun.Of([.. words, "--verify"]);
        CommandLineRun small = CommandLineRun.Of(["ldem", "pyramid", _folder["small.tif"]]);

        Assert.Equal((0, scan + "\n"), (made.ExitCode, made.Output.ReplaceLineEndings("\n")));
        Assert.Equal((0, scan + "\n"), (verified.ExitCode, verified.Output.ReplaceLineEndings("\n")));
        Assert.All([missing, damaged], run => Assert.Equal((2, string.Empty), (run.ExitCode, run.Output)));
        Assert.Contains("large.tif: no file beside it holds what its pixels are", damaged.Error, StringComparison.Ordinal);
        Assert.Equal((0, string.Empty), (small.ExitCode, small.Output));
        Assert.Contains("small is so small that each run looks at all its pixels", small.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Pyramid_PolarMapInPds3_SaysThatItNeedsNone()
    {
        CommandLineRun.Of(
        [
            "ldem", "synthesize", "--projection", "polar-south", "--map-scale", "20000", "--seed", "1", "--output-dir", _folder.Path,
            "--batch",
        ]);
        string label = Assert.Single(Directory.GetFiles(_folder.Path, "LDEM_*M_SYNTHETIC.LBL"));

        CommandLineRun run = CommandLineRun.Of(["ldem", "pyramid", label]);

        Assert.Equal((2, string.Empty), (run.ExitCode, run.Output));
        Assert.Contains("a polar map in PDS3 needs no pyramid", run.Error, StringComparison.Ordinal);
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
