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
    [InlineData("0:45:350:10", 350, 370)]
    [InlineData("0:45:-10:10", 350, 370)]
    [InlineData("0:45:-20:-10", 340, 350)]
    [InlineData("0:45:270:0", 270, 360)]
    [InlineData("0:45:-180:180", 0, 360)]
    [InlineData("0:45:10:5", 10, 365)]
    public void Parse_BordersOverThePrimeMeridian_GoOnPast360(string text, int west, int east)
    {
        MoonRegion region = MoonRegion.Parse(text);

        Assert.Equal((west, east), (region.WestDegrees, region.EastDegrees));
        Assert.Equal(east > 360, region.CrossesPrimeMeridian);
    }

    [Theory]
    [InlineData("")]
    [InlineData("0:45:0")]
    [InlineData("0:45:0:90:1")]
    [InlineData("45:0:0:90")]
    [InlineData("0:45:90:90")]
    [InlineData("-91:0:0:90")]
    [InlineData("0:91:0:90")]
    [InlineData("0:45:-181:10")]
    [InlineData("0:45:350:370")]
    [InlineData("0.5:45:0:90")]
    [InlineData("0:45:0:NaN")]
    public void Parse_NoRegion_SaysWhatIsNeeded(string text)
    {
        UsageException exception = Assert.Throws<UsageException>(() => MoonRegion.Parse(text));
        Assert.Contains(MoonRegion.ValidValues, exception.Message, StringComparison.Ordinal);
    }
}
