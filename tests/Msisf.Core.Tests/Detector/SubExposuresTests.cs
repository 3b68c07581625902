using Msisf.Core.Detector;
using Xunit;

namespace Msisf.Core.Tests.Detector;

public sealed class SubExposuresTests
{
    [Theory]
    [InlineData(1, 0.0)]
    [InlineData(7, 0.0)]
    [InlineData(7, 0.003)]
    [InlineData(101, 0.05)]
    public void WeightOf_EachRow_SumsToOne(int count, double lineTime)
    {
        SubExposures exposures = new(count, 0.01, lineTime, height: 20);
        for (int row = 0; row < exposures.Height; row++)
        {
            Assert.Equal(1.0, Enumerable.Range(0, count).Sum(index => exposures.WeightOf(index, row)), 1e-12);
        }

        Assert.Equal(0.0, exposures.TimeOf(exposures.Middle));
    }

    /// <summary>5 rows, 2 s a row, 1 s from row to row: row 0 is open from -3 to -1 s, row 4 from 1 to 3 s; parts of 2 s.</summary>
    [Fact]
    public void WeightOf_RollingShutter_FollowsTheRows()
    {
        SubExposures exposures = new(3, 2.0, 1.0, height: 5);
        Assert.Equal([-2.0, 0.0, 2.0], Enumerable.Range(0, 3).Select(exposures.TimeOf));
        Assert.Equal([1.0, 0.0, 0.0], Enumerable.Range(0, 3).Select(index => exposures.WeightOf(index, 0)));
        Assert.Equal([0.5, 0.5, 0.0], Enumerable.Range(0, 3).Select(index => exposures.WeightOf(index, 1)));
        Assert.Equal([0.0, 1.0, 0.0], Enumerable.Range(0, 3).Select(index => exposures.WeightOf(index, 2)));
        Assert.Equal([0.0, 0.0, 1.0], Enumerable.Range(0, 3).Select(index => exposures.WeightOf(index, 4)));
    }
}
