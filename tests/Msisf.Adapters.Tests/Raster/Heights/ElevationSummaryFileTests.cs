using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

public sealed class ElevationSummaryFileTests : IDisposable
{
    private static readonly SummarySource Source = new(
        "TEST_1", 1, 129_600, new DateTimeOffset(2017, 9, 15, 0, 0, 0, TimeSpan.Zero), "PRODUCT_ID = TEST_1");

    private readonly string _folder = Directory.CreateTempSubdirectory("msisf-summary-").FullName;

    private string FilePath => Path.Combine(_folder, "TEST_1.SUM");

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Open_StoredSummary_ReadsNothingAgain()
    {
        CountingGrid grid = new();
        ElevationSummary built = ElevationSummary.Build(grid);
        File.WriteAllBytes(FilePath, Content());
        int reads = grid.Reads;

        ElevationSummary opened = ElevationSummaryFile.Open(FilePath, Source, grid);

        Assert.True(reads > 0);
        Assert.Equal(built.ToValues(), opened.ToValues());
        Assert.Equal(reads, grid.Reads);
    }

    [Fact]
    public void StoreIfWorthwhile_LittleWasRead_StoresNothing()
    {
        Assert.Null(ElevationSummaryFile.StoreIfWorthwhile(FilePath, Source, ElevationSummary.Build(new CountingGrid())));
        Assert.Empty(Directory.GetFiles(_folder));
    }

    [Fact]
    public void StoreIfWorthwhile_MuchWasRead_StoresIt()
    {
        string? warning = ElevationSummaryFile.StoreIfWorthwhile(
            FilePath, Source, ElevationSummary.Build(new CountingGrid()), minSamplesRead: 100);

        Assert.Null(warning);
        Assert.Equal(Content(), File.ReadAllBytes(FilePath));
        Assert.Single(Directory.GetFiles(_folder));
    }

    [Fact]
    public void Read_AnyPartOfTheSourceDiffers_IsNoSummary()
    {
        byte[] content = Content();

        Assert.NotNull(ElevationSummaryFile.Read(content, Source, new CountingGrid()));
        Assert.Null(ElevationSummaryFile.Read(content, Source with { ProductId = "TEST_2" }, new CountingGrid()));
        Assert.Null(ElevationSummaryFile.Read(content, Source with { ImageBytes = 129_601 }, new CountingGrid()));
        Assert.Null(ElevationSummaryFile.Read(content, Source with { ImageWritten = Source.ImageWritten.AddTicks(1) }, new CountingGrid()));
        Assert.Null(ElevationSummaryFile.Read(content, Source with { LabelText = Source.LabelText + " " }, new CountingGrid()));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(71)]
    [InlineData(72)]
    [InlineData(100)]
    [InlineData(1000)]
    public void Read_Truncated_IsNoSummary(int bytes) =>
        Assert.Null(ElevationSummaryFile.Read(Content().AsSpan(0, bytes), Source, new CountingGrid()));

    [Theory]
    [InlineData(3)]
    [InlineData(20)]
    [InlineData(50)]
    [InlineData(5000)]
    public void Read_OneByteChanged_IsNoSummary(int position)
    {
        byte[] content = Content();
        content[position] ^= 1;

        Assert.Null(ElevationSummaryFile.Read(content, Source, new CountingGrid()));
    }

    [Theory]
    [InlineData("not a summary")]
    [InlineData("")]
    public void Open_DamagedFile_KnowsNothing(string content)
    {
        File.WriteAllText(FilePath, content);

        Assert.All(ElevationSummaryFile.Open(FilePath, Source, new CountingGrid()).ToValues(), value => Assert.Equal(0.0F, value));
    }

    [Fact]
    public void StoreIfWorthwhile_FolderInTheWay_WarnsAndGoesOn()
    {
        Directory.CreateDirectory(FilePath);
        ElevationSummary summary = ElevationSummaryFile.Open(FilePath, Source, new CountingGrid());

        Assert.Contains(
            "TEST_1.SUM", ElevationSummaryFile.StoreIfWorthwhile(FilePath, Source, summary, minSamplesRead: 0), StringComparison.Ordinal);
    }

    private static byte[] Content()
    {
        using MemoryStream stream = new();
        ElevationSummaryFile.Write(stream, Source, ElevationSummary.Build(new CountingGrid()));
        return stream.ToArray();
    }

    private sealed class CountingGrid : IGlobalGrid
    {
        public int Reads { get; private set; }

        public string ProductId => "TEST_1";

        public int PixelsPerDegree => 1;

        public void ReadRadii(int line, int firstSample, Span<double> radii)
        {
            Reads++;
            for (int index = 0; index < radii.Length; index++)
            {
                radii[index] = 1_737_000.0 + (((line * 7) + ((firstSample + index) % 360 * 13)) % 900);
            }
        }
    }
}
