using System.IO.Compression;
using Msisf.Adapters.Render;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Render;

public sealed class PngRasterTests
{
    private const int Width = 5;
    private const int Height = 20; // each filter four times

    /// <summary>Samples without order, filtered by the standard's five filters in turn.</summary>
    [Theory]
    [InlineData(0, 8, 1)]
    [InlineData(0, 16, 2)]
    [InlineData(2, 8, 3)]
    [InlineData(6, 16, 8)]
    public void Read_AnyFilter_GivesTheSamples(byte colorType, byte bitDepth, int bytesAPixel)
    {
        byte[] rows = RandomRows(bytesAPixel);
        using MemoryStream file = Png(rows, colorType, bitDepth, bytesAPixel, interlace: 0);

        using MemoryStream written = new();
        PngRaster.Read(file, "test").Write(written);

        AssertSamples(rows, written, bytesAPixel, bitDepth);
    }

    [Fact]
    public void Write_SamePixelsFilteredOtherwise_IsTheSameBytes()
    {
        byte[] rows = RandomRows(3);
        using MemoryStream one = new();
        using MemoryStream other = new();
        PngRaster.Read(Png(rows, 2, 8, 3, interlace: 0), "one").Write(one);
        PngRaster.Read(Png(rows, 2, 8, 3, interlace: 0, firstFilter: 3), "other").Write(other);

        Assert.Equal(one.ToArray(), other.ToArray());
    }

    [Fact]
    public void Join_Strips_TakesTheRowsOfEach()
    {
        byte[] rows = RandomRows(3);
        byte[] upper = [.. rows];
        byte[] lower = [.. rows];
        upper.AsSpan(12 * Width * 3).Clear();
        lower.AsSpan(0, 12 * Width * 3).Clear();
        PngRaster[] strips = [PngRaster.Read(
            Png(upper, 2, 8, 3, interlace: 0), "upper"), PngRaster.Read(Png(lower, 2, 8, 3, interlace: 0), "lower")];

        using MemoryStream written = new();
        PngRaster.Join(strips, [0, 12]).Write(written);

        AssertSamples(rows, written, 3, 8);
    }

    [Fact]
    public void Read_Interlaced_IsRefused()
    {
        using MemoryStream file = Png(RandomRows(3), 2, 8, 3, interlace: 1);

        Assert.Contains(
            "interlaced", Assert.Throws<BadInputException>(() => PngRaster.Read(file, "test")).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_TooFewPixels_IsRefused()
    {
        using MemoryStream file = Png(RandomRows(3)[..(7 * Width * 3)], 2, 8, 3, interlace: 0, height: Height);

        Assert.Contains(
            "can't be unpacked", Assert.Throws<BadInputException>(() => PngRaster.Read(file, "test")).Message, StringComparison.Ordinal);
    }

    private static byte[] RandomRows(int bytesAPixel)
    {
        byte[] rows = new byte[Width * Height * bytesAPixel];
        new Random(20120222).NextBytes(rows);
        return rows;
    }

    private static void AssertSamples(byte[] rows, MemoryStream written, int bytesAPixel, int bitDepth)
    {
        written.Position = 0;
        PngPixels pixels = PngPixels.Read(written);
        int bytes = bitDepth / 8;
        for (int i = 0; i < rows.Length; i += bytes)
        {
            int sample = bytes == 1 ? rows[i] : (rows[i] << 8) | rows[i + 1];
            int pixel = i / bytesAPixel;
            Assert.Equal(sample, pixels[pixel % Width, pixel / Width, i % bytesAPixel / bytes]);
        }
    }

    private static MemoryStream Png(
        byte[] rows, byte colorType, byte bitDepth, int bytesAPixel, byte interlace, int firstFilter = 0, int? height = null)
    {
        int length = Width * bytesAPixel;
        using MemoryStream compressed = new();
        using (ZLibStream compressor = new(compressed, CompressionLevel.Fastest, leaveOpen: true))
        {
            for (int row = 0; row < rows.Length / length; row++)
            {
                byte[] above = row == 0 ? new byte[length] : rows[((row - 1) * length)..(row * length)];
                compressor.Write(Filtered((row + firstFilter) % 5, rows[(row * length)..((row + 1) * length)], above, bytesAPixel));
            }
        }

        MemoryStream file = new();
        file.Write([0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A]);
        file.Write(
            PngBytes.Chunk(
                "IHDR", [0, 0, 0, Width, 0, 0, 0, (byte)(height ?? rows.Length / length), bitDepth, colorType, 0, 0, interlace]));
        file.Write(PngBytes.Chunk("IDAT", compressed.ToArray()));
        file.Write(PngBytes.Chunk("IEND", []));
        file.Position = 0;
        return file;
    }

    private static byte[] Filtered(int filter, byte[] row, byte[] above, int pixel)
    {
        byte[] line = new byte[row.Length + 1];
        line[0] = (byte)filter;
        for (int i = 0; i < row.Length; i++)
        {
            int a = i >= pixel ? row[i - pixel] : 0;
            int b = above[i];
            int c = i >= pixel ? above[i - pixel] : 0;
            int nearest = new[] { a, b, c }.MinBy(candidate => Math.Abs(a + b - c - candidate));
            int guess = filter switch { 1 => a, 2 => b, 3 => (a + b) >> 1, 4 => nearest, _ => 0 };
            line[i + 1] = (byte)(row[i] - guess);
        }

        return line;
    }
}
