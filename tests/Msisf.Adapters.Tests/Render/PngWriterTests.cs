using System.Buffers.Binary;
using System.Text;
using Msisf.Adapters.Render;
using Msisf.Core.Render.Photometry;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Render;

public class PngWriterTests
{
    [Theory]
    [InlineData(1, 1)]
    [InlineData(3, 2)]
    [InlineData(1, 300)]
    [InlineData(64, 33)]
    [InlineData(257, 300)]
    [InlineData(16384, 5)]
    [InlineData(40001, 2)]
    public void Write_AnySize_ReadsBackToTheSameLevels(int width, int height)
    {
        byte[] bytes = new byte[width * height];
        new Random(width).NextBytes(bytes);
        ushort[] words = [.. bytes.Select((level, i) => (ushort)((level << 8) | (i & 0xFF)))];

        byte[] png8 = Write(stream => PngWriter.Write(stream, bytes, width, GreyTransfer.Srgb));
        byte[] png16 = Write(stream => PngWriter.Write(stream, words, width, GreyTransfer.Srgb));

        Assert.Equal(new PngHeader(width, height, 8, 0), PngFile.Check(new MemoryStream(png8), "8.png"));
        Assert.Equal(new PngHeader(width, height, 16, 0), PngFile.Check(new MemoryStream(png16), "16.png"));
        Assert.Equal(bytes.Select(level => (int)level), Levels(png8));
        Assert.Equal(words.Select(level => (int)level), Levels(png16));
    }

    [Fact]
    public void Write_Srgb_HasTheStandardsTwoGammaChunksAndNothingElse()
    {
        byte[] png = Write(stream => PngWriter.Write(stream, new byte[] { 1, 2, 3 }, 3, GreyTransfer.Srgb));

        Assert.Equal(["IHDR", "gAMA", "sRGB", "IDAT", "IEND"], Chunks(png).Select(chunk => chunk.Type));
        Assert.Equal([0, 0, 0xB1, 0x8F], Chunks(png)[1].Data);
        Assert.Equal([0], Chunks(png)[2].Data);
    }

    [Fact]
    public void Write_Linear_HasGammaOne()
    {
        byte[] png = Write(stream => PngWriter.Write(stream, new ushort[] { 1, 2, 3 }, 3, GreyTransfer.Linear));

        Assert.Equal(["IHDR", "gAMA", "IDAT", "IEND"], Chunks(png).Select(chunk => chunk.Type));
        Assert.Equal([0, 1, 0x86, 0xA0], Chunks(png)[1].Data);
    }

    /// <summary>ISO/IEC 15948, 12.4: the original sample is the scaled one, shifted right by 16 less the number in sBIT.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    [InlineData(8)]
    [InlineData(10)]
    [InlineData(12)]
    [InlineData(14)]
    [InlineData(16)]
    public void WriteNumbers_AllNumbersOfADepth_AreTheUpperBitsOfTheSamples(int bits)
    {
        ushort[] numbers = [.. Enumerable.Range(0, 1 << bits).Select(number => (ushort)number)];
        byte[] png = Write(stream => PngWriter.WriteNumbers(stream, numbers, numbers.Length / 2, bits));

        Assert.Equal(["IHDR", "gAMA", "sBIT"], Chunks(png).Select(chunk => chunk.Type).Take(3));
        Assert.Equal([(byte)bits], Chunks(png)[2].Data);
        Assert.Equal(numbers.Select(number => (int)number), Levels(png).Select(level => level >> (16 - bits)));
        Assert.Equal(ushort.MaxValue, Levels(png).Last());
    }

    [Fact]
    public void Write_MoreThanAChunkOfData_FillsAllChunksButTheLast()
    {
        byte[] noise = new byte[200_000];
        new Random(1).NextBytes(noise);

        byte[] png = Write(stream => PngWriter.Write(stream, noise, 1000, GreyTransfer.Srgb));

        int[] lengths = [.. Chunks(png).Where(chunk => chunk.Type == "IDAT").Select(chunk => chunk.Data.Length)];
        Assert.Equal([65536, 65536, 65536], lengths[..^1]);
        Assert.InRange(lengths[^1], 1, 65536);
    }

    [Fact]
    public void Write_Twice_GivesTheSameBytesAndLeavesTheStreamOpen()
    {
        byte[] levels = [.. Enumerable.Range(0, 100_000).Select(i => (byte)(i / 391))];
        using MemoryStream stream = new();
        PngWriter.Write(stream, levels, 100, GreyTransfer.Srgb);
        long length = stream.Position;
        PngWriter.Write(stream, levels, 100, GreyTransfer.Srgb);

        Assert.Equal(stream.ToArray()[..(int)length], stream.ToArray()[(int)length..]);
    }

    [Fact]
    public void Write_EvenGrey_IsSmall() =>
        Assert.InRange(Write(stream => PngWriter.Write(stream, new byte[1 << 20], 1024, GreyTransfer.Srgb)).Length, 1, 10_000);

    private static byte[] Write(Action<Stream> write)
    {
        using MemoryStream stream = new();
        write(stream);
        return stream.ToArray();
    }

    private static IEnumerable<int> Levels(byte[] png)
    {
        PngPixels pixels = PngPixels.Read(new MemoryStream(png));
        return Enumerable.Range(0, pixels.Width * pixels.Height).Select(i => pixels[i % pixels.Width, i / pixels.Width, 0]);
    }

    private static List<(string Type, byte[] Data)> Chunks(byte[] png)
    {
        List<(string, byte[])> chunks = [];
        for (int at = 8; at < png.Length;)
        {
            int length = BinaryPrimitives.ReadInt32BigEndian(png.AsSpan(at));
            chunks.Add((Encoding.ASCII.GetString(png, at + 4, 4), png[(at + 8)..(at + 8 + length)]));
            at += 12 + length;
        }

        return chunks;
    }
}
