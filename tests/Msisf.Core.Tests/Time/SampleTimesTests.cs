using Msisf.Core.Numerics;
using Msisf.Core.Time;
using Xunit;

namespace Msisf.Core.Tests.Time;

public sealed class SampleTimesTests
{
    [Theory]
    [InlineData(4.4, 4, 3)] // samples 3 to 6: two on each side
    [InlineData(5.0, 4, 4)] // a sample counts as before
    [InlineData(0.2, 4, 0)] // at the start, all after it
    [InlineData(9.9, 4, 7)] // samples 7 to 10
    [InlineData(4.4, 3, 3)] // about 4, which is nearest
    [InlineData(4.6, 3, 4)] // about 5
    public void Around_TenSteps_TakesTheNearest(double time, int size, int first)
    {
        SampleTimes times = Of([.. Enumerable.Range(0, 11).Select(i => (double)i)]);

        Assert.Equal((first, size), times.Around(time, size));
    }

    [Fact]
    public void Around_FewerSamplesThanAskedFor_TakesAll() => Assert.Equal((0, 2), Of([1.0, 2.0]).Around(1.5, 8));

    [Fact]
    public void LastAtOrBefore_MoreThanOnePiece_Finds()
    {
        SampleTimes times = Of([.. Enumerable.Range(0, 40_000).Select(i => 2.0 * i)]);

        Assert.Equal(20_000, times.LastAtOrBefore(40_001.0));
        Assert.Equal(-1, times.LastAtOrBefore(-0.5));
        Assert.Equal(39_999, times.LastAtOrBefore(1e9));
    }

    [Theory]
    [InlineData(2.0)]
    [InlineData(1.0)]
    [InlineData(double.NaN)]
    public void Add_NotLater_Throws(double time)
    {
        SampleTimes times = Of([2.0]);

        Assert.Throws<ArgumentOutOfRangeException>(() => times.Add(time));
    }

    private static SampleTimes Of(double[] values)
    {
        SampleTimes times = new();
        foreach (double value in values)
        {
            times.Add(value);
        }

        return times;
    }
}
