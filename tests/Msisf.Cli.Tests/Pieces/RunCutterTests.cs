using Msisf.Cli.Pieces;
using Msisf.Core.Scene;
using Xunit;

namespace Msisf.Cli.Tests.Pieces;

public sealed class RunCutterTests
{
    [Theory]
    [InlineData(10, 1, "1:10")]
    [InlineData(10, 3, "1:3 4:6 7:10")]
    [InlineData(10, 10, "1 2 3 4 5 6 7 8 9 10")]
    [InlineData(3, 8, "1 2 3")]
    [InlineData(1, 1, "1")]
    public void ByCount_Pieces_DifferByOneFrameAtMost(int steps, int pieces, string expected) =>
        Assert.Equal(expected, string.Join(' ', RunCutter.ByCount(Steps(steps), pieces)));

    [Fact]
    public void ByCount_MillionsOfFrames_DoesNotOverflow()
    {
        IReadOnlyList<StepRanges> pieces = RunCutter.ByCount(Steps(5_000_000), 1000);

        Assert.Equal("4995001:5000000", pieces[^1].ToString());
        Assert.All(pieces, piece => Assert.Equal(5000, piece.Count));
    }

    [Theory]
    [InlineData(10, 4, "1:4 5:8 9:10")]
    [InlineData(10, 100, "1:10")]
    [InlineData(4, 1, "1 2 3 4")]
    public void BySize_LastPiece_MayBeSmaller(int steps, int size, string expected) =>
        Assert.Equal(expected, string.Join(' ', RunCutter.BySize(Steps(steps), size)));

    [Fact]
    public void ByCount_StepsWithGaps_KeepsTheirNumbers() =>
        Assert.Equal("3:5 7,20:21", string.Join(' ', RunCutter.ByCount([3, 4, 5, 7, 20, 21], 2)));

    [Theory]
    [InlineData("1 1 1 1", 2, "1:2 3:4")]
    [InlineData("9 1 1 1", 2, "1 2:4")]
    [InlineData("1 1 1 9", 2, "1:3 4")]
    [InlineData("1 9 1", 3, "1 2 3")]
    [InlineData("9 1 1", 3, "1 2 3")]
    [InlineData("5 5", 9, "1 2")]
    [InlineData("0.1 0.2 0.3 0.6", 2, "1:3 4")]
    public void ByCost_KnownCosts_CutsBetweenThem(string costs, int pieces, string expected)
    {
        double[] numbers = [.. costs.Split(' ').Select(text => double.Parse(text, System.Globalization.CultureInfo.InvariantCulture))];

        Assert.Equal(expected, string.Join(' ', RunCutter.ByCost(Steps(numbers.Length), numbers, pieces)));
    }

    /// <summary>Against the best of all ways to cut, found by trying each (dynamic programming over the last cut).</summary>
    [Fact]
    public void ByCost_RandomCosts_HasTheSmallestGreatestPiece()
    {
        Random random = new(20121);
        for (int round = 0; round < 300; round++)
        {
            int count = random.Next(1, 25);
            double[] costs = [.. Enumerable.Range(0, count).Select(_ => random.Next(4) == 0 ? 50.0 * random.NextDouble() : 0.1 + random.NextDouble())];
            int pieces = random.Next(1, count + 3);

            IReadOnlyList<StepRanges> cut = RunCutter.ByCost(Steps(count), costs, pieces);

            Assert.Equal(Steps(count), cut.SelectMany(piece => piece.Steps));
            Assert.Equal(Math.Min(pieces, count), cut.Count);
            double max = cut.Max(piece => piece.Steps.Sum(step => costs[step - 1]));
            double best = SmallestGreatest(costs, Math.Min(pieces, count));
            Assert.True(max <= best * (1.0 + 1e-12), $"round {round}: {max} in place of {best}");
        }
    }

    [Fact]
    public void ByCost_AMillionFrames_IsQuickEnoughToTest()
    {
        double[] costs = [.. Enumerable.Range(0, 1_000_000).Select(index => 1.0 + Math.Sin(index * 1e-4))];

        IReadOnlyList<StepRanges> cut = RunCutter.ByCost(Steps(costs.Length), costs, 1000);

        double mean = costs.Sum() / 1000;
        Assert.All(cut, piece => Assert.InRange(piece.Steps.Sum(step => costs[step - 1]), 0.0, mean + 2.0));
    }

    private static int[] Steps(int count) => [.. Enumerable.Range(1, count)];

    private static double SmallestGreatest(double[] costs, int pieces)
    {
        double[] best = [0.0, .. costs.Select((_, index) => costs.Take(index + 1).Sum())];
        for (int piece = 2; piece <= pieces; piece++)
        {
            double[] before = best;
            best = [0.0, .. Enumerable.Range(1, costs.Length).Select(end => Enumerable.Range(0, end).Min(cut =>
                Math.Max(before[cut], costs[cut..end].Sum())))];
        }

        return best[^1];
    }
}
