using Msisf.Adapters.Raster.Albedo;
using Msisf.Core.Errors;
using Msisf.Core.Render.Photometry;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Albedo;

/// <summary>Ortho-images of a site: brought to latitude and longitude, and scaled to the map around.</summary>
public sealed class SiteMapTests : IDisposable
{
    /// <summary>
    /// Writes an image of bytes or floats whose value is an expression of latitude and longitude (degrees) at its pixels' middles; PROJ
    /// says where they lie. Arguments: path, projection, geotransform, size, type, expression.
    /// </summary>
    private const string Script = """
        import sys
        import numpy as np
        from osgeo import gdal, osr
        gdal.UseExceptions()
        path, projection, transform, size, kind, expression = sys.argv[1:7]
        left, across, skew, top, skew2, down = map(float, transform.split())
        width, height = map(int, size.split())
        system = osr.SpatialReference()
        system.ImportFromProj4(projection)
        degrees = system.CloneGeogCS()
        for s in (system, degrees):
            s.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
        x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
        xy = np.stack([left + x * across + y * skew, top + x * skew2 + y * down], -1).reshape(-1, 2)
        there = np.array(osr.CoordinateTransformation(system, degrees).TransformPoints(xy.tolist()))
        lon, lat = there[:, 0].reshape(height, width), there[:, 1].reshape(height, width)
        data = gdal.GetDriverByName('GTiff').Create(path, width, height, 1, getattr(gdal, 'GDT_' + kind))
        data.SetGeoTransform([left, across, skew, top, skew2, down])
        data.SetProjection(system.ExportToWkt())
        data.GetRasterBand(1).WriteArray(eval(expression))
        """;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>The map's reflectance at a place is that of the expression, within a pixel's change of it.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("+proj=stere +lat_0=-90 +lon_0=0 +R=1737400", "100000 100 0 -50000 0 -100", "300 200", -85.7, 117.0)] // beside the pole
    [InlineData("+proj=stere +lat_0=-90 +lon_0=0 +R=1737400", "-20000 100 0 18000 0 -100", "400 350", -89.6, 250.0)] // around it
    [InlineData("+proj=stere +lat_0=90 +lon_0=0 +R=1737400", "-9000 100 0 18000 0 -100", "200 350", 89.75, 12.0)]
    [InlineData("+proj=eqc +lat_ts=60 +lat_0=0 +lon_0=180 +R=1737400", "-15000 100 0 1819000 0 -100", "300 200", 59.7, 180.1)] // lon 180
    [InlineData("+proj=ortho +lat_0=20 +lon_0=0 +R=1737400", "-15000 100 0 12000 0 -100", "300 200", 20.1, 359.7)] // lon 0
    [InlineData("+proj=longlat +R=1737400", "30 0.004 0.001 10 0.001 -0.004", "300 200", 9.8, 30.7)] // turned
    public void OpenSeveral_Projections_HasItsValuesWhereTheyLie(
        string proj, string transform, string size, double latitude, double longitude)
    {
        string site = Image("site.tif", proj, transform, size, "Float32", "1000 + 200 * lat + 3 * ((lon - 60) % 360)");
        string moon = Moon(0.1);

        using Opened maps = Open(moon, $"{site},scale=1,offset=20000,incidence=30,emission=0,phase=30");

        double expected = 21_000.0 + (200.0 * latitude) + (3.0 * ((longitude - 60.0 + 360.0) % 360.0));
        double degree = 100.0 / 30_323.0; // of a pixel of 100 m
        double slack = (200.0 * degree) + (3.0 * degree / Math.Cos(double.DegreesToRadians(latitude)));
        Assert.Equal(expected, At(maps.Sites[1].Map, latitude, longitude), slack);
        Assert.Null(maps.Sites[1].Factor);
    }

    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void OpenSeveral_BytesOfUnknownMeaning_AreAsBrightAsTheMapAroundAlongTheBorder()
    {
        // 100 along the border, 200 inside; the map around has I/F 0.12 everywhere. Of two sites the coarser one is scaled first.
        string fine = Image("fine.tif", "+proj=stere +lat_0=-90 +R=1737400", "50000 20 0 50000 0 -20", "200 200", "Byte",
            "np.where((x < 20) | (x > 180) | (y < 20) | (y > 180), 100, 200).astype('u1')");
        string coarse = Image("coarse.tif", "+proj=stere +lat_0=-90 +R=1737400", "40000 100 0 60000 0 -100", "240 240", "Byte",
            "np.where((x < 9) | (x > 231) | (y < 9) | (y > 231), 60, 90).astype('u1')");

        using Opened maps = Open(fine, Moon(0.12), coarse);

        Assert.Equal(["WAC_A.IMG", "coarse.tif", "fine.tif"], maps.Sites.Select(map => map.Name));
        Assert.Equal(0.12 / 60.0, maps.Sites[1].Factor!.Value, 1e-5);
        Assert.Equal(0.18 / 100.0, maps.Sites[2].Factor!.Value, 1e-5);
        (double Latitude, double Longitude) middle = (-87.6664, 47.2906); // x = 52 km, y = 48 km
        Assert.Equal(0.36, At(maps.Sites[2].Map, middle.Latitude, middle.Longitude), 1e-4);
        Assert.Equal(maps.Sites[0].Map.Reference, maps.Sites[2].Map.Reference);
    }

    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void OpenSeveral_FactorsAndWrongMaps_AreTakenOrNamed()
    {
        string Even(string name, string radius, string value) => Image(
            name, $"+proj=stere +lat_0=-90 +R={radius}", "50000 20 0 50000 0 -20", "100 100", "Float32", $"0 * lat + {value}");
        string site = Even("site.tif", "1737400", "50");
        string dark = Even("dark.tif", "1737400", "0");
        string mars = Even("mars.tif", "3396190", "50");
        using (Opened maps = Open(Moon(0.1), $"{site},factor=0.004"))
        {
            Assert.Equal(0.2, At(maps.Sites[1].Map, -87.6677, 46.145), 1e-6); // floats of 50 times a factor
        }

        Assert.Contains("its values along the border are 0 or below", Refused(Moon(0.1), dark));
        Assert.Contains("is not one on a sphere of the Moon", Refused(Moon(0.1), mars));
        string nowhere = Image(
            "nowhere.tif", "+proj=ortho +lat_0=-90 +R=1737400", "5000000 20 0 50000 0 -20", "100 100", "Float32", "50 + 0 * x");
        Assert.Contains("lie nowhere on the Moon. Say where they lie: gdal_translate -a_srs PROJECTION", Refused(Moon(0.1), nowhere));
        ChildRun.Of(
            "gdal_translate", ["-q", "-a_srs", "+proj=ortho +lat_0=-90 +R=1737400", "-a_ullr", "50000", "50000", "52000", "48000", nowhere,
                _folder["placed.tif"]], _folder.Path).Succeeded();
        Open(Moon(0.1), _folder["placed.tif"]).Dispose();
        Assert.Contains("no coarser map shows the half of its border", Refused(Band(0.1), $"{site},factor=auto"));
        Open(Band(0.1), $"{site},scale=0.002,incidence=30,emission=0,phase=30").Dispose(); // as advised

        // A border of zeros: raised by an offset, or declared as no data.
        string framed = Image(
            "framed.tif", "+proj=stere +lat_0=-90 +R=1737400", "50000 20 0 50000 0 -20", "100 100", "Float32",
            "np.where((x < 5) | (x > 94) | (y < 5) | (y > 94), 0.0, 50.0)");
        Assert.Contains("Give offset=, or declare what is no data, e.g. with gdal_edit.py -a_nodata 0.", Refused(Moon(0.1), framed));
        Open(Moon(0.1), $"{framed},offset=5").Dispose();
        ChildRun.Of("gdal_edit.py", ["-a_nodata", "0", framed], _folder.Path).Succeeded();
        using (Opened maps = Open(Moon(0.1), framed))
        {
            Assert.Equal(0.1 / 50.0, maps.Sites[1].Factor!.Value, 1e-5);
        }

        Assert.Contains("factor is a number from", Refused(Moon(0.1), $"{site},factor=bright"));
        Assert.Contains("'scal=2' is not a property of a map", Refused(Moon(0.1), $"{site},scal=2"));
    }

    private static double At(AlbedoMap map, double latitude, double longitude)
    {
        double right = double.DegreesToRadians(longitude) - map.Extent.West;
        right -= 2.0 * Math.PI * Math.Floor(right / (2.0 * Math.PI));
        AlbedoMapLevel finest = map.Levels[0];
        int column = (int)(right / map.Extent.Width * finest.Width);
        int row = (int)((map.Extent.North - double.DegreesToRadians(latitude)) / map.Extent.Height * finest.Height);
        int code = finest.Codes.Span[(row * finest.Width) + column];
        Assert.NotEqual(0, code);
        return map.Offset + (map.Step * code);
    }

    private string Moon(double reflectance) => PdsMap.Write(_folder, "WAC_A", "PC_REAL", 32, 1, (_, _) => reflectance)
        + ",incidence=60,emission=0,phase=60";

    /// <summary>A map from 60 N down to the equator.</summary>
    private string Band(double reflectance) => PdsMap.Write(
        _folder, "WAC_EMP_643NM_BAND", "PC_REAL", 32, 2, (_, _) => reflectance, west: 0.0, north: 60.0, degrees: (90, 60));

    private string Image(string name, string projection, string transform, string size, string kind, string expression)
    {
        string path = _folder[name];
        ChildRun.Of(TestParts.Python!, ["-c", Script, path, projection, transform, size, kind, expression], _folder.Path).Succeeded();
        return path;
    }

    private Opened Open(params string[] texts) => new(OpenedAlbedoMap.OpenSeveral(
        texts.Select(AlbedoMapPath.Parse), 643, _folder["cache"], gdalPath: null));

    private string Refused(params string[] texts) => Assert.Throws<BadInputException>(() => Open(texts)).Message;

    private sealed record Opened(IReadOnlyList<OpenedAlbedoMap> Sites) : IDisposable
    {
        public void Dispose()
        {
            foreach (OpenedAlbedoMap map in Sites)
            {
                map.Dispose();
            }
        }
    }
}
