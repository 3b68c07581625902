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

        Assert.Equal(grid.Order(), SamplePattern.Stratified.Right.Zip(SamplePattern.Stratified.Down).Order());
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(4)]
    [InlineData(8)]
    public void Samples_OfTheFirstVectors_AreAsManyInEachRowAndColumn(int vectors)
    {
        IEnumerable<double> right = SamplePattern.Stratified.Right.Take(8 * vectors);
        IEnumerable<double> down = SamplePattern.Stratified.Down.Take(8 * vectors);

        Assert.All(right.GroupBy(x => x), column => Assert.Equal(vectors, column.Count()));
        Assert.All(down.GroupBy(y => y), row => Assert.Equal(vectors, row.Count()));
        Assert.Equal(8, right.Distinct().Count());
        Assert.Equal(8, down.Distinct().Count());
    }

    [Theory]
    [InlineData(1, 1, 8)]
    [InlineData(3, 9, 16)]
    [InlineData(16, 256, 256)]
    public void Grid_AnyNumber_HasTheMiddlesOfItsSquaresInFullVectors(int perAxis, int count, int places)
    {
        SamplePattern grid = SamplePattern.Grid(perAxis);

        Assert.Equal(
            from row in Enumerable.Range(0, perAxis)
            from column in Enumerable.Range(0, perAxis)
            select (((2 * column) + 1.0 - perAxis) / (2 * perAxis), ((2 * row) + 1.0 - perAxis) / (2 * perAxis)),
            grid.Right.Zip(grid.Down).Take(count).Select(sample => (Math.Round(sample.First, 12), Math.Round(sample.Second, 12))),
            (a, b) => Math.Abs(a.Item1 - b.Item1) < 1e-11 && Math.Abs(a.Item2 - b.Item2) < 1e-11);
        Assert.Equal((count, places, places), (grid.Count, grid.Right.Length, 8 * grid.Vectors));
        Assert.Equal((Math.Min(8, count), count), (grid.SamplesIn(1), grid.SamplesIn(grid.Vectors)));
        Assert.Equal(0.5 - (0.5 / perAxis), grid.Reach, 15);
    }
}
