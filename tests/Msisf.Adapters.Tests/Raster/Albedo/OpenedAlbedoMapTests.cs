using System.Security.Cryptography;
using Msisf.Adapters.Raster.Albedo;
using Msisf.Adapters.Render;
using Msisf.Core.Errors;
using Msisf.Core.Render.Photometry;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Albedo;

public sealed class OpenedAlbedoMapTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("UNSIGNED_INTEGER", 8, 1.0, "SCALING_FACTOR = 0.001\r\n OFFSET = 0.02")]
    [InlineData("LSB_INTEGER", 16, 10.0, "SCALING_FACTOR = 0.0001\r\n OFFSET = 0.02")]
    [InlineData("\"lsb integer\"", 16, 100.0, "SCALING_FACTOR = 1E-5\r\n OFFSET = 0.02\r\n MISSING_CONSTANT = 16#8000#")]
    [InlineData("\"Pc Real\"", 32, 0.001, "OFFSET = 0.02\r\n MISSING_CONSTANT = 16#FF7FFFFB#")]
    [InlineData("MSB_UNSIGNED_INTEGER", 16, 100.0, "SCALING_FACTOR = 1E-5\r\n OFFSET = 0.02")]
    [InlineData("PC_REAL", 32, 0.001, "OFFSET = 0.02")]
    [InlineData("IEEE_REAL", 32, 0.001, "OFFSET = 0.02")]
    public void Open_PdsImage_HasTheLabelsReflectances(string type, int bits, double perStep, string scale)
    {
        string path = PdsMap.Write(_folder, "WAC_EMP_643NM_TEST", type, bits, 1, (column, row) => perStep * ((column + row) % 200), scale);

        using OpenedAlbedoMap map = OpenedAlbedoMap.Open(path, new MapProperties(), 643, _folder["cache"], gdalPath: null);

        AlbedoMapLevel finest = map.Map.Levels[0];
        Assert.Equal((360, 180), (finest.Width, finest.Height));
        Assert.Equal(new ReferenceGeometry(30.0, 0.0, 30.0), map.Map.Reference);
        Assert.Equal(0.02 + (0.001 * 17), Reflectance(map.Map, 10, 7), 3e-6); // a step of the 16-bit codes of 0.2
        Assert.Equal(0.02 + (0.001 * 199), Reflectance(map.Map, 199, 0), 3e-6);
        Assert.Equal((1, 1), (map.Map.Levels[^1].Width, map.Map.Levels[^1].Height));
        Assert.Equal(Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(path))), map.Sha256);
    }

    [Fact]
    public void Open_PartOfTheMoon_HasItsEdgesAndHoles()
    {
        string path = PdsMap.Write(
            _folder, "WAC_EMP_643NM_E300N0450_002P", "PC_REAL", 32, 2, (column, row) => column < 4 ? -3.4e38 : 0.1, west: 0.0, north: 60.0,
            degrees: (90, 60));

        using OpenedAlbedoMap map = OpenedAlbedoMap.Open(path, new MapProperties(), 643, cacheFolder: null, gdalPath: null);

        Assert.Equal(Math.PI / 3.0, map.Map.Extent.North, 12);
        Assert.Equal(Math.PI / 2.0, map.Map.Extent.Width, 12);
        Assert.False(map.Map.Extent.IsFullCircle);
        Assert.Equal(0, map.Map.Levels[0].Codes.Span[3]);
        Assert.Equal(0.1, Reflectance(map.Map, 4, 0), 1e-7); // all of one value: floats in the file
    }

    [Fact]
    public void Open_SecondTime_TakesTheLevelsFromTheCache()
    {
        string path = PdsMap.Write(_folder, "WAC_HAPKE_643NM", "PC_REAL", 32, 1, (column, _) => 0.001 * column);
        string cache = _folder["cache"];
        using (OpenedAlbedoMap first = OpenedAlbedoMap.Open(path, new MapProperties(), 643, cache, gdalPath: null))
        {
            Assert.Equal(0.1, Reflectance(first.Map, 100, 50), 1e-5); // 0.36 in 65,534 codes: 5.5e-6 a step
        }

        string levels = Assert.Single(Directory.GetFiles(Path.Combine(cache, "albedo")));
        DateTime written = File.GetLastWriteTimeUtc(levels);
        OpenedAlbedoMap.Open(path, new MapProperties(), 643, cache, gdalPath: null).Dispose();
        Assert.Equal(written, File.GetLastWriteTimeUtc(levels));

        // Another map of the same name has other levels.
        PdsMap.Write(_folder, "WAC_HAPKE_643NM", "PC_REAL", 32, 1, (column, _) => 0.002 * column);
        File.SetLastWriteTimeUtc(path, new DateTime(2020, 1, 1, 0, 0, 0, DateTimeKind.Utc));
        using OpenedAlbedoMap second = OpenedAlbedoMap.Open(path, new MapProperties(), 643, cache, gdalPath: null);
        Assert.Equal(0.2, Reflectance(second.Map, 100, 50), 2e-5);
    }

    [Fact]
    public void Open_DamagedCache_IsMadeAgain()
    {
        string path = PdsMap.Write(_folder, "WAC_HAPKE_643NM", "PC_REAL", 32, 1, (column, _) => 0.001 * column);
        OpenedAlbedoMap.Open(path, new MapProperties(), 643, _folder["cache"], gdalPath: null).Dispose();
        string levels = Assert.Single(Directory.GetFiles(Path.Combine(_folder["cache"], "albedo")));
        byte[] bytes = File.ReadAllBytes(levels);
        File.WriteAllBytes(levels, bytes[..^4096]);

        using OpenedAlbedoMap map = OpenedAlbedoMap.Open(path, new MapProperties(), 643, _folder["cache"], gdalPath: null);

        Assert.Equal(0.1, Reflectance(map.Map, 100, 50), 1e-5); // 0.36 in 65,534 codes: 5.5e-6 a step
        Assert.Equal(bytes.Length, new FileInfo(levels).Length);
    }

    [Fact]
    public void Open_OtherBand_IsBadInput()
    {
        string path = PdsMap.Write(_folder, "WAC_EMP_415NM_TEST", "PC_REAL", 32, 1, (_, _) => 0.1);

        Assert.Contains("a map at 415 nm, but --band is 643", Refused(path, new MapProperties()), StringComparison.Ordinal);
    }

    [Fact]
    public void Open_UnknownMap_AsksForWhatIsMissing()
    {
        string path = PdsMap.Write(_folder, "SOME_MAP", "PC_REAL", 32, 1, (_, _) => 0.1);

        string unknown = Refused(path, new MapProperties());
        Assert.Contains("its incidence, emission and phase angle is not known", unknown, StringComparison.Ordinal);
        MapProperties advised = MapProperties.Parse(unknown[unknown.IndexOf("scale=", StringComparison.Ordinal)..].TrimEnd('.'));
        using (OpenedAlbedoMap map = OpenedAlbedoMap.Open(path, advised, 643, _folder["cache"], gdalPath: null))
        {
            Assert.Equal(new ReferenceGeometry(60.0, 0.0, 60.0), map.Map.Reference);
            Assert.Equal(-Math.PI, map.Map.Extent.West, 1e-12);
        }

        Assert.Contains(
            "no surface has incidence 60, emission 0 and phase angle 30",
            Refused(path, MapProperties.Parse("incidence=60,emission=0,phase=30")),
            StringComparison.Ordinal);
    }

    /// <summary>A label that counts longitudes to the west; the one that counts to the east is read.</summary>
    [Fact]
    public void Open_LongitudesToTheWest_AreRefused()
    {
        string path = PdsMap.Write(_folder, "WAC_EMP_643NM_TEST", "PC_REAL", 32, 1, (_, _) => 0.1);
        byte[] map = File.ReadAllBytes(path);
        "POSITIVE_LONGITUDE_DIRECTION = WEST <X>\r\nEND_OBJECT = IMAGE_MAP_PROJECTION\r\nEND\r\n"u8.CopyTo(
            map.AsSpan(map.AsSpan().IndexOf("END_OBJECT = IMAGE_MAP_PROJECTION"u8)));
        File.WriteAllBytes(path, map);

        Assert.Contains(
            "POSITIVE_LONGITUDE_DIRECTION = WEST <X>; EAST is needed", Refused(path, new MapProperties()), StringComparison.Ordinal);
    }

    /// <summary>Parts of a coordinate system that move or scale a map of the reflectance count as they do for heights.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData("s, t = '+proj=longlat +R=1737400', [30, 0.01, 0, 20, 0, -0.01]", 30.0)]
    [InlineData("s, t = '+proj=longlat +R=1737400 +pm=10', [20, 0.01, 0, 20, 0, -0.01]", 30.0)]
    [InlineData("k = 0.303233504; s, t = '+proj=eqc +R=1737400 +units=km', [3000 * k, k, 0, 2000 * k, 0, -k]", 30.0)]
    [InlineData("k = 303.233504; s, t = '+proj=eqc +R=1737400 +pm=25', [500 * k, k, 0, 2000 * k, 0, -k]", 30.0)]
    public void Open_MeridianAndUnit_AreThoseOfTheFile(string then, double west)
    {
        string path = Heights.TestRaster.Write(_folder, "site.tif", then);
        MapProperties given = MapProperties.Parse("scale=1e-4,incidence=60,emission=0,phase=60");

        using OpenedAlbedoMap map = OpenedAlbedoMap.Open(path, given, 643, _folder["cache"], gdalPath: null);

        const double rounded = 1e-6; // degrees: the pixels of the files in m have nine digits
        Assert.Equal(west, double.RadiansToDegrees(map.Map.Extent.West), rounded);
        Assert.Equal(20.0, double.RadiansToDegrees(map.Map.Extent.North), rounded);
        Assert.Equal(3.0, double.RadiansToDegrees(map.Map.Extent.Width), rounded);
    }

    /// <summary>A map of the Moon whose file says that it is of the Earth: the advised program writes the right system into it.</summary>
    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Open_MapOfAnotherSphere_IsReadAsAdvised()
    {
        string path = Heights.TestRaster.Write(_folder, "site.tif", "s = '+proj=stere +lat_0=-90 +datum=WGS84'");
        MapProperties given = MapProperties.Parse("scale=1e-4,incidence=60,emission=0,phase=60");
        string message = Assert.Throws<BadInputException>(
            () => OpenedAlbedoMap.Open(path, given, 643, _folder["cache"], gdalPath: null)).Message;
        Assert.EndsWith("correct it with gdal_translate -a_srs.", message, StringComparison.Ordinal);
        ChildRun.Of(
            "gdal_translate", ["-q", "-a_srs", "+proj=stere +lat_0=-90 +R=1737400 +units=m", path, _folder["new.tif"]],
            _folder.Path).Succeeded();

        using OpenedAlbedoMap map = OpenedAlbedoMap.Open(_folder["new.tif"], given, 643, _folder["cache"], gdalPath: null);

        Assert.InRange(map.Map.Extent.North, -1.6, -1.4); // rad: at the south pole
    }

    [Fact]
    public void Open_ShortImage_IsBadInput()
    {
        string path = PdsMap.Write(_folder, "WAC_EMP_643NM_TEST", "PC_REAL", 32, 1, (_, _) => 0.1);
        File.WriteAllBytes(path, File.ReadAllBytes(path)[..^100]);

        Assert.Contains("bytes, 261248 expected", Refused(path, new MapProperties()), StringComparison.Ordinal);
    }

    [Fact]
    public void Open_NoLibraryOfGdal_IsAMissingPart()
    {
        string path = _folder.Write("map.tif", "II*\0");

        ExternalPartException failure = Assert.Throws<ExternalPartException>(
            () => OpenedAlbedoMap.Open(path, new MapProperties(), 643, cacheFolder: null, gdalPath: _folder["none.so"]));

        Assert.Contains("needs GDAL's library", failure.Message, StringComparison.Ordinal);
    }

    [RequiresFact(Part.GdalLibrary)]
    public void Open_PngByGdal_IsTheKnownColourMap()
    {
        byte[] greys = [.. Enumerable.Range(0, 64 * 32).Select(i => (byte)(i % 64))];
        string path = _folder["lroc_color_poles_test.png"];
        using (FileStream stream = File.Create(path))
        {
            PngWriter.Write(stream, greys, 64, GreyTransfer.Srgb);
        }

        using OpenedAlbedoMap map = OpenedAlbedoMap.Open(path, new MapProperties(), 566, _folder["cache"], gdalPath: null);

        Assert.Equal(2.63e-4 * 21, Reflectance(map.Map, 21, 9), Rounding.OfChains);
        Assert.Equal(-Math.PI, map.Map.Extent.West, 12);
        Assert.Contains(
            "its scale is known at 415, 566, 643, 689 nm, not at 604 nm",
            Assert.Throws<BadInputException>(
                () => OpenedAlbedoMap.Open(path, new MapProperties(), 604, _folder["cache"], gdalPath: null)).Message,
            StringComparison.Ordinal);
    }

    [RequiresFact(Part.GdalLibrary)]
    public void Open_NoImage_IsBadInput() =>
        Assert.Contains(
            "GDAL can't read it as an image", Refused(_folder.Write("a.tif", "no image"), new MapProperties()), StringComparison.Ordinal);

    private static double Reflectance(AlbedoMap map, int column, int row) =>
        map.Offset + (map.Step * map.Levels[0].Codes.Span[(row * map.Levels[0].Width) + column]);

    private static string Refused(string path, MapProperties properties) => Assert.Throws<BadInputException>(
        () => OpenedAlbedoMap.Open(path, properties, 643, cacheFolder: null, gdalPath: null)).Message;
}
