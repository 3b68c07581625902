using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>GeoTIFFs in a model of the whole Moon: holes, names, borders.</summary>
public sealed class SeveralGeoTiffsTests : IDisposable
{
    /// <summary>
    /// Writes 120 x 120 pixels of 2 km; arguments: path, m of its left side, height, value of a hole of 40 km in its middle, value that is
    /// declared as no data (or -).
    /// </summary>
    private const string Script = """
        import struct, sys
        from osgeo import gdal, osr
        gdal.UseExceptions()
        path, left, height, hole, declared = sys.argv[1], float(sys.argv[2]), float(sys.argv[3]), float(sys.argv[4]), sys.argv[5]
        data = gdal.GetDriverByName('GTiff').Create(path, 120, 120, 1, gdal.GDT_Float32)
        band = data.GetRasterBand(1)
        if declared != '-':
            band.SetNoDataValue(float(declared))
        for line in range(120):
            row = [hole if 50 <= line < 70 and 50 <= sample < 70 else height + line for sample in range(120)]
            band.WriteRaster(0, line, 120, 1, struct.pack('<120f', *row))
        data.SetGeoTransform([left, 2000.0, 0.0, 120000.0, 0.0, -2000.0])
        system = osr.SpatialReference()
        system.ImportFromProj4('+proj=stere +lat_0=-90 +R=1737400')
        data.SetProjection(system.ExportToWkt())
        """;

    private readonly TemporaryFolder _folder = new();
    private readonly string _moon;

    public SeveralGeoTiffsTests() => _moon = SyntheticModels.Make(_folder["model"], "--res", "2");

    public void Dispose() => _folder.Dispose();

    /// <summary>The hole shows the coarser model; without one it is an error that names it.</summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Run_GeoTiffWithAHole_IsFilledByTheCoarserModelOrRefused()
    {
        string hole = Write("hole.tif", hole: "-9999", declared: "-9999");
        CommandLineRun filled = Draw("filled", _moon, hole);
        CommandLineRun alone = Draw("alone", hole);

        Assert.True(filled.ExitCode == 0, filled.Error);
        Assert.NotEqual(1, PartAt("filled", 20, 20)); // the middle of the hole: the Moon's model, or the seam to it
        Assert.Equal(1, PartAt("filled", 6, 20)); // 14 px of 2.3 km beside it
        Assert.Equal(1, PartAt("filled", 20, 35));
        Assert.Equal(2, alone.ExitCode);
        Assert.Matches(@"hole\.tif, line (5[1-9]|6\d|70), sample (5[1-9]|6\d|70): no data there\. Fill the hole", alone.Error);
        Assert.False(File.Exists(Path.Combine(_folder["alone"], "a.png")));
    }

    /// <summary>A file that does not say which of its values are none has the same picture, and a note.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("nan")]
    [InlineData("-32768")]
    public void Run_HoleThatIsNotDeclared_IsAHoleWithANote(string value)
    {
        CommandLineRun declared = Draw("declared", _moon, Write("hole.tif", hole: value, declared: value));
        CommandLineRun silent = Draw("silent", _moon, Write("hole.tif", hole: value, declared: "-"));

        Assert.True(declared.ExitCode + silent.ExitCode == 0, declared.Error + silent.Error);
        Assert.Equal(
            File.ReadAllBytes(Path.Combine(_folder["declared"], "a.png")), File.ReadAllBytes(Path.Combine(_folder["silent"], "a.png")));
        Assert.Contains("hole: 400 pixels cannot be heights", silent.Error, StringComparison.Ordinal);
        Assert.DoesNotContain("no heights", declared.Error, StringComparison.Ordinal);
    }

    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Run_FilesOfOneNameInTwoFolders_HaveTheSameBytesInEitherOrder()
    {
        string low = Write("a/site.tif", height: "100");
        string high = Write("b/site.tif", left: "-60000", height: "400");

        CommandLineRun one = Draw("one", _moon, low, high);
        CommandLineRun other = Draw("other", high, _moon, low);

        Assert.True(one.ExitCode + other.ExitCode == 0, one.Error + other.Error);
        string[] names = [.. Directory.EnumerateFiles(_folder["one"], "a*").Select(path => Path.GetFileName(path)!).Order()];
        Assert.Equal(["a.cell.npy", "a.layers.json", "a.mask.npy", "a.png", "a.xml"], names);
        Assert.All(names, name => Assert.Equal(
            File.ReadAllBytes(Path.Combine(_folder["one"], name)), File.ReadAllBytes(Path.Combine(_folder["other"], name))));
    }

    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Run_BorderOffTheModelAround_IsTold()
    {
        string high = Write("site.tif", height: "9000"); // the synthetic Moon is within some km of its sphere

        CommandLineRun run = Draw("out", _moon, high);

        Assert.True(run.ExitCode == 0, run.Error);
        Assert.Matches(
            @"site does not meet the ground of the models around it: along its border it lies \d{4,5}\.\d m above it in the mean "
                + @"\(\d{4,5}\.\d m rms\), at most \d{4,5}\.\d m above, and rises inwards -?\d\.\d degrees more steeply .*\. "
                + @"The difference is carried into that ground over \d{4}\.\d km and more\.",
            run.Error);
    }

    private string Write(string name, string left = "-120000", string height = "5000", string? hole = null, string declared = "-")
    {
        string path = _folder[name];
        Directory.CreateDirectory(Path.GetDirectoryName(path)!);
        ChildRun.Of(TestParts.Python!, ["-c", Script, path, left, height, hole ?? height, declared], _folder.Path).Succeeded();
        return path;
    }

    private CommandLineRun Draw(string folder, params string[] models) => CommandLineRun.Of(
        ["--fixed-state", "{51544.5,0,0,-2E6,0,0.7071067811865476,0,0.7071067811865476}", "--ignore-sun", "--batch", "--width", "41",
            "--height", "41", "--fov", "20", "--lod", "off", "--renderer", "native", "--surface", "terrain", "--grid", "10",
            "--layers", "cell,mask", "--layers-format", "npy", .. models.SelectMany(model => (string[])["--ldem", model]),
            "--output-dir", _folder[folder], "--output-name", "a"]);

    private int PartAt(string folder, int x, int y)
    {
        byte[] cell = File.ReadAllBytes(Path.Combine(_folder[folder], "a.cell.npy"));
        return BitConverter.ToInt32(cell, cell.Length - (41 * 41 * 3 * 4) + (12 * ((41 * y) + x)) + 8);
    }
}
