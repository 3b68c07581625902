using Msisf.Core.Errors;
using Msisf.Core.Scene;
using Xunit;

namespace Msisf.Core.Tests.Scene;

public sealed class StepRangesTests
{
    [Theory]
    [InlineData("17", "17", 1)]
    [InlineData("1001:2000", "1001:2000", 1000)]
    [InlineData("17, 3:5", "3:5,17", 4)]
    [InlineData("4:6,1:3,5,7", "1:7", 7)]
    [InlineData("1:2147483647,5", "1:2147483647", 2147483647L)]
    public void Parse_Steps_AreSortedAndJoined(string text, string expected, long count)
    {
        StepRanges ranges = StepRanges.Parse(text);
        Assert.Equal(expected, ranges.ToString());
        Assert.Equal(count, ranges.Count);
    }

    [Theory]
    [InlineData("")]
    [InlineData("0")]
    [InlineData("1:2:3")]
    [InlineData("1,,2")]
    [InlineData("-1:2")]
    [InlineData("a")]
    [InlineData("2147483648")]
    [InlineData("5:3")]
    public void Parse_NoSteps_AreRefused(string text) => Assert.Throws<BadInputException>(() => StepRanges.Parse(text));

    [Fact]
    public void Of_StepsInAnyOrder_ReadsBack()
    {
        StepRanges ranges = StepRanges.Of([9, 2, 3, 3, 1, 11]);
        Assert.Equal("1:3,9,11", ranges.ToString());
        Assert.Equal([1, 2, 3, 9, 11], ranges.Steps);
        Assert.Equal(11, ranges.Last);
        Assert.True(ranges.Contains(9));
        Assert.False(ranges.Contains(10));
        Assert.Empty(StepRanges.Of([]).ToString());
    }
}
