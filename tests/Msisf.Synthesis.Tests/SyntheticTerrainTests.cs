using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Synthesis.Tests;

public sealed class SyntheticTerrainTests
{
    [Theory]
    [InlineData(4)]
    [InlineData(2)]
    [InlineData(10)]
    [InlineData(12)]
    public void New_NoEvenMultipleOfTheBase_SaysWhatFits(int pixelsPerDegree)
    {
        BadInputException exception = Assert.Throws<BadInputException>(
            () => new SyntheticTerrain(pixelsPerDegree, 1, FunctionGrid.OfHeights(4, (_, _) => 0.0)));
        Assert.Contains("even multiple", exception.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-4)]
    [InlineData(SyntheticTerrain.LargestResolution + 1)]
    public void New_ResolutionOutOfRange_IsRefused(int pixelsPerDegree) =>
        Assert.Throws<BadInputException>(() => new SyntheticTerrain(pixelsPerDegree, 1, baseModel: null));

    [Fact]
    public void CratersNear_WithBase_AreSmallerThanTheBaseShows()
    {
        const double BasePixel = 7580.84; // m
        SyntheticTerrain terrain = new(64, 1, FunctionGrid.OfHeights(4, (_, _) => 0.0));
        double[] diameters = [.. terrain.CratersNear(new TileFrame(64, 5000, 640, 3000, 1280)).Select(crater => 2.0 * crater.Radius)];
        Assert.InRange(diameters.Max(), BasePixel, 2.0 * BasePixel);
        Assert.InRange(diameters.Min(), 3.0 * BasePixel / 16.0, 3.1 * BasePixel / 16.0);
    }
}
