using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Tiles beside each other are the ground that they would be as one map.</summary>
public sealed class NeighbouringTilesTests : IDisposable
{
    /// <summary>m: facets between the outermost samples of two tiles are cut otherwise than cells of one map.</summary>
    private const double OtherDiagonals = 2.0;

    /// <summary>Writes maps. Arguments: folder, then name, north, west, height, width in degrees of each.</summary>
    private const string Script = """
        import sys
        import numpy as np
        from osgeo import gdal, osr
        system = osr.SpatialReference()
        system.ImportFromProj4('+proj=longlat +R=1737400')
        for i in range(2, len(sys.argv), 5):
            name, (north, west, height, width) = sys.argv[i], map(int, sys.argv[i + 1:i + 5])
            data = gdal.GetDriverByName('GTiff').Create(f'{sys.argv[1]}/{name}.tif', 40 * width, 40 * height, 1, gdal.GDT_Float32)
            data.SetProjection(system.ExportToWkt())
            data.SetGeoTransform([west, 1 / 40, 0, north, 0, -1 / 40])
            y = np.radians(north - (np.arange(40 * height) + 0.5) / 40)[:, None]
            x = np.radians(west + (np.arange(40 * width) + 0.5) / 40)[None, :]
            data.GetRasterBand(1).SetUnitType('m')
            data.GetRasterBand(1).WriteArray((400 * np.sin(60 * y) * np.cos(50 * x) - 1500).astype('f4'))
        """;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.Ldem4, Part.Gdal, Part.GdalLibrary)]
    [InlineData("a 12 18 2 2 b 12 20 2 2", "one 12 18 2 4", 11, 20)] // beside each other
    [InlineData("a 12 18 2 2 b 10 18 2 2", "one 12 18 4 2", 10, 19)] // above each other
    [InlineData("a 1 358 2 2 b 1 0 2 2", "one 1 358 2 4", 0, 0)] // across the prime meridian
    [InlineData("a 12 18 2 2 b 12 20 2 2 c 10 18 2 2 d 10 20 2 2", "one 12 18 4 4", 10, 20)] // four at a corner
    public void Run_TilesBesideEachOther_HaveNoSeam(string tiles, string whole, int latitude, int longitude)
    {
        string[] names = [.. tiles.Split(' ').Chunk(5).Select(tile => tile[0])];
        ChildRun.Of(TestParts.Python!, ["-c", Script, _folder.Path, .. tiles.Split(' '), .. whole.Split(' ')], _folder.Path).Succeeded();
        double[] parts = Heights("parts", latitude, longitude, names);
        double[] one = Heights("one", latitude, longitude, "one");
        Assert.True(one.Max() - one.Min() > 100.0, "the ground has relief");
        for (int i = 0; i < one.Length; i++)
        {
            Assert.Equal(one[i], parts[i], OtherDiagonals);
        }
    }

    private double[] Heights(string name, int latitude, int longitude, params string[] tiles)
    {
        CommandLineRun run = CommandLineRun.Of(
        [
            "--renderer", "native", "--ldem", TestParts.Ldem4Label!,
            .. tiles.SelectMany(tile => new[] { "--ldem", _folder[tile + ".tif"] }),
            $"--position={latitude},{longitude},12000", "--time", "2026-01-08T00:00:00Z", "--ignore-sun", "--batch", "--width", "48",
            "--height", "48", "--fov", "60", "--lod", "off", "--albedo-map", "none", "--layers", "height", "--layers-format", "npy",
            "--output-dir", _folder["out"], "--output-name", name,
        ]);
        Assert.True(run.ExitCode == 0, run.Error);
        byte[] file = File.ReadAllBytes(Path.Combine(_folder["out"], name + ".height.npy"));
        int start = file.Length - (48 * 48 * sizeof(double));
        return [.. Enumerable.Range(0, 48 * 48).Select(i => BitConverter.ToDouble(file, start + (sizeof(double) * i)))];
    }
}
