using System.Text;
using Msisf.Adapters.Render;
using Xunit;

namespace Msisf.Adapters.Tests.Render;

public class PngCrcTests
{
    // The check value that catalogues of such checks give for this polynomial.
    [Fact]
    public void Update_DigitsInAnyTwoParts_IsTheCataloguedValue()
    {
        byte[] digits = Encoding.ASCII.GetBytes("123456789");
        for (int cut = 0; cut <= digits.Length; cut++)
        {
            uint state = PngCrc.Update(PngCrc.Update(PngCrc.Start, digits.AsSpan(0, cut)), digits.AsSpan(cut));
            Assert.Equal(0xCBF43926, PngCrc.Finish(state));
        }
    }

    // python3 -c "import zlib; print(hex(zlib.crc32(bytes(i * i * 7 % 256 for i in range(1000)))))"
    [Fact]
    public void Update_ThousandBytes_IsThatOfZlib()
    {
        byte[] bytes = [.. Enumerable.Range(0, 1000).Select(i => (byte)(i * i * 7))];

        Assert.Equal(0xF4648A2B, PngCrc.Finish(PngCrc.Update(PngCrc.Start, bytes)));
    }
}
