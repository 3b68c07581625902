using Msisf.Adapters.Render;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Render;

public class PngFileTests
{
    private static readonly byte[] End = PngBytes.End();

    [Fact]
    public void CopyImage_TimeAndTextChunks_AreLeftOut()
    {
        byte[] gamma = PngBytes.Chunk("gAMA", [0, 0, 0xB1, 0x8F]);
        byte[] stamped = PngBytes.File(
            PngBytes.Header(3, 2), gamma, PngBytes.Chunk("tIME", [7, 0xEA, 1, 2, 3, 4, 5]),
            PngBytes.Chunk("tEXt", "Comment\0Render Date"u8), PngBytes.Chunk("zTXt", [1]), PngBytes.Chunk("iTXt", [2]),
            PngBytes.Chunk("eXIf", [3]), Pixels(), End);

        byte[] copy = Copy(stamped);

        Assert.Equal(PngBytes.File(PngBytes.Header(3, 2), gamma, Pixels(), End), copy);
    }

    [Fact]
    public void CopyImage_ChunkLargerThanTheBuffer_ComesThroughWhole()
    {
        byte[] noise = new byte[200_001];
        new Random(1).NextBytes(noise);
        byte[] png = PngBytes.File(PngBytes.Header(3, 2), PngBytes.Chunk("IDAT", noise), End);

        Assert.Equal(png, Copy(png));
    }

    [Fact]
    public void Check_WholeImage_GivesItsHeader() =>
        Assert.Equal(
            new PngHeader(3, 2, 8, 2), PngFile.Check(new MemoryStream(PngBytes.File(PngBytes.Header(3, 2), Pixels(), End)), "a.png"));

    [Fact]
    public void Check_AnyCutFile_IsBadInput()
    {
        byte[] whole = PngBytes.File(PngBytes.Header(3, 2), Pixels(), End);
        for (int length = 0; length < whole.Length; length++)
        {
            BadInputException failure = Assert.Throws<BadInputException>(
                () => PngFile.Check(new MemoryStream(whole, 0, length), "cut.png"));
            Assert.StartsWith("cut.png: not a whole PNG image: it is cut off", failure.Message, StringComparison.Ordinal);
        }
    }

    [Fact]
    public void Check_AnyFlippedBit_IsBadInput()
    {
        byte[] whole = PngBytes.File(PngBytes.Header(3, 2), Pixels(), End);
        for (int i = 0; i < whole.Length; i++)
        {
            byte[] damaged = [.. whole];
            damaged[i] ^= 4;
            Assert.Throws<BadInputException>(() => PngFile.Check(new MemoryStream(damaged), "damaged.png"));
        }
    }

    [Fact]
    public void Check_ChunksInTheWrongPlace_IsBadInput()
    {
        Assert.Throws<BadInputException>(() => Copy(PngBytes.File(Pixels(), PngBytes.Header(3, 2), End)));
        Assert.Throws<BadInputException>(() => Copy(PngBytes.File(PngBytes.Header(3, 2), PngBytes.Header(3, 2), Pixels(), End)));
        Assert.Throws<BadInputException>(() => Copy(PngBytes.File(PngBytes.Header(3, 2), End)));
        Assert.Throws<BadInputException>(() => Copy(PngBytes.File(PngBytes.Header(0, 2), Pixels(), End)));
        Assert.Throws<BadInputException>(() => Copy(PngBytes.File(PngBytes.Header(3, 2), Pixels(), End, [0])));
    }

    [Fact]
    public void CopyImage_Copy_HasTheSamePixels()
    {
        PngPixels pixels = PngPixels.Read(
            new MemoryStream(Copy(PngBytes.File(PngBytes.Header(3, 2), PngBytes.Chunk("tIME", [7, 0xEA, 1, 2, 3, 4, 5]), Pixels(), End))));

        Assert.Equal((3, 2, 3, 8), (pixels.Width, pixels.Height, pixels.Channels, pixels.BitDepth));
        Assert.Equal([10, 20, 30], new[] { pixels[1, 0, 0], pixels[1, 0, 1], pixels[1, 0, 2] });
        Assert.Equal([11, 22, 33], new[] { pixels[1, 1, 0], pixels[1, 1, 1], pixels[1, 1, 2] });
        Assert.Equal(20.0 / 255.0, pixels.ChannelParts(1)[0, 1]);
    }

    private static byte[] Copy(byte[] png)
    {
        using MemoryStream copy = new();
        PngFile.CopyImage(new MemoryStream(png), copy, "a.png");
        return copy.ToArray();
    }

    /// <summary>3 x 2 px; the second row is stored as the difference from the first (filter 2).</summary>
    private static byte[] Pixels() => PngBytes.Data([0, 1, 2, 3, 10, 20, 30, 4, 5, 6, 2, 0, 0, 0, 1, 2, 3, 0, 0, 0]);
}
