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
        IReadOnlyList<SampledBand> bands = Cut(_ => SamplePattern.MaxVectors * Width).Bands;

        Assert.All(bands, band => Assert.InRange(band.LastRow - band.FirstRow + 1, 8, 16));
        Assert.Equal(Height * SamplePattern.MaxVectors * Width, bands.Sum(band => band.Vectors));
        Assert.Equal(
            Enumerable.Range(0, Height), bands.SelectMany(band => Enumerable.Range(band.FirstRow, band.LastRow - band.FirstRow + 1)));
    }

    private static SampledPixels Cut(Func<int, int> vectorsOfRow)
    {
        SampledPixels pixels = new();
        pixels.Prepare(Width, Height);
        for (int row = 0; row < Height; row++)
        {
            pixels.VectorsOfRow[row] = vectorsOfRow(row);
        }

        pixels.Cut();
        return pixels;
    }
}
