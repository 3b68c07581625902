using System.Globalization;
using Msisf.TestSupport;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>Writes rasters of 300 x 280 pixels with slopes of some degrees in any format, by GDAL in Python.</summary>
internal static class TestRaster
{
    public const int Lines = 280;
    public const int Samples = 300;

    /// <summary>Arguments: path, driver, code that may change the array a, transform t, system s, type kind, and options.</summary>
    private const string Script = """
        import sys
        import numpy as np
        from osgeo import gdal, osr
        gdal.UseExceptions()
        path, driver, then = sys.argv[1:]
        line, sample = np.mgrid[0:280, 0:300].astype(float)
        a = 500 + 0.25 * line + 0.5 * sample + np.round(20 * np.sin(line / 9) * np.cos(sample / 7))
        t, s, kind, options = [177000.0, 5.0, 0.0, -500.0, 0.0, -5.0], '+proj=stere +lat_0=-90 +R=1737400 +units=m', gdal.GDT_Float32, []
        nodata = unit = scale = offset = None
        exec(then)
        data = gdal.GetDriverByName('MEM').Create('', a.shape[1], a.shape[0], 1, kind)
        data.GetRasterBand(1).WriteArray(a)
        data.SetGeoTransform(t)
        system = osr.SpatialReference()
        system.ImportFromProj4(s)
        data.SetProjection(system.ExportToWkt())
        band = data.GetRasterBand(1)
        for value, put in ((nodata, band.SetNoDataValue), (unit, band.SetUnitType), (scale, band.SetScale), (offset, band.SetOffset)):
            if value is not None:
                put(value)
        gdal.GetDriverByName(driver).CreateCopy(path, data, options=options)
        """;

    /// <summary>The height of a pixel.</summary>
    public static double HeightAt(int line, int sample) =>
        500.0 + (0.25 * line) + (0.5 * sample) + Math.Round(20.0 * Math.Sin(line / 9.0) * Math.Cos(sample / 7.0));

    public static string Write(TemporaryFolder folder, string name, string then = "pass", string driver = "GTiff")
    {
        string path = folder[name];
        ChildRun.Of(TestParts.Python!, ["-c", Script, path, driver, then], folder.Path).Succeeded();
        return path;
    }
}

/// <summary>A raster so large that what is found of it is kept; made once for several tests.</summary>
public sealed class LargeRaster : IDisposable
{
    /// <summary>4,600 x 3,700 pixels: more than 2^24, in tiles; a strip of 4,096 columns and one of 504.</summary>
    internal const string Script = "line, sample = np.mgrid[0:3700, 0:4600].astype(np.float32); "
        + "a = 500 + 0.05 * line - 0.01 * sample + np.round(20 * np.sin(line / 90) * np.cos(sample / 70)); "
        + "a[1000:1030, 2000:2050] = -9999; a[3699, 4599] = -9999; a[5, 4096] = 900; nodata = -9999; t[0] = 150000.0; "
        + "options = ['TILED=YES', 'COMPRESS=DEFLATE', 'ZLEVEL=1']";

    private readonly TemporaryFolder _made = new();

    /// <summary>A copy for one test.</summary>
    internal string CopyTo(TemporaryFolder folder)
    {
        string path = _made["site.tif"];
        File.Copy(File.Exists(path) ? path : TestRaster.Write(_made, "site.tif", Script), folder["site.tif"]);
        return folder["site.tif"];
    }

    public void Dispose() => _made.Dispose();
}
