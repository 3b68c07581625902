using System.Security.Cryptography;
using System.Text;
using Msisf.Adapters.Raster.Albedo;
using Msisf.Core.Errors;
using Msisf.Core.Render.Photometry;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Albedo;

public sealed class AlbedoTilesTests : IDisposable
{
    private const string Map = "WAC_EMP_643NM";

    private static readonly (string Type, int Bits) Real = ("PC_REAL", 32);

    private readonly TemporaryFolder _folder = new();
    private readonly TemporaryFolder _single = new();

    public void Dispose()
    {
        _folder.Dispose();
        _single.Dispose();
    }

    /// <summary>Of 3 px/deg all but the finest levels have pixels that lie across seams.</summary>
    [Theory]
    [InlineData("PC_REAL", 32, 60)]
    [InlineData("UNSIGNED_INTEGER", 8, 60)]
    [InlineData("UNSIGNED_INTEGER", 8, 90)]
    public void Open_EightTiles_HaveTheLevelsOfOneFile(string type, int bits, int top)
    {
        string file = PdsMap.Write(_single, Map, type, bits, 3, Value, west: 0.0, north: top, degrees: (360, 2 * top));
        string[] tiles = PdsMapTiles.WriteEight(_folder, Map, (type, bits), 3, top, Value);
        PdsMapTiles.WriteEight(_folder, "WAC_EMP_415NM", (type, bits), 1, top, Value);
        using OpenedAlbedoMap one = Open(file);

        using OpenedAlbedoMap ofFolder = Open(_folder.Path);
        using OpenedAlbedoMap ofTile = Open(tiles[6]);

        Assert.All((OpenedAlbedoMap[])[ofFolder, ofTile], many =>
        {
            Assert.Equal(
                (one.Map.Extent, one.Map.Offset, one.Map.Step, one.Map.Reference),
                (many.Map.Extent, many.Map.Offset, many.Map.Step, many.Map.Reference));
            Assert.Equal(one.Map.Levels.Count, many.Map.Levels.Count);
            Assert.All(one.Map.Levels.Zip(many.Map.Levels), pair =>
            {
                Assert.Equal((pair.First.Width, pair.First.Height), (pair.Second.Width, pair.Second.Height));
                Assert.True(pair.First.Codes.Span.SequenceEqual(pair.Second.Codes.Span));
            });
            Assert.Equal(tiles.Select(Path.GetFileName), many.Files.Select(input => input.Name));
        });
    }

    [Fact]
    public void Open_Tiles_HaveTheChecksumsOfEachAndOfAll()
    {
        string[] tiles = PdsMapTiles.WriteEight(_folder, Map, Real, 1, 60, Value);
        string cache = _single["cache"];
        string[] expected = [.. tiles.Select(tile => Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(tile))))];
        string ofAll = Convert.ToHexStringLower(SHA256.HashData(Encoding.ASCII.GetBytes(string.Concat(expected))));

        // The first time they are computed, the second time they come from the cache.
        for (int time = 0; time < 2; time++)
        {
            using OpenedAlbedoMap map = Open(_folder.Path, cache);
            Assert.Equal(expected, map.Files.Select(file => file.Sha256));
            Assert.Equal((Path.GetFileName(tiles[0]), ofAll), (map.Whole.Name, map.Whole.Sha256));
            Assert.Equal(tiles.Sum(tile => new FileInfo(tile).Length), map.Whole.Bytes);
            Assert.Single(Directory.GetFiles(Path.Combine(cache, "albedo")));
        }

        PdsMapTiles.Write(_folder, Map, Real, 1, 60, (_, _) => 0.5, (180, 0, 60));
        File.SetLastWriteTimeUtc(tiles[6], new DateTime(2020, 1, 1, 0, 0, 0, DateTimeKind.Utc));
        using OpenedAlbedoMap changed = Open(_folder.Path, cache);
        Assert.Equal(0.5, Reflectance(changed.Map, 200, 70), 1e-4);
        Assert.NotEqual(expected[6], changed.Files[6].Sha256);
    }

    [Fact]
    public void Open_TilesBesideThePrimeMeridian_AreAMapOfAPart()
    {
        PdsMapTiles.Write(_folder, Map, Real, 1, 60, (_, _) => 0.1, (0, 60, 60));
        PdsMapTiles.Write(_folder, Map, Real, 1, 60, (_, _) => 0.2, (270, 60, 60));
        PdsMapTiles.Write(_folder, Map, Real, 1, 60, (_, _) => 0.3, (0, 0, 60));

        using OpenedAlbedoMap map = Open(_folder.Path);

        Assert.Equal(1.5 * Math.PI, map.Map.Extent.West, 12);
        Assert.Equal(Math.PI, map.Map.Extent.Width, 12);
        Assert.Equal((180, 120), (map.Map.Levels[0].Width, map.Map.Levels[0].Height));
        Assert.Equal([0.2, 0.1, 0.3], [Reflectance(map.Map, 89, 59), Reflectance(map.Map, 90, 0), Reflectance(map.Map, 90, 60)], Near);
        Assert.Equal(0, map.Map.Levels[0].Codes.Span[(60 * 180) + 89]);
    }

    [Fact]
    public void Open_PolarTiles_AreLeftOutByName()
    {
        PdsMapTiles.WriteEight(_folder, Map, Real, 1, 60, Value);
        string polar = Polar();

        using OpenedAlbedoMap map = Open(_folder.Path);

        Assert.Contains(Path.GetFileName(polar), Assert.Single(map.Notes), StringComparison.Ordinal);
        Assert.Equal(8, map.Files.Count);
        Assert.Contains(Path.GetFileName(polar), Refused(polar), StringComparison.Ordinal); // GDAL knows no radius of it
    }

    [Fact]
    public void Open_WrongTiles_AreNamed()
    {
        string[] tiles = PdsMapTiles.WriteEight(_folder, Map, Real, 1, 60, Value);
        Assert.Contains(
            "no map at 566 nm is in this folder, only WAC_EMP_643NM_064P", Refused(_folder.Path, 566), StringComparison.Ordinal);

        AssertRefused(() => File.Delete(tiles[2]), "WAC_EMP_643NM_064P no tile shows latitude 0 to 60, longitude 180 to 270", tiles[0]);
        AssertRefused(
            () => Tile(180, 60, 59), "no tile shows latitude 0 to 1, longitude 180 to 270", _folder.Path); // a row is missing
        File.Delete(_folder[$"{PdsMapTiles.Name(Map, "064P", 180, 60, 59)}.IMG"]);
        AssertRefused(() => Tile(180, 60, 61), "both show latitude -1 to 0, longitude 180 to 270", _folder.Path);
        File.Delete(_folder[$"{PdsMapTiles.Name(Map, "064P", 180, 60, 61)}.IMG"]);
        AssertRefused(() => Tile(180, 60, 60, ("IEEE_REAL", 32)), "SAMPLE_TYPE is ", _folder.Path);
        AssertRefused(() => Tile(180, 60, 60, Real, "SCALING_FACTOR = 2.0"), "SCALING_FACTOR is ", _folder.Path);
        AssertRefused(() => Tile(180, 60, 60, Real, "UNIT = \"PERCENT\""), "UNIT is ", _folder.Path);
        AssertRefused(
            () => PdsMapTiles.Write(_folder, Map, Real, 2, 60, Value, (180, 60, 60)), "MAP_RESOLUTION is ", _folder.Path);
        AssertRefused(() => File.WriteAllText(tiles[2], "PDS_VERSION_ID = PDS3\r\nOBJECT = IMAGE\r\nEND\r\n"), tiles[2], _folder.Path);
        AssertRefused(
            () => File.Copy(tiles[1], tiles[2], overwrite: true), "both show latitude 0 to 60, longitude 90 to 180", _folder.Path);
    }

    [Fact]
    public void Open_WrongFolders_SayWhatIsThere()
    {
        Assert.Contains("no map with a PDS3 label is in this folder", Refused(_folder.Path), StringComparison.Ordinal);

        string polar = Polar();
        Assert.Contains($"{polar}: of WAC_EMP_643NM_064P only polar", Refused(_folder.Path), StringComparison.Ordinal);

        PdsMapTiles.Write(_folder, "WAC_HAPKE_643NM", Real, 1, 70, Value, (0, 70, 70));
        Assert.Contains(
            "several maps are in this folder: WAC_EMP_643NM_064P, WAC_HAPKE_643NM_064P.", Refused(_folder.Path), StringComparison.Ordinal);
    }

    private static double Value(int column, int row) => 1 + (((37 * column) + (91 * row) + (column * row % 17)) % 250);

    private static bool Near(double one, double other) => Math.Abs(one - other) < 1e-5;

    private static double Reflectance(AlbedoMap map, int column, int row) =>
        map.Offset + (map.Step * map.Levels[0].Codes.Span[(row * map.Levels[0].Width) + column]);

    private static OpenedAlbedoMap Open(string path, string? cache = null, int band = 643) =>
        OpenedAlbedoMap.Open(path, new MapProperties(), band, cache, gdalPath: null);

    private static string Refused(string path, int band = 643) =>
        Assert.Throws<BadInputException>(() => Open(path, band: band)).Message;

    private static void AssertRefused(Action spoil, string message, string path)
    {
        spoil();
        Assert.Contains(message, Refused(path), StringComparison.Ordinal);
    }

    private string Tile(int west, int north, int height, (string Type, int Bits)? type = null, string more = "") =>
        PdsMapTiles.Write(_folder, Map, type ?? Real, 1, 60, Value, (west, north, height), more);

    private string Polar()
    {
        string path = PdsMap.Write(_folder, "WAC_EMP_643NM_P900N0000_064P", "PC_REAL", 32, 1, (_, _) => 0.1, degrees: (30, 30));
        byte[] bytes = File.ReadAllBytes(path);
        byte[] name = Encoding.ASCII.GetBytes("\"EQUIRECTANGULAR\"\r\n");
        Encoding.ASCII.GetBytes("POLAR_STEREO      ").CopyTo(bytes, bytes.AsSpan().IndexOf(name));
        File.WriteAllBytes(path, bytes);
        return path;
    }
}
