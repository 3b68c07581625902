using Msisf.Adapters.Synthesis;
using Msisf.Core.Terrain;
using Xunit;

namespace Msisf.Adapters.Tests.Synthesis;

public sealed class RegionWeightsTests
{
    /// <summary>One sample a degree, so that a sample is a degree: longitudes 358 to 2, latitudes 10 to 20, two degrees to fade.</summary>
    private static readonly RegionWeights Weights = new(MoonRegion.Parse("10:20:358:2"), pixelsPerDegree: 1, fadeDegrees: 2.0);

    [Theory]
    [InlineData(358, 1.0)]
    [InlineData(1, 1.0)]
    [InlineData(2, 0.7407407)] // 3 t^2 - 2 t^3 of 2/3
    [InlineData(3, 0.2592593)] // of 1/3
    [InlineData(4, 0.0)]
    [InlineData(357, 0.7407407)]
    [InlineData(355, 0.0)]
    [InlineData(180, 0.0)]
    public void At_ColumnsAroundThePrimeMeridian_FadeOnBothSides(int column, double expected) =>
        Assert.Equal(expected, Weights.At(75, column), 1e-6); // weights are floats

    [Theory]
    [InlineData(70, 1.0)]
    [InlineData(79, 1.0)]
    [InlineData(69, 0.7407407)]
    [InlineData(81, 0.2592593)]
    [InlineData(82, 0.0)]
    public void At_LinesNorthAndSouth_FadeLikewise(int line, double expected) =>
        Assert.Equal(expected, Weights.At(line, 0), 1e-6); // weights are floats

    [Fact]
    public void Extents_OfABlock_HoldAllThatHasDetail()
    {
        Assert.Equal((68, 14), Weights.LinesWithDetail(60, 60));
        Assert.Equal((356, 4), Weights.ColumnsWithDetail(350, 10));
        Assert.Equal((0, 4), Weights.ColumnsWithDetail(0, 90));
        Assert.Equal(0, Weights.ColumnsWithDetail(90, 90).Count);
    }

    [Fact]
    public void At_SharpBorder_HasNoFading()
    {
        RegionWeights sharp = new(new MoonRegion(10, 20, 30, 40), pixelsPerDegree: 1, fadeDegrees: 0.0);

        Assert.Equal((0.0f, 1.0f, 1.0f, 0.0f), (sharp.At(75, 29), sharp.At(75, 30), sharp.At(75, 39), sharp.At(75, 40)));
    }

    [Fact]
    public void At_WholeMoon_IsOneEverywhere()
    {
        RegionWeights whole = new(MoonRegion.WholeMoon, pixelsPerDegree: 1, fadeDegrees: 2.0);

        Assert.All(Enumerable.Range(0, 360), column => Assert.Equal(1.0f, whole.At(column / 2, column)));
    }
}
