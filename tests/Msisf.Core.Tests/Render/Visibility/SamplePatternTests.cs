using Msisf.Core.Render.Visibility;
using Xunit;

namespace Msisf.Core.Tests.Render.Visibility;

/// <summary>The order of a pixel's samples.</summary>
public sealed class SamplePatternTests
{
    [Fact]
    public void Samples_AllTogether_AreTheGridOfSixtyFour()
    {
        IEnumerable<(double, double)> grid =
            from row in Enumerable.Range(0, 8)
            from column in Enumerable.Range(0, 8)
            select (-0.4375 + (0.125 * column), -0.4375 + (0.125 * row));

        Assert.Equal(grid.Order(), SamplePattern.Right.Zip(SamplePattern.Down).Order());
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(4)]
    [InlineData(8)]
    public void Samples_OfTheFirstVectors_AreAsManyInEachRowAndColumn(int vectors)
    {
        IEnumerable<double> right = SamplePattern.Right.Take(8 * vectors);
        IEnumerable<double> down = SamplePattern.Down.Take(8 * vectors);

        Assert.All(right.GroupBy(x => x), column => Assert.Equal(vectors, column.Count()));
        Assert.All(down.GroupBy(y => y), row => Assert.Equal(vectors, row.Count()));
        Assert.Equal(8, right.Distinct().Count());
        Assert.Equal(8, down.Distinct().Count());
    }
}
