using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Xunit;

namespace Msisf.Core.Tests.Terrain;

public sealed class MoonRegionTests
{
    [Fact]
    public void Parse_FourBorders_IsTheRegion() =>
        Assert.Equal(new MoonRegion(-45, 0, 270, 360), MoonRegion.Parse("-45:0:270:360"));

    [Theory]
    [InlineData("")]
    [InlineData("0:45:0")]
    [InlineData("0:45:0:90:1")]
    [InlineData("45:0:0:90")]
    [InlineData("0:45:90:90")]
    [InlineData("-91:0:0:90")]
    [InlineData("0:91:0:90")]
    [InlineData("0:45:-10:10")]
    [InlineData("0:45:350:370")]
    [InlineData("0.5:45:0:90")]
    [InlineData("0:45:0:NaN")]
    public void Parse_NoRegion_SaysWhatIsNeeded(string text)
    {
        UsageException exception = Assert.Throws<UsageException>(() => MoonRegion.Parse(text));
        Assert.Contains(MoonRegion.ValidValues, exception.Message, StringComparison.Ordinal);
    }
}
