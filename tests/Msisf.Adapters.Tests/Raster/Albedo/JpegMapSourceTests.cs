using Msisf.Adapters.Raster.Albedo;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Albedo;

/// <summary>Maps in JPEG images, judged by GDAL's decoder, which is libjpeg.</summary>
public sealed class JpegMapSourceTests : IDisposable
{
    private const int Width = 213;
    private const int Height = 107;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>Odd sizes, so that blocks and chroma samples are cut at the borders.</summary>
    [RequiresTheory(Part.Gdal, Part.GdalLibrary)]
    [InlineData(3, "QUALITY=75")]
    [InlineData(3, "QUALITY=100")]
    [InlineData(3, "QUALITY=60", "PROGRESSIVE=ON")]
    [InlineData(1, "QUALITY=85")]
    public void Read_ImagesOfGdal_AreTheSameNumbers(int bands, params string[] options)
    {
        string path = Jpeg(bands, options);
        using JpegMapSource own = JpegMapSource.TryOpen(path)!;
        using GdalMapSource gdal = GdalMapSource.Open(path, libraryPath: null);

        Assert.Equal((Width, Height, null, true), (own.Width, own.Height, own.Extent, own.IsBytes));
        Assert.Equal(Rows(gdal, 0, Height), Rows(own, 0, Height));
        Assert.InRange(Rows(own, 0, Height).Distinct().Count(), 100, 256);
    }

    [RequiresFact(Part.Gdal, Part.GdalLibrary)]
    public void Read_RowsInAnyOrder_AreTheRowsOfTheWholeImage()
    {
        using JpegMapSource map = JpegMapSource.TryOpen(Jpeg(3))!;
        float[] whole = Rows(map, 0, Height);

        foreach ((int first, int count) in ((int, int)[])[(40, 16), (56, 1), (90, 17), (3, 5), (0, 1)])
        {
            Assert.Equal(whole[(first * Width)..((first + count) * Width)], Rows(map, first, count));
        }
    }

    [RequiresFact(Part.Gdal)]
    public void TryOpen_ImageThatIsPlacedOnAMap_IsLeftToGdal()
    {
        string path = Jpeg(1);
        File.WriteAllText(Path.ChangeExtension(path, ".jgw"), "0.1\n0\n0\n-0.1\n0\n0\n");

        Assert.Null(JpegMapSource.TryOpen(path));
    }

    [Fact]
    public void TryOpen_OtherFile_IsNull() => Assert.Null(JpegMapSource.TryOpen(_folder.Write("map.jpg", "P5 1 1 255 x")));

    [RequiresTheory(Part.Gdal)]
    [InlineData(0.001, 1)]
    [InlineData(0.6, 30)]
    public void Read_ImageThatIsCutOff_SaysWhereItIsDamaged(double share, int leastRow)
    {
        string path = Jpeg(3, "QUALITY=100");
        byte[] whole = File.ReadAllBytes(path);
        File.WriteAllBytes(path, whole[..(int)(share * whole.Length)]);

        BadInputException failure = Assert.Throws<BadInputException>(() =>
        {
            using JpegMapSource map = JpegMapSource.TryOpen(path)!;
            Rows(map, 0, Height);
        });

        Assert.StartsWith($"{path}: the JPEG image is damaged or cut off at row ", failure.Message, StringComparison.Ordinal);
        string row = failure.Message.Split("row ")[1].Split('.')[0];
        Assert.InRange(int.Parse(row, System.Globalization.CultureInfo.InvariantCulture), leastRow, Height);
    }

    private static float[] Rows(MapSource source, int first, int count)
    {
        float[] rows = new float[count * source.Width];
        source.Read(first, count, rows);
        return rows;
    }

    /// <summary>Writes an image of smooth colours and coarse noise with libjpeg, by GDAL.</summary>
    private string Jpeg(int bands, params string[] options)
    {
        byte[] pixels = new byte[Width * Height * bands];
        Random random = new(20260101);
        for (int i = 0; i < pixels.Length; i++)
        {
            (int x, int y, int band) = (i / bands % Width, i / bands / Width, i % bands);
            pixels[i] = (byte)(((x * (band + 1)) + (2 * y) + random.Next(40)) % 256);
        }

        byte[] head = System.Text.Encoding.ASCII.GetBytes($"P{(bands == 1 ? "5" : "6")}\n213 107\n255\n");
        _folder.Write("map.ppm", [.. head, .. pixels]);
        string[] words = ["-q", "-of", "JPEG", .. options.SelectMany(option => (string[])["-co", option]), "map.ppm", "map.jpg"];
        ChildRun.Of(TestParts.Program("gdal_translate")!, words, _folder.Path).Succeeded();
        return _folder["map.jpg"];
    }
}
