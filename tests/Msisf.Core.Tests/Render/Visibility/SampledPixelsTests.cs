using Msisf.Core.Render.Visibility;
using Xunit;

namespace Msisf.Core.Tests.Render.Visibility;

/// <summary>The bands in which further samples are drawn.</summary>
public sealed class SampledPixelsTests
{
    private const int Width = 1000;

    /// <summary>One band of 64 rows, one of 64 and one of 22.</summary>
    private const int Height = 150;

    [Fact]
    public void Cut_FewSamples_BandsAreThoseOfTheVisibleSurface() =>
        Assert.Equal([new SampledBand(0, 63, 64), new SampledBand(64, 127, 64), new SampledBand(128, 149, 22)], Cut(_ => 1).Bands);

    [Fact]
    public void Cut_RowsWithoutSamples_AreInNoBand() =>
        Assert.Equal([new SampledBand(64, 127, 7)], Cut(row => row == 100 ? 7 : 0).Bands);

    [Fact]
    public void Cut_AllSamplesInEveryPixel_BandsHave16RowsAndTogetherAllVectors()
    {
        IReadOnlyList<SampledBand> bands = Cut(_ => SamplePattern.StratifiedVectors * Width).Bands;

        Assert.All(bands, band => Assert.InRange(band.LastRow - band.FirstRow + 1, 8, 16));
        Assert.Equal(Height * SamplePattern.StratifiedVectors * Width, bands.Sum(band => band.Vectors));
        Assert.Equal(
            Enumerable.Range(0, Height), bands.SelectMany(band => Enumerable.Range(band.FirstRow, band.LastRow - band.FirstRow + 1)));
    }

    [Fact]
    public void Fill_GridOf256_BandsHaveOneRowAtLeastAndBoundedMemory()
    {
        SampledPixels pixels = new();
        pixels.Fill(SamplePattern.Grid(16), 16384, 8, hasBorders: true);

        Assert.Equal(8, pixels.Bands.Count);
        Assert.All(pixels.Bands, band => Assert.Equal(32 * 16384, band.Vectors));
        Assert.Equal(32, pixels.Codes[0] & SampledPixels.Vectors);
        Assert.Equal(SampledPixels.HasBorder, pixels.Codes[0] & SampledPixels.HasBorder);
    }

    private static SampledPixels Cut(Func<int, int> vectorsOfRow)
    {
        SampledPixels pixels = new();
        pixels.Prepare(SamplePattern.Stratified, Width, Height);
        for (int row = 0; row < Height; row++)
        {
            pixels.VectorsOfRow[row] = vectorsOfRow(row);
        }

        pixels.Cut();
        return pixels;
    }
}
