using Msisf.App.Twins;
using Xunit;

namespace Msisf.App.Tests.Twins;

public sealed class TwinPictureTests
{
    [Fact]
    public void WhiteOf_ThousandAndOneNumbers_LeavesFiveAbove()
    {
        float[] pixels = [.. Enumerable.Range(0, 1001).Select(number => (float)(number * 5 % 1001)), float.NaN, float.NaN];

        Assert.Equal(995.0, TwinPicture.WhiteOf(pixels));
    }

    [Fact]
    public void WhiteOf_NoNumber_IsOne() => Assert.Equal(1.0, TwinPicture.WhiteOf([float.NaN]));
}
