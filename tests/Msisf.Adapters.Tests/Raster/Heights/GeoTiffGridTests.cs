using System.Globalization;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

public sealed class GeoTiffGridTests : IDisposable
{
    /// <summary>Writes a map with the value line + sample / 1024; arguments: path, GDAL options, code on the data set.</summary>
    private const string Script = """
        import struct, sys
        from osgeo import gdal, osr
        gdal.UseExceptions()
        path, options, then = sys.argv[1], sys.argv[2].split(), sys.argv[3]
        driver = gdal.GetDriverByName('MEM')
        data = driver.Create('', 300, 280, 1, gdal.GDT_Float32)
        for line in range(280):
            row = [line + sample / 1024 for sample in range(300)]
            data.GetRasterBand(1).WriteRaster(0, line, 300, 1, struct.pack('<300f', *row))
        data.SetGeoTransform([177000.0, 5.0, 0.0, -500.0, 0.0, -5.0])
        system = osr.SpatialReference()
        system.ImportFromProj4('+proj=stere +lat_0=-90 +lon_0=0 +R=1737400 +units=m')
        data.SetProjection(system.ExportToWkt())
        band = data.GetRasterBand(1)
        exec(then)
        gdal.GetDriverByName('COG' if 'COG' in options else 'GTiff').CreateCopy(path, data, options=[o for o in options if '=' in o])
        """;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("", "pass", 1_737_400.0, 1.0)]
    [InlineData("TILED=YES BLOCKXSIZE=64 BLOCKYSIZE=64 COMPRESS=DEFLATE", "pass", 1_737_400.0, 1.0)]
    [InlineData("COG BLOCKSIZE=128", "pass", 1_737_400.0, 1.0)]
    [InlineData("", "band.SetUnitType('km'); band.SetScale(0.03)", 1_737_400.0, 30.0)]
    [InlineData("", "band.SetScale(0.5); band.SetOffset(100)", 1_737_500.0, 0.5)]
    [InlineData("", "band.SetNoDataValue(-9999)", 1_737_400.0, 1.0)]
    [InlineData(
        "", "system.ImportFromProj4('+proj=stere +lat_0=-90 +R=1738000'); data.SetProjection(system.ExportToWkt())", 1_738_000.0, 1.0)]
    public void ReadRadii_AnyLayout_HasTheSamples(string options, string then, double offset, double factor)
    {
        using GeoTiffGrid grid = GeoTiffGrid.Open(Write(options, then), libraryPath: null);
        Assert.Equal((280, 300, "map"), (grid.Lines, grid.Samples, grid.ProductId));
        double[] radii = new double[90];
        foreach ((int line, int sample) in new[] { (0, 0), (255, 200), (256, 210), (279, 210) })
        {
            grid.ReadRadii(line, sample, radii);
            for (int i = 0; i < radii.Length; i++)
            {
                Assert.Equal(offset + (factor * (line + ((sample + i) / 1024.0))), radii[i], Rounding.OfPlaces * factor);
            }
        }

        Assert.Equal(
            (offset + (factor * 250.0), offset + (factor * (259.0 + (299.0 / 1024.0)))),
            ((ITerrainGrid)grid).RadiusBounds(250, 10, 0, 300));
        Assert.Throws<ArgumentOutOfRangeException>(() => grid.ReadRadii(280, 0, radii));
        Assert.Throws<ArgumentOutOfRangeException>(() => grid.ReadRadii(0, 211, radii));
    }

    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("band.SetNoDataValue(123)", "no data there. Fill the hole")]
    [InlineData("band.WriteRaster(0, 123, 1, 1, struct.pack('<f', float('nan')))", "no data there. Fill the hole")]
    public void ReadRadii_Hole_IsNamed(string then, string what)
    {
        string path = Write(string.Empty, then);
        using GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null);
        grid.ReadRadii(122, 0, new double[300]);
        BadInputException exception = Assert.Throws<BadInputException>(() => grid.ReadRadii(123, 0, new double[300]));
        Assert.StartsWith($"{path}, line 124, sample 1: {what}", exception.Message, StringComparison.Ordinal);
    }

    /// <summary>The map's values are linear in its coordinates, and so is what is bilinear between them; places come from PROJ.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("+proj=ortho +lat_0=-80 +lon_0=20", true)]
    [InlineData("+proj=stere +lat_0=90 +lon_0=30", true)]
    [InlineData("+proj=eqc +lat_ts=20 +lat_0=20 +lon_0=30", false)]
    [InlineData("+proj=lcc +lat_1=35 +lat_2=45 +lat_0=40 +lon_0=200", false)]
    [InlineData("+proj=ortho +lat_0=10 +lon_0=0", false)] // across the prime meridian
    [InlineData("+proj=ortho +lat_0=10 +lon_0=180", false)] // and that on the other side
    [InlineData("+proj=eqc +lat_ts=20 +lat_0=0 +lon_0=0", false, 30_000.0)] // over 316 degrees of longitude
    public void Open_OtherProjection_IsBilinearBetweenThePixels(string projection, bool isPolar, double pixel = 5.0)
    {
        (double left, double top) = (-100.0 * pixel, 140.0 * pixel);
        double scale = pixel == 5.0 ? 1.0 : 0.3; // or the map would be higher than the Moon
        (left, top) = pixel == 5.0 ? (left, top) : (-150.0 * pixel, 140.0 * pixel * scale);
        string path = Write(
            string.Empty,
            string.Create(
                CultureInfo.InvariantCulture,
                $"system.ImportFromProj4('{projection} +R=1737400'); data.SetProjection(system.ExportToWkt()); "
                    + $"data.SetGeoTransform([{left:R}, {pixel:R}, 0.0, {top:R}, 0.0, {-scale * pixel:R}])"));
        using GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null);
        Assert.Contains(projection.Split(' ')[0], grid.WarpedFrom, StringComparison.Ordinal);
        Assert.Equal(isPolar, grid.Projection is PolarStereographic);
        Assert.True(grid.MayHaveGaps);

        GridWindow window = grid.Window;
        (int Line, int Sample)[] places =
        [
            .. Enumerable.Range(3, 5).Select(
                i => (window.FirstLine + (window.Lines * i / 10), window.FirstSample + (window.Samples * i / 10))),
        ];
        const string Script = """
            import sys
            from osgeo import osr
            system, degrees = osr.SpatialReference(), osr.SpatialReference()
            system.ImportFromProj4(sys.argv[1] + ' +R=1737400')
            degrees.ImportFromProj4('+proj=longlat +R=1737400')
            for one in (system, degrees):
                one.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
            transform = osr.CoordinateTransformation(degrees, system)
            for place in sys.argv[2].split(';'):
                longitude, latitude = (float(word) for word in place.split(','))
                x, y, _ = transform.TransformPoint(longitude, latitude)
                left, across, top, down = (float(word) for word in sys.argv[3].split(','))
                print(repr((top - y) / down - 0.5 + ((x - left) / across - 0.5) / 1024))
            """;
        string extent = string.Create(CultureInfo.InvariantCulture, $"{left:R},{pixel:R},{top:R},{scale * pixel:R}");
        string given = string.Join(';', places.Select(place =>
        {
            SelenographicPoint point = SelenographicPoint.Below(grid.Projection.DirectionOf(place.Line, place.Sample));
            return string.Create(
                CultureInfo.InvariantCulture,
                $"{double.RadiansToDegrees(point.Longitude):R},{double.RadiansToDegrees(point.Latitude):R}");
        }));
        string[] values = ChildRun.Of(TestParts.Python!, ["-c", Script, projection, given, extent], _folder.Path).Succeeded().Output
            .Split('\n', StringSplitOptions.RemoveEmptyEntries);
        double[] radius = new double[1];
        for (int i = 0; i < places.Length; i++)
        {
            grid.ReadRadii(places[i].Line, places[i].Sample, radius);
            Assert.Equal(
                1_737_400.0 + double.Parse(values[i], CultureInfo.InvariantCulture), radius[0], 1e-3); // GDAL interpolates floats
        }
    }

    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("data.SetProjection('')", "has no coordinate system")]
    [InlineData("system.ImportFromEPSG(3031); data.SetProjection(system.ExportToWkt())", "is not one on a sphere of the Moon")]
    [InlineData("band.SetUnitType('ft')", "its heights are in 'ft'; m or km are needed")]
    public void Open_WrongFile_IsRefused(string then, string message)
    {
        string path = Write(string.Empty, then);
        BadInputException exception = Assert.Throws<BadInputException>(() => GeoTiffGrid.Open(path, libraryPath: null));
        Assert.Contains(message, exception.Message, StringComparison.Ordinal);
    }

    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Open_CutOffFile_IsRefusedWhenItIsRead()
    {
        string path = Write(string.Empty, "pass");
        byte[] bytes = File.ReadAllBytes(path);
        File.WriteAllBytes(path, bytes[..(bytes.Length / 2)]);
        Assert.Throws<BadInputException>(() =>
        {
            using GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null);
            grid.ReadRadii(279, 0, new double[300]);
        });
    }

    /// <summary>What was opened to learn its resolution is the model; another model of the same file is another one.</summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Files_ResolutionThenModel_IsOpenedOnce()
    {
        string path = Write(string.Empty, "pass");
        using GeoTiffFiles files = new(libraryPath: null);
        Assert.Equal(5.0, files.ResolutionOf(path).MetresPerPixel, Rounding.OfPlaces);
        File.Delete(path);
        Assert.Equal(5.0, files.ResolutionOf(path).MetresPerPixel, Rounding.OfPlaces);
        using (GeoTiffGrid grid = files.Open(path))
        {
            Assert.Equal(280, grid.Lines);
        }

        Assert.Contains(
            "there is no such file", Assert.Throws<BadInputException>(() => files.Open(path)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Open_MissingFile_IsRefused() =>
        Assert.Contains(
            "there is no such file",
            Assert.Throws<BadInputException>(() => GeoTiffGrid.Open(_folder["none.tif"], null)).Message,
            StringComparison.Ordinal);

    [RequiresFact(Part.GdalLibrary)]
    public void Open_NoImage_IsRefused()
    {
        File.WriteAllText(_folder["text.tif"], "no image");
        Assert.Throws<BadInputException>(() => GeoTiffGrid.Open(_folder["text.tif"], null));
    }

    /// <summary>LOLA's own 5 m maps: places of pixels as PROJ computes them (gdaltransform), heights as they are stored.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary, Part.PolarPieces)]
    [InlineData("NPB", 200)]
    [InlineData("NPC", 400)]
    public void Open_RealPiece_HasPlacesAndHeightsOfGdal(string name, int side)
    {
        string path = TestParts.PolarPiece(name)!;
        using GeoTiffGrid grid = GeoTiffGrid.Open(path, libraryPath: null);
        Assert.Equal((side, side), (grid.Lines, grid.Samples));
        const string Places = """
            import struct, sys
            from osgeo import gdal, osr
            data = gdal.Open(sys.argv[1])
            system = data.GetSpatialRef()
            to = system.CloneGeogCS()
            for one in (system, to):
                one.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
            transform = osr.CoordinateTransformation(system, to)
            left, across, _, top, _, down = data.GetGeoTransform()
            for line, sample in ((0, 0), (0, 199), (77, 131), (199, 3), (199, 199)):
                longitude, latitude, _ = transform.TransformPoint(left + (sample + 0.5) * across, top + (line + 0.5) * down)
                height = struct.unpack('<f', data.GetRasterBand(1).ReadRaster(sample, line, 1, 1))[0]
                print(line, sample, repr(latitude), repr(longitude), repr(height))
            """;
        string output = ChildRun.Of(TestParts.Python!, ["-c", Places, path], _folder.Path).Succeeded().Output;
        double[] radius = new double[1];
        foreach (string[] words in output.Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(line => line.Split(' ')))
        {
            double[] numbers = [.. words.Select(word => double.Parse(word, CultureInfo.InvariantCulture))];
            SelenographicPoint point = SelenographicPoint.Below(grid.Projection.DirectionOf(numbers[0], numbers[1]));
            Assert.Equal(numbers[2], double.RadiansToDegrees(point.Latitude), 1e-11); // degrees: PROJ's series and ours round apart
            Assert.Equal(numbers[3], double.RadiansToDegrees(point.Longitude), Rounding.OfPlaces);
            grid.ReadRadii((int)numbers[0], (int)numbers[1], radius);
            Assert.Equal(1_737_400.0 + numbers[4], radius[0]);
        }
    }

    private string Write(string options, string then)
    {
        string path = _folder["map.tif"];
        ChildRun.Of(TestParts.Python!, ["-c", Script, path, options, then], _folder.Path).Succeeded();
        return path;
    }
}
