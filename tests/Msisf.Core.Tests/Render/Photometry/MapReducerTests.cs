using Msisf.Core.Render.Photometry;
using Xunit;

namespace Msisf.Core.Tests.Render.Photometry;

public class MapReducerTests
{
    /// <summary>A strip along the equator so narrow that all its rows have the same area.</summary>
    private static readonly MapExtent Strip = new(0.0, 1e-6, 0.1, 2e-6);

    [Theory]
    [InlineData(8, 6)]
    [InlineData(7, 5)]
    [InlineData(1, 5)]
    [InlineData(13, 1)]
    public void Add_AnySize_KeepsTheMean(int width, int height)
    {
        float[] fine = [.. Enumerable.Range(0, width * height).Select(i => (float)((i * 37) % 101))];

        (int coarseWidth, int coarseHeight, float[] coarse) = SyntheticMaps.Reduced(width, height, Strip, fine);

        Assert.Equal(((width + 1) / 2, (height + 1) / 2), (coarseWidth, coarseHeight));
        Assert.Equal(coarseWidth * coarseHeight, coarse.Length);
        Assert.Equal(fine.Average(), coarse.Average(), 1e-4); // floats up to 101, and means of them
    }

    [Fact]
    public void Add_EvenSize_IsTheMeanOfFour() =>
        Assert.Equal([3.5f, 5.5f], SyntheticMaps.Reduced(4, 2, Strip, [1f, 2f, 3f, 4f, 5f, 6f, 7f, 8f]).Values);

    [Fact]
    public void Add_WholeMoon_WeighsRowsByTheirArea()
    {
        // Rows at 67.5 and 22.5 degrees north: weights cos 67.5 : cos 22.5 = 0.382683 : 0.923880.
        float[] fine = [10f, 10f, 20f, 20f, 20f, 20f, 10f, 10f];
        float[] coarse = SyntheticMaps.Reduced(2, 4, SyntheticMaps.WholeMoon, fine).Values;

        Assert.Equal(2, coarse.Length);
        Assert.All(coarse, value => Assert.Equal(17.0711, value, 1e-4));
    }

    [Fact]
    public void Add_PixelsWithoutData_DoNotCount() => Assert.Equal(
        [2f, float.NaN], SyntheticMaps.Reduced(4, 2, Strip, [1f, float.NaN, float.NaN, float.NaN, 3f, float.NaN, float.NaN,
            float.NaN]).Values);
}
