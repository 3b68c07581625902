using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Sites beside and in each other in a model of the whole Moon, as GeoTIFF.</summary>
public sealed class SiteModelTests : IDisposable
{
    /// <summary>Writes a polar GeoTIFF. Arguments: path, left, top, samples a side, m a sample, heights by x and y.</summary>
    private const string Script = """
        import sys
        import numpy as np
        from osgeo import gdal, osr
        path, left, top, side, pixel, expression = sys.argv[1:7]
        system = osr.SpatialReference()
        system.ImportFromProj4('+proj=stere +lat_0=-90 +lon_0=0 +R=1737400')
        data = gdal.GetDriverByName('GTiff').Create(path, int(side), int(side), 1, gdal.GDT_Float32)
        data.SetGeoTransform([float(left), float(pixel), 0, float(top), 0, -float(pixel)])
        data.SetProjection(system.ExportToWkt())
        y, x = np.mgrid[0:int(side), 0:int(side)]
        data.GetRasterBand(1).SetNoDataValue(-9999)
        data.GetRasterBand(1).WriteArray(eval(expression).astype('f4'))
        """;

    private const string Hilly = "20 * np.sin(x / 9) - 1000 + 0 * y";
    private const string Holed = "np.where((abs(x - 100) < 50) & (abs(y - 100) < 50), -9999, 20 * np.sin(x / 9) - 1000)";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>Two sites that do not touch, and one wholly inside another's hole, with ground of the Moon's model between.</summary>
    [RequiresTheory(Part.Ldem4, Part.Gdal, Part.GdalLibrary)]
    [InlineData(Hilly, 112_000, 98_000)]
    [InlineData(Holed, 104_000, 96_000)]
    public void Run_SitesBesideAndInEachOther_AreAllDrawn(string expression, int left, int top)
    {
        string outer = Site("outer.tif", 100_000, 100_000, 200, 50, expression);
        string inner = Site("inner.tif", left, top, 100, 20, Hilly);

        CommandLineRun run = Draw(outer, inner);

        Assert.True(run.ExitCode == 0, run.Error);
        byte[] file = File.ReadAllBytes(Path.Combine(_folder["out"], "site.source.npy"));
        int start = file.Length - (64 * 64 * 8);
        (int, int)[] sources = [.. Enumerable.Range(0, 64 * 64).Select(pixel => (
            BitConverter.ToInt32(file, start + (8 * pixel)), BitConverter.ToInt32(file, start + (8 * pixel) + 4)))];
        Assert.Contains((0, 2), sources); // the Moon's own ground, blended to meet them
        Assert.InRange(sources.Count(source => source == (1, 1)), 100, 2500);
        Assert.InRange(sources.Count(source => source == (2, 1)), 10, 1000);
    }

    [RequiresFact(Part.Ldem4, Part.Gdal, Part.GdalLibrary)]
    public void Run_SiteWithoutAnyData_SaysSo()
    {
        CommandLineRun run = Draw(Site("none.tif", 100_000, 100_000, 200, 50, "-9999.0 + 0 * x"));

        Assert.Equal(2, run.ExitCode);
        Assert.Contains("none has no cell whose samples all have data. Give a file with heights", run.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(_folder["out"]) && Directory.EnumerateFiles(_folder["out"]).Any());
    }

    private CommandLineRun Draw(params string[] sites) => CommandLineRun.Of(
    [
        "--renderer", "native", "--ldem", TestParts.Ldem4Label!, .. sites.SelectMany(site => new[] { "--ldem", site }),
        "--position=-85.3,48.5,30000", "--time", "2026-01-10T00:00:00Z", "--ignore-sun", "--batch", "--width", "64", "--height", "64",
        "--fov", "50", "--layers", "source", "--layers-format", "npy", "--output-dir", _folder["out"], "--output-name", "site",
    ]);

    private string Site(string name, int left, int top, int side, int pixel, string expression)
    {
        string path = _folder[name];
        ChildRun.Of(
            TestParts.Python!, ["-c", Script, path, $"{left}", $"{top}", $"{side}", $"{pixel}", expression], _folder.Path).Succeeded();
        return path;
    }
}
