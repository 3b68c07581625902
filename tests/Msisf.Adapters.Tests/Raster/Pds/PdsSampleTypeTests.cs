using Msisf.Adapters.Raster.Pds;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Pds;

public class PdsSampleTypeTests
{
    // PDS Standards Reference 3.8, section 3.1 and appendix C: the types, and the names that stand for the same.
    [Theory]
    [InlineData("MSB_INTEGER", 16, PixelType.Signed16, true)]
    [InlineData("INTEGER", 16, PixelType.Signed16, true)]
    [InlineData("MAC_INTEGER", 16, PixelType.Signed16, true)]
    [InlineData("SUN_INTEGER", 32, PixelType.Signed32, true)]
    [InlineData("MSB_UNSIGNED_INTEGER", 16, PixelType.Unsigned16, true)]
    [InlineData("UNSIGNED_INTEGER", 16, PixelType.Unsigned16, true)]
    [InlineData("MAC_UNSIGNED_INTEGER", 16, PixelType.Unsigned16, true)]
    [InlineData("SUN_UNSIGNED_INTEGER", 16, PixelType.Unsigned16, true)]
    [InlineData("LSB_INTEGER", 16, PixelType.Signed16, false)]
    [InlineData("PC_INTEGER", 16, PixelType.Signed16, false)]
    [InlineData("VAX_INTEGER", 32, PixelType.Signed32, false)]
    [InlineData("LSB_UNSIGNED_INTEGER", 16, PixelType.Unsigned16, false)]
    [InlineData("PC_UNSIGNED_INTEGER", 16, PixelType.Unsigned16, false)]
    [InlineData("VAX_UNSIGNED_INTEGER", 16, PixelType.Unsigned16, false)]
    [InlineData("IEEE_REAL", 32, PixelType.Real32, true)]
    [InlineData("REAL", 32, PixelType.Real32, true)]
    [InlineData("FLOAT", 64, PixelType.Real64, true)]
    [InlineData("MAC_REAL", 32, PixelType.Real32, true)]
    [InlineData("SUN_REAL", 64, PixelType.Real64, true)]
    [InlineData("PC_REAL", 32, PixelType.Real32, false)]
    [InlineData("LSB_INTEGER", 8, PixelType.Unsigned8, false)]
    public void Of_EachName_GivesNumberAndByteOrder(string name, int bits, PixelType type, bool isBigEndian)
    {
        Assert.Equal(new PdsSampleType(type, isBigEndian), Of(name, bits));
        Assert.Equal(new PdsSampleType(type, isBigEndian), Of($"\"{name.Replace('_', ' ')}\"", bits));
        Assert.Equal(new PdsSampleType(type, isBigEndian), Of(name.ToLowerInvariant(), bits));
    }

    [Theory]
    [InlineData("VAX_REAL", 32)] // not IEEE 754
    [InlineData("VAXG_REAL", 64)]
    [InlineData("IEEE_COMPLEX", 64)]
    [InlineData("ASCII_REAL", 32)]
    [InlineData("MSB_BIT_STRING", 16)]
    [InlineData("PC_REAL", 16)]
    [InlineData("MSB_INTEGER", 64)]
    public void Of_OtherNumbers_AreNone(string name, int bits) => Assert.Null(Of(name, bits));

    // ISIS's NULL of reals and of words with sign, as LROC's labels write them.
    [Theory]
    [InlineData("PC_REAL", 32, "16#FF7FFFFB#", -3.4028226550889045e38)]
    [InlineData("PC_REAL", 32, "-1.5", -1.5)]
    [InlineData("LSB_INTEGER", 16, "16#8000#", -32768.0)]
    [InlineData("LSB_UNSIGNED_INTEGER", 16, "16#8000#", 32768.0)]
    [InlineData("LSB_UNSIGNED_INTEGER", 16, "2#101#", 5.0)]
    public void Constant_NumberOrBits_IsTheSampleOfThem(string name, int bits, string text, double expected) =>
        Assert.Equal(expected, Of(name, bits)!.Value.Constant(text));

    private static PdsSampleType? Of(string name, int bits) =>
        PdsSampleType.Of(PdsLabelParser.Parse($"PDS_VERSION_ID = PDS3\nSAMPLE_TYPE = {name}\nSAMPLE_BITS = {bits}\nEND", "x.LBL"));
}
