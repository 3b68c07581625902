using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

/// <summary>Rasters are read by their content, whatever their names are.</summary>
public sealed class RasterFormatTests : IDisposable
{
    internal const string Pds4 = "options = ['VAR_TARGET=Moon', 'VAR_TARGET_TYPE=Satellite', 'VAR_LOGICAL_IDENTIFIER=urn:a:b:c', "
        + "'VAR_TITLE=t', "
        + "'VAR_INVESTIGATION_AREA_NAME=i', 'VAR_INVESTIGATION_AREA_LID_REFERENCE=urn:a:b', 'VAR_OBSERVING_SYSTEM_NAME=o']";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("site.cub", "ISIS3", "options = ['TARGET_NAME=Moon']")]
    [InlineData("site.lbl", "ISIS3", "options = ['TARGET_NAME=Moon', 'DATA_LOCATION=EXTERNAL']")]
    [InlineData("site.xml", "PDS4", Pds4)]
    [InlineData("site", "COG", "pass")]
    [InlineData("site.img", "HFA", "pass")]
    [InlineData("site.dat", "JP2OpenJPEG", "kind = gdal.GDT_Int16; a = np.round(a); options = ['REVERSIBLE=YES', 'QUALITY=100']")]
    public void Open_AnyFormat_HasPlacesAndHeights(string name, string driver, string then)
    {
        string path = TestRaster.Write(_folder, name, then, driver);
        Assert.True(RasterFiles.IsForGdal(path));
        using GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null);
        PolarStereographic map = Assert.IsType<PolarStereographic>(grid.Projection);
        Assert.Equal((5.0, -100.5, -35400.5), (map.MetresPerPixel, map.LineOffset, map.SampleOffset));
        double[] radii = new double[TestRaster.Samples];
        for (int line = 0; line < TestRaster.Lines; line += 31)
        {
            grid.ReadRadii(line, 0, radii);
            for (int sample = 0; sample < radii.Length; sample++)
            {
                Assert.Equal(1_737_400.0 + TestRaster.HeightAt(line, sample), radii[sample], name == "site.dat" ? 0.51 : 1e-4);
            }
        }
    }

    /// <summary>A file that names others is as new as they are, and the meta file has them all.</summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Checksums_Vrt_HaveTheFilesThatItNames()
    {
        string tiff = TestRaster.Write(_folder, "part.tif");
        string vrt = _folder["whole.vrt"];
        ChildRun.Of("gdal_translate", ["-q", "-of", "VRT", tiff, vrt], _folder.Path).Succeeded();
        using GeoTiffGrid grid = GeoTiffGrid.Open(vrt, libraryPath: null);
        LdemSet set = LdemSet.OfMap(grid.ToLabel());
        Assert.Equal(["whole.vrt", "part.tif"], LdemChecksums.Open(set, cacheFolder: null).Read(default).Files.Select(file => file.Name));
        LdemFingerprint before = LdemFingerprint.Of([set]);
        File.AppendAllText(tiff, "more");
        Assert.NotEqual(before, LdemFingerprint.Of([set]));
    }

    [Fact]
    public void IsForGdal_ProductOfLola_IsReadAsBefore()
    {
        string label = PolarTestModel.Write(_folder.Path);
        Assert.False(RasterFiles.IsForGdal(label));
        Assert.False(RasterFiles.IsForGdal(Path.ChangeExtension(label, ".IMG")));
        Assert.False(RasterFiles.IsForGdal(_folder.Path));
        Assert.True(RasterFiles.IsForGdal("/vsicurl/https://host/LDEM_4.LBL"));
    }

    /// <summary>JPEG 2000 has no place for the factor of 0.5 m; the product's name says it.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("SLDEM2015_512_00N_30N_000_045.JP2", 0.5)]
    [InlineData("sldem2015_site.jp2", 0.5)]
    [InlineData("site.jp2", 1.0)]
    public void Open_KnownProduct_HasItsFactor(string name, double factor)
    {
        string path = TestRaster.Write(
            _folder, name, "kind = gdal.GDT_Int16; a = np.round(a); options = ['REVERSIBLE=YES', 'QUALITY=100']", "JP2OpenJPEG");
        using GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null);
        double[] radius = new double[1];
        grid.ReadRadii(100, 200, radius);
        Assert.Equal(1_737_400.0 + (factor * TestRaster.HeightAt(100, 200)), radius[0], 0.51);
    }

    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("a *= 0.001", "look like kilometres", "scale=1000")]
    [InlineData("a = (a + 7000) / 0.3048", "look like feet", "scale=0.3048")]
    [InlineData("a += 1737400", "look like radii from the Moon's centre in m", "offset=-1737400")]
    [InlineData(
        "kind = gdal.GDT_Int16; a = np.round(a / 0.5); scale = 0.5; offset = 1737400", "look like radii from the Moon's centre in m",
        "offset=-1737400")]
    [InlineData("a /= 1000; offset = 1737.4", "look like radii from the Moon's centre in km", "scale=1000,offset=-1737400")]
    [InlineData("a = np.where(line % 2 > 0, a, a + 60)", "half of their slopes are steeper than", "scale=0.5")]
    [InlineData("a = a * 2 + 11000", "look like feet, or like steps of half a metre (they are from", "scale=0.5")]
    [InlineData(
        "kind = gdal.GDT_Float64; a = (a + 1737400) / 1000", "look like radii from the Moon's centre in km", "scale=1000,offset=-1737400")]
    [InlineData("a = np.clip(a / 4, 0, 255); kind = gdal.GDT_Byte", "look like a picture or a hillshade", "scale=1")]
    [InlineData("unit = 'ft'", "are in 'ft'; m or km are needed", "scale=0.3048")]
    public void Open_OtherValues_AreGuessedAndRefused(string then, string guess, string option)
    {
        string path = TestRaster.Write(_folder, "site.tif", then);
        BadInputException exception = Assert.Throws<BadInputException>(() => GeoTiffGrid.Open(path, libraryPath: null));
        Assert.Contains(guess, exception.Message, StringComparison.Ordinal);
        Assert.Contains($",{option}", exception.Message, StringComparison.Ordinal);
        Assert.DoesNotContain('\n', exception.Message);

        // What is advised is done, on the same file.
        using GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null, new HeightOptions(Option("scale"), Option("offset")));
        Assert.False(grid.MayHaveGaps);

        double? Option(string name) => option.Split(',').Select(part => part.Split('=')).Where(part => part[0] == name)
            .Select(part => (double?)double.Parse(part[1], System.Globalization.CultureInfo.InvariantCulture)).FirstOrDefault();
    }

    /// <summary>The file's own factor and offset are a part of the value; options are applied to that, and wrong ones are told.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData(0.5, -1_737_400.0, ",offset=-1737400 instead")]
    [InlineData(1000.0, null, ",offset=-1737400 instead")]
    [InlineData(null, 5.0, ",offset=-1737400 instead")]
    public void Open_OptionsThatMakeNoHeights_AreNamedWithBetterOnes(double? scale, double? offset, string advice)
    {
        string path = TestRaster.Write(
            _folder, "site.tif", "kind = gdal.GDT_Int16; a = np.round(a / 0.5); scale = 0.5; offset = 1737400");
        Assert.Contains(
            advice,
            Assert.Throws<BadInputException>(() => GeoTiffGrid.Open(path, libraryPath: null, new HeightOptions(scale, offset))).Message,
            StringComparison.Ordinal);
        using GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null, new HeightOptions(Scale: null, Offset: -1_737_400.0));
        double[] radius = new double[1];
        grid.ReadRadii(77, 131, radius);
        Assert.Equal(1_737_400.0 + TestRaster.HeightAt(77, 131), radius[0], 0.25); // half a step
    }

    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("scale = 0.0")]
    [InlineData("scale = float('nan')")]
    public void Open_ScaleThatMakesNoHeights_IsRefusedWithACommandThatHelps(string then)
    {
        string path = TestRaster.Write(_folder, "site.tif", then);
        string message = Assert.Throws<BadInputException>(() => GeoTiffGrid.Open(path, libraryPath: null)).Message;
        Assert.Contains("gdal_translate -a_scale 1 -a_offset 0.", message, StringComparison.Ordinal);
        ChildRun.Of("gdal_translate", ["-q", "-a_scale", "1", "-a_offset", "0", path, _folder["new.tif"]], _folder.Path).Succeeded();
        using GeoTiffGrid grid = GeoTiffGrid.Open(_folder["new.tif"], libraryPath: null);
        Assert.Null(grid.NoteOfGaps());
    }

    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Open_OffsetThatMovesHeightsOffTheMoon_IsNamed() => Assert.Contains(
        "site.tif: offset=30000 makes heights of it such as ",
        Assert.Throws<BadInputException>(() => GeoTiffGrid.Open(
            TestRaster.Write(_folder, "site.tif", "pass"), libraryPath: null, new HeightOptions { Offset = 30_000.0 })).Message,
        StringComparison.Ordinal);

    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Open_ComplexNumbers_AreRefused() => Assert.Contains(
        "complex numbers",
        Assert.Throws<BadInputException>(() => GeoTiffGrid.Open(
            TestRaster.Write(_folder, "site.tif", "kind = gdal.GDT_CFloat32"), libraryPath: null)).Message,
        StringComparison.Ordinal);

    /// <summary>What is said goes before what is guessed, and before the file's own unit.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("a = a / 0.3048; unit = 'ft'", 0.3048, null, 0.0)]
    [InlineData("a *= 0.001", 1000.0, null, 0.0)]
    [InlineData("a += 1737400", 1.0, -1_737_400.0, 0.0)]
    [InlineData("pass", null, -37.5, -37.5)]
    [InlineData("unit = 'km'; a *= 0.001", null, 12.5, 12.5)]
    public void Open_WithOptions_HasTheirHeights(string then, double? scale, double? offset, double expected)
    {
        string path = TestRaster.Write(_folder, "site.tif", then);
        using GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null, new HeightOptions(scale, offset));
        double[] radius = new double[1];
        grid.ReadRadii(77, 131, radius);
        Assert.Equal(1_737_400.0 + TestRaster.HeightAt(77, 131) + expected, radius[0], 0.1); // floats of radii have steps of 0.125 m
    }
}
