using Msisf.App.Cluster;
using Msisf.Core.Scene;
using Xunit;

namespace Msisf.App.Tests.Cluster;

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
        Assert.All(pieces, piece => Assert.Equal(5000, piece.Steps.Count()));
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

    private static int[] Steps(int count) => [.. Enumerable.Range(1, count)];
}
