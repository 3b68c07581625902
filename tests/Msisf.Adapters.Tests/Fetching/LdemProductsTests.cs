using Msisf.Adapters.Fetching;
using Xunit;

namespace Msisf.Adapters.Tests.Fetching;

/// <summary>The names of the files in NASA's archive.</summary>
public class LdemProductsTests
{
    [Theory]
    [InlineData(4, false, 1, "LDEM_4")]
    [InlineData(128, true, 1, "LDEM_128_FLOAT")]
    [InlineData(256, true, 4, "LDEM_256_90S_00S_180_360_FLOAT")]
    [InlineData(512, false, 16, "LDEM_512_45N_90N_000_090")]
    [InlineData(1024, false, 144, "LDEM_1024_15S_00S_000_030")] // as ldem_1024_15s_00s_000_030.img
    public void Of_Resolution_HasTheNamesOfTheArchive(int resolution, bool hasFloats, int count, string one)
    {
        string[] names = [.. LdemProducts.Of(resolution, hasFloats)];

        Assert.Equal(count, names.Distinct().Count());
        Assert.Contains(one, names);
    }
}
