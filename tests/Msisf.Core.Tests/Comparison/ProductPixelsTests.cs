using Msisf.Core.Comparison;
using Xunit;

namespace Msisf.Core.Tests.Comparison;

public sealed class ProductPixelsTests
{
    /// <summary>Of a drawn image of 6 x 3, from its second sample on, means of 2 x 2; one of the four lines is not drawn.</summary>
    [Fact]
    public void Means_PartsGapsAndSky_AreCountedByHand()
    {
        ProductPixels pixels = new(2, 2, 1, 2, 2, [0, 2, -1, 1]);
        double[] drawn =
        [
            9, 1, 2, 3, double.NaN, 9,
            9, 10, 20, 30, 40, 9,
            9, 5, 6, 7, 8, 9,
        ];

        Assert.Equal([3.5f, 4.5f, 15.0f, 35.0f], pixels.Means(drawn, 6, ofSky: 0.0));
        Assert.Equal([3.5f, 6.0f, 15.0f, 35.0f], pixels.Means(drawn, 6, ofSky: double.NaN));
    }

    [Fact]
    public void Means_LinesThatAreNotDrawn_HaveNoValue() =>
        Assert.Equal([float.NaN, 4.0f], new ProductPixels(1, 2, 0, 1, 1, [-1, 0]).Means([4.0], 1, ofSky: 0.0));
}
