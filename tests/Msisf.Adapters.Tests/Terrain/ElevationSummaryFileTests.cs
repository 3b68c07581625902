using Msisf.Adapters.Terrain;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;
using Xunit;

namespace Msisf.Adapters.Tests.Terrain;

public sealed class ElevationSummaryFileTests : IDisposable
{
    private static readonly SummarySource Source = new(
        "TEST_1", 1, 129_600, new DateTimeOffset(2017, 9, 15, 0, 0, 0, TimeSpan.Zero), "PRODUCT_ID = TEST_1");

    private readonly string _folder = Directory.CreateTempSubdirectory("msisf-summary-").FullName;

    private string FilePath => Path.Combine(_folder, "TEST_1.SUM");

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void LoadOrBuild_NoFile_BuildsAndStores()
    {
        CountingGrid grid = new();
        (ElevationSummary first, string? warning) = ElevationSummaryFile.LoadOrBuild(FilePath, Source, grid);
        int reads = grid.Reads;
        (ElevationSummary second, _) = ElevationSummaryFile.LoadOrBuild(FilePath, Source, grid);

        Assert.Null(warning);
        Assert.True(reads > 0);
        Assert.Equal(reads, grid.Reads); // the second time the model is not touched
        Assert.Equal(first.ToValues(), second.ToValues());
        Assert.Equal(first.MaxRadius, second.MaxRadius);
    }

    [Fact]
    public void Read_AnyPartOfTheSourceDiffers_IsNoSummary()
    {
        byte[] content = Content();

        Assert.NotNull(ElevationSummaryFile.Read(content, Source));
        Assert.Null(ElevationSummaryFile.Read(content, Source with { ProductId = "TEST_2" }));
        Assert.Null(ElevationSummaryFile.Read(content, Source with { ImageBytes = 129_601 }));
        Assert.Null(ElevationSummaryFile.Read(content, Source with { ImageWritten = Source.ImageWritten.AddTicks(1) }));
        Assert.Null(ElevationSummaryFile.Read(content, Source with { LabelText = Source.LabelText + " " }));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(71)]
    [InlineData(72)]
    [InlineData(100)]
    [InlineData(1000)]
    public void Read_Truncated_IsNoSummary(int bytes) => Assert.Null(ElevationSummaryFile.Read(Content().AsSpan(0, bytes), Source));

    [Theory]
    [InlineData(3)]
    [InlineData(20)]
    [InlineData(50)]
    [InlineData(5000)]
    public void Read_OneByteChanged_IsNoSummary(int position)
    {
        byte[] content = Content();
        content[position] ^= 1;

        Assert.Null(ElevationSummaryFile.Read(content, Source));
    }

    [Fact]
    public void LoadOrBuild_DamagedFile_IsMadeAgain()
    {
        File.WriteAllText(FilePath, "not a summary");
        ElevationSummaryFile.LoadOrBuild(FilePath, Source, new CountingGrid());

        Assert.Equal(Content(), File.ReadAllBytes(FilePath));
        Assert.Single(Directory.GetFiles(_folder));
    }

    [Fact]
    public void LoadOrBuild_FolderInTheWay_WarnsAndGoesOn()
    {
        Directory.CreateDirectory(FilePath);
        (ElevationSummary summary, string? warning) = ElevationSummaryFile.LoadOrBuild(FilePath, Source, new CountingGrid());

        Assert.InRange(summary.MinRadius, 1_736_999.0, 1_737_001.0);
        Assert.Contains("TEST_1.SUM", warning, StringComparison.Ordinal);
    }

    private static byte[] Content()
    {
        using MemoryStream stream = new();
        ElevationSummaryFile.Write(stream, Source, ElevationSummary.Build(new CountingGrid()));
        return stream.ToArray();
    }

    private sealed class CountingGrid : IElevationGrid
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

        public (double Minimum, double Maximum) RadiusBounds(int firstLine, int lines, int firstSample, int samples) =>
            throw new NotSupportedException();
    }
}
