using Msisf.Adapters.CameraExport;
using Xunit;

namespace Msisf.Adapters.Tests.CameraExport;

public class ExportedImageTests
{
    /// <summary>The special pixel NULL of ISIS, SpecialPixel.h: 0xFF7FFFFB.</summary>
    [Fact]
    public void WritePixels_NoNumber_IsTheSpecialPixel()
    {
        ExportedImage image = new(2, 2, IsDigital: false, (row, numbers) =>
        {
            numbers[0] = row;
            numbers[1] = row == 0 ? float.NaN : 0.5f;
        });
        using MemoryStream stream = new();

        image.WritePixels(stream, BitConverter.UInt32BitsToSingle(0xFF7FFFFB));

        Assert.Equal(
            [0, 0, 0, 0, 0xFB, 0xFF, 0x7F, 0xFF, 0, 0, 0x80, 0x3F, 0, 0, 0, 0x3F], stream.ToArray());
    }
}
