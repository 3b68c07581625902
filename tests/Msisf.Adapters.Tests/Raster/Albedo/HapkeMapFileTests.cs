using System.Buffers.Binary;
using Msisf.Adapters.Raster.Albedo;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Albedo;

/// <summary>A file of the product's layout; the product itself is not at hand.</summary>
public sealed class HapkeMapFileTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Read_EitherByteOrder_IsRead(bool isLittleEndian)
    {
        HapkeMapFile file = HapkeMapFile.Read(_folder.Write("map.img", Bytes(isLittleEndian)));

        Assert.Equal(5760 + (360 * 140 * 9 * 4), file.FileBytes);
        Assert.Equal(64, file.Sha256.Length);
    }

    [Fact]
    public void Read_ImpossibleValue_SaysWhere()
    {
        byte[] bytes = Bytes(isLittleEndian: true);
        BinaryPrimitives.WriteSingleLittleEndian(bytes.AsSpan(5760 + (4 * ((5 * 360 * 140) + (2 * 360) + 7))), -3f);

        BadInputException failure = Assert.Throws<BadInputException>(() => HapkeMapFile.Read(_folder.Write("map.img", bytes)));

        Assert.Contains("map 6 (Bs0), line 3, sample 8: -3; 0 to 10 is possible", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_ShortFile_SaysHowLongItMustBe() => Assert.Contains(
        "1000 bytes, at least 1820160 expected",
        Assert.Throws<BadInputException>(() => HapkeMapFile.Read(_folder.Write("map.img", new byte[1000]))).Message,
        StringComparison.Ordinal);

    private static byte[] Bytes(bool isLittleEndian)
    {
        float[] values = [0.3854f, 0.2375f, 0.3253f, 0f, 1f, 1.686f, 0.0672f, 23.6566f, 0f];
        byte[] bytes = new byte[5760 + (360 * 140 * 9 * 4)];
        for (int i = 0; i < 360 * 140 * 9; i++)
        {
            float value = values[i / (360 * 140)];
            Span<byte> place = bytes.AsSpan(5760 + (4 * i));
            if (isLittleEndian)
            {
                BinaryPrimitives.WriteSingleLittleEndian(place, value);
            }
            else
            {
                BinaryPrimitives.WriteSingleBigEndian(place, value);
            }
        }

        return bytes;
    }
}
