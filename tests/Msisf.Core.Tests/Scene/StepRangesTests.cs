using Msisf.Core.Errors;
using Msisf.Core.Scene;
using Xunit;

namespace Msisf.Core.Tests.Scene;

public sealed class StepRangesTests
{
    [Theory]
    [InlineData("17", "17")]
    [InlineData("1001:2000", "1001:2000")]
    [InlineData("17, 3:5", "3:5,17")]
    [InlineData("4:6,1:3,5,7", "1:7")]
    [InlineData("1:2147483647,5", "1:2147483647")]
    public void Parse_Steps_AreSortedAndJoined(string text, string expected) =>
        Assert.Equal(expected, StepRanges.Parse(text).ToString());

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
        Assert.Empty(StepRanges.Of([]).ToString());
    }
}
