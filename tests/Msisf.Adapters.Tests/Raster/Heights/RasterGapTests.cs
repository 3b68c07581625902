using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>Values that can't be heights are without data, whether the file says so or not.</summary>
public sealed class RasterGapTests : IDisposable
{
    private const string Orthographic = "s = '+proj=ortho +lat_0=20 +lon_0=30 +R=1737400'; t = [-700, 5, 0, 700, 0, -5]";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("-32768", "(-32768)")]
    [InlineData("np.nan", "(NaN)")]
    [InlineData("np.inf", "(Infinity)")]
    [InlineData("-np.inf", "(-Infinity)")]
    [InlineData("-9999", "(-9999)")]
    [InlineData("-9501", "(-9501)")]
    [InlineData("11501", "(11501)")]
    [InlineData("-3.4e38", "(-3.4E+38)")]
    public void Open_UndeclaredValue_IsNoDataWithANote(string value, string text)
    {
        using GeoTiffGrid grid = Open($"a[100:103, 200:260] = {value}; a[270, 5] = {value}");
        Assert.Contains($"181 pixels cannot be heights", grid.NoteOfGaps(), StringComparison.Ordinal);
        Assert.Contains($"the first is line 101, sample 201 {text}", grid.NoteOfGaps(), StringComparison.Ordinal);
        Assert.True(grid.MayHaveGaps);
        bool[] gaps = new bool[TestRaster.Samples];
        int count = 0;
        for (int line = 0; line < TestRaster.Lines; line++)
        {
            grid.ReadGaps(line, 0, gaps);
            count += gaps.Count(gap => gap);
            Assert.Equal(line is >= 100 and < 103, gaps[255]);
        }

        Assert.Equal(181, count);
        Assert.Contains(
            "line 101, sample 201: no data there",
            Assert.Throws<BadInputException>(() => grid.ReadRadii(100, 0, new double[300])).Message, StringComparison.Ordinal);
    }

    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("a[100:103, 200:260] = -9999; nodata = -9999", true)]
    [InlineData("a[0, 0] = 11499; a[0, 1] = -9499", false)]
    [InlineData("pass", false)]
    public void Open_DeclaredOrPossibleValue_HasNoNote(string then, bool hasGaps)
    {
        using GeoTiffGrid grid = Open(then);
        Assert.Null(grid.NoteOfGaps());
        Assert.Equal(hasGaps, grid.MayHaveGaps);
    }

    /// <summary>A coarse sample is the mean of the pixels that have data; one that has none is without data as well.</summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Levels_UndeclaredValue_AreTheMeansOfTheRest()
    {
        using GeoTiffGrid grid = Open("a[100:102, 200:204] = -32768; a[50, 60] = -32768");
        ITerrainGrid level = MapLevels.Open(grid, keepsGaps: true).Grid(1);
        double[] radius = new double[1];
        level.ReadRadii(25, 30, radius);
        double mean = (TestRaster.HeightAt(50, 61) + TestRaster.HeightAt(51, 60) + TestRaster.HeightAt(51, 61)) / 3.0;
        Assert.Equal(1_737_400.0 + mean, radius[0], 1e-3);
        bool[] gaps = new bool[4];
        level.ReadGaps(50, 99, gaps);
        Assert.Equal([false, true, true, false], gaps);
    }

    /// <summary>Interpolated with its neighbours an undeclared value would look like a height.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("np.nan")]
    [InlineData("-32768")]
    [InlineData("-3.4028234663852886e38")]
    public void Open_WarpedMapWithUndeclaredValue_HasOnlyHeights(string value)
    {
        using GeoTiffGrid grid = Open($"{Orthographic}; a[100:110, 90:99] = {value}");
        Assert.Contains("90 pixels cannot be heights", grid.NoteOfGaps(), StringComparison.Ordinal);
        GridWindow window = grid.Window;
        bool[] gaps = new bool[window.Samples];
        double[] radius = new double[1];
        for (int line = window.FirstLine; line < window.EndLine; line += 3)
        {
            grid.ReadGaps(line, window.FirstSample, gaps);
            for (int i = 0; i < gaps.Length; i += 3)
            {
                if (!gaps[i])
                {
                    grid.ReadRadii(line, window.FirstSample + i, radius);
                    Assert.InRange(radius[0], 1_737_400.0 + 450.0, 1_737_400.0 + 800.0);
                }
            }
        }
    }

    /// <summary>Each pixel counts once, though several samples lie beside it.</summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Open_WarpedMapWithSeveralUndeclaredValues_LeavesThemAllOut()
    {
        using GeoTiffGrid grid = Open(Orthographic + "; a[3, 4] = np.nan; a[11, 12] = -32768; a[100:110, 90:99] = -9999");
        Assert.Contains("92 pixels cannot be heights", grid.NoteOfGaps(), StringComparison.Ordinal);
        Assert.Contains("the first is line 4, sample 5 (NaN)", grid.NoteOfGaps(), StringComparison.Ordinal);
    }

    /// <summary>Special pixels of a cube are none that somebody forgot to declare; with a factor of 0.25 m they would be ground.</summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Open_SpecialPixelsOfACube_AreDeclared()
    {
        string path = TestRaster.Write(
            _folder, "site.cub",
            "kind = gdal.GDT_Int16; a = np.round(a / 0.25); a[5, 6:11] = [-32768, -32767, -32766, -32765, -32764]; scale = 0.25; "
                + "options = ['TARGET_NAME=Moon']",
            "ISIS3");
        using GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null);
        Assert.Null(grid.NoteOfGaps());
        bool[] gaps = new bool[TestRaster.Samples];
        grid.ReadGaps(5, 0, gaps);
        Assert.Equal([6, 7, 8, 9, 10], Enumerable.Range(0, gaps.Length).Where(sample => gaps[sample]));
    }

    /// <summary>Each constant that a label of PDS4 names is without data, not only the one that GDAL tells.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("invalid_constant")]
    [InlineData("saturated_constant")]
    [InlineData("unknown_constant")]
    [InlineData("low_instrument_saturation")]
    public void Open_ConstantOfPds4_IsDeclared(string name)
    {
        string path = TestRaster.Write(_folder, "site.xml", RasterFormatTests.Pds4 + "; a[7, 8] = -77", "PDS4");
        string label = File.ReadAllText(path);
        int end = label.IndexOf("</Array_2D_Image>", StringComparison.Ordinal);
        end = end < 0 ? label.IndexOf("</Array_3D_Image>", StringComparison.Ordinal) : end;
        File.WriteAllText(path, label.Insert(end, $"<Special_Constants><{name}>-77.0</{name}></Special_Constants>"));
        using GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null);
        Assert.Null(grid.NoteOfGaps());
        bool[] gap = new bool[2];
        grid.ReadGaps(7, 8, gap);
        Assert.Equal([true, false], gap);
    }

    /// <summary>A sparse file of 40 thousand million pixels is not looked at pixel by pixel.</summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Open_SparseFileWithoutPixels_IsNamedAtOnce()
    {
        const string Script = """
            import sys
            from osgeo import gdal, osr
            data = gdal.GetDriverByName('GTiff').Create(
                sys.argv[1], 200000, 200000, 1, gdal.GDT_Float32,
                ['SPARSE_OK=TRUE', 'TILED=YES', 'BLOCKXSIZE=512', 'BLOCKYSIZE=512', 'BIGTIFF=YES'])
            system = osr.SpatialReference()
            system.ImportFromProj4('+proj=stere +lat_0=-90 +R=1737400')
            data.SetProjection(system.ExportToWkt())
            data.SetGeoTransform([-100000, 1, 0, 100000, 0, -1])
            """;
        string path = _folder["sparse.tif"];
        ChildRun.Of(TestParts.Python!, ["-c", Script, path], _folder.Path).Succeeded();
        Assert.Contains(
            "a sparse file of 200000 x 200000 pixels that stores none of them",
            Assert.Throws<BadInputException>(() => GeoTiffGrid.Open(path, libraryPath: null)).Message, StringComparison.Ordinal);
    }

    private GeoTiffGrid Open(string then) => GeoTiffGrid.Open(TestRaster.Write(_folder, "site.tif", then), libraryPath: null);
}
