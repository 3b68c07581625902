using System.Text;
using Msisf.Adapters.Metadata;
using Msisf.Core.Metadata;
using Msisf.Core.Terrain;
using Xunit;

namespace Msisf.Adapters.Tests.Metadata;

public class PixelXmlTests
{
    [Fact]
    public void Write_LongestRecord_FillsTheMaximumLength()
    {
        PixelRecord record = new(int.MaxValue, int.MaxValue, new SelenographicPoint(-1.0, 6.0), 6.0);
        byte[] bytes = new byte[PixelXml.MaximumLength];

        Assert.Equal(PixelXml.MaximumLength, PixelXml.Write(record, bytes));
        Assert.EndsWith("</IlluminationDirection>\n    </Pixel>\n", Encoding.UTF8.GetString(bytes), StringComparison.Ordinal);
    }

    [Fact]
    public void Write_LastAngleBelowAFullTurn_IsNot360Degrees()
    {
        double almostFullTurn = Math.BitDecrement(2.0 * Math.PI);
        byte[] bytes = new byte[PixelXml.MaximumLength];

        int length = PixelXml.Write(new PixelRecord(1, 1, new SelenographicPoint(0.0, almostFullTurn), almostFullTurn), bytes);

        Assert.DoesNotContain("3.600000000000000E+002", Encoding.UTF8.GetString(bytes, 0, length), StringComparison.Ordinal);
    }
}
