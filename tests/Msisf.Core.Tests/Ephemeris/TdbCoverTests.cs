using Msisf.Core.Ephemeris;
using Xunit;

namespace Msisf.Core.Tests.Ephemeris;

public class TdbCoverTests
{
    [Fact]
    public void Union_OverlappingTouchingAndApart_MergesTheFirstTwo()
    {
        TdbCover cover = TdbCover.Union([new(50.0, 60.0), new(10.0, 20.0), new(0.0, 10.0), new(2.0, 5.0)]);

        Assert.Equal([new TdbInterval(0.0, 20.0), new TdbInterval(50.0, 60.0)], cover.Intervals);
    }

    [Fact]
    public void Intersect_TwoCovers_KeepsWhatBothHold()
    {
        TdbCover a = TdbCover.Union([new(0.0, 10.0), new(20.0, 30.0)]);
        TdbCover b = TdbCover.Union([new(5.0, 25.0)]);

        Assert.Equal([new TdbInterval(5.0, 10.0), new TdbInterval(20.0, 25.0)], a.Intersect(b).Intervals);
        Assert.Equal(a.Intervals, a.Intersect(TdbCover.Everything).Intervals);
        Assert.Empty(a.Intersect(TdbCover.Empty).Intervals);
    }

    [Theory]
    [InlineData(-0.001, false)]
    [InlineData(0.0, true)]
    [InlineData(10.0, true)]
    [InlineData(15.0, false)]
    [InlineData(20.0, true)]
    [InlineData(30.001, false)]
    public void Contains_TwoIntervals_BothEndsBelong(double time, bool expected) =>
        Assert.Equal(expected, TdbCover.Union([new(0.0, 10.0), new(20.0, 30.0)]).Contains(time));
}
