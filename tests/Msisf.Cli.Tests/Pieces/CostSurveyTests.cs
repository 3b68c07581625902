using Msisf.Cli.Pieces;
using Xunit;

namespace Msisf.Cli.Tests.Pieces;

public sealed class CostSurveyTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(1000)]
    public void Places_ShortRun_AreAllFrames(int count) => Assert.Equal(Enumerable.Range(0, count), CostSurvey.Places(count));

    [Theory]
    [InlineData(1001)]
    [InlineData(1_000_000)]
    [InlineData(10_000_000)]
    public void Places_LongRun_AreSpreadFromTheFirstToTheLast(int count)
    {
        int[] places = CostSurvey.Places(count);

        Assert.Equal((CostSurvey.MaxFramesLookedAt, 0, count - 1), (places.Length, places[0], places[^1]));
        int[] gaps = [.. places.Zip(places.Skip(1), (place, next) => next - place)];
        Assert.InRange(gaps.Max() - gaps.Min(), 0, 1);
    }

    [Fact]
    public void Interpolate_BetweenPlaces_IsAStraightLine() =>
        Assert.Equal([1.0, 2.0, 3.0, 2.5, 2.0], CostSurvey.Interpolate([0, 2, 4], [1.0, 3.0, 2.0], 5));

    [Fact]
    public void Interpolate_EachFrameLookedAt_IsTheCostItself() =>
        Assert.Equal([1.0, 5.0, 2.0], CostSurvey.Interpolate([0, 1, 2], [1.0, 5.0, 2.0], 3));
}
