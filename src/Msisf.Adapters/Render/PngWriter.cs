using System.Buffers.Binary;
using System.IO.Compression;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Render;

/// <summary>
/// Writes grey images as PNG (ISO/IEC 15948) at the rate of a video: the same levels give the same bytes, without time stamp or text.
/// </summary>
/// <remarks>
/// Filter and compression were chosen by measurement (docs/photometry.md): the difference from the row above, runs only. On rendered Moons
/// this is the smallest file of all that take less than 5 ms for 1024 x 1024 levels of 8 bits.
/// </remarks>
public static class PngWriter
{
    private const byte GreyColorType = 0;
    private const byte TrueColorType = 2;

    /// <summary>Writes an image of 8 bits.</summary>
    /// <param name="destination">The file; stays open.</param>
    /// <param name="levels">By rows from the top, each from left to right.</param>
    /// <param name="width">px; the number of levels is a multiple of it.</param>
    /// <param name="transfer">What the levels mean, for the file's gamma.</param>
    public static void Write(Stream destination, ReadOnlySpan<byte> levels, int width, GreyTransfer transfer)
    {
        using PngImage image = new(destination, width, levels.Length / width, bitDepth: 8, transfer);
        image.Add(levels);
    }

    /// <summary>Writes an image of 16 bits; parameters as with 8.</summary>
    public static void Write(Stream destination, ReadOnlySpan<ushort> levels, int width, GreyTransfer transfer)
    {
        using PngImage image = new(destination, width, levels.Length / width, bitDepth: 16, transfer);
        image.Add(levels);
    }

    /// <summary>
    /// Writes the numbers of a detector with 16 bits: scaled to the whole range, as the standard asks (section 12.4), with their own number
    /// of bits in sBIT. The upper bits of a sample are the number: sample >> (16 - bits).
    /// </summary>
    /// <param name="destination">The file; stays open.</param>
    /// <param name="numbers">By rows from the top, each from left to right.</param>
    /// <param name="width">px; the number of numbers is a multiple of it.</param>
    /// <param name="bits">Bits of a number, 1 to 16.</param>
    public static void WriteNumbers(Stream destination, ReadOnlySpan<ushort> numbers, int width, int bits)
    {
        using PngImage image = PngImage.OfNumbers(destination, width, numbers.Length / width, bits);
        image.Add(numbers);
    }

    /// <summary>Writes colours of three numbers of 16 bits, which mean what the reader takes them for.</summary>
    /// <param name="destination">The file; stays open.</param>
    /// <param name="colors">Three numbers a pixel, by rows from the top, each from left to right.</param>
    /// <param name="width">px.</param>
    public static void WriteColors(Stream destination, ReadOnlySpan<ushort> colors, int width)
    {
        const int channels = 3;
        destination.Write(PngFile.Signature);
        WriteHeader(destination, width, colors.Length / channels / width, bitDepth: 16, TrueColorType);
        byte[] bytes = new byte[sizeof(ushort) * colors.Length];
        for (int i = 0; i < colors.Length; i++)
        {
            BinaryPrimitives.WriteUInt16BigEndian(bytes.AsSpan(sizeof(ushort) * i), colors[i]);
        }

        WriteRows(destination, bytes, sizeof(ushort) * channels * width, RunsOnly());
        PngChunk.Write(destination, "IEND"u8, []);
    }

    internal static ZLibCompressionOptions RunsOnly() =>
        new() { CompressionLevel = 1, CompressionStrategy = ZLibCompressionStrategy.RunLengthEncoding };

    internal static void WriteHead(Stream destination, int width, int height, byte bitDepth, GreyTransfer transfer)
    {
        destination.Write(PngFile.Signature);
        WriteHeader(destination, width, height, bitDepth, GreyColorType);

        // Hundred-thousandths of the exponent from level to light's inverse; beside sRGB the standard wants 1 / 2.2 for old readers.
        Span<byte> gamma = stackalloc byte[4];
        BinaryPrimitives.WriteInt32BigEndian(gamma, transfer == GreyTransfer.Srgb ? 45455 : 100000);
        PngChunk.Write(destination, "gAMA"u8, gamma);
        if (transfer == GreyTransfer.Srgb)
        {
            ReadOnlySpan<byte> perceptualIntent = [0];
            PngChunk.Write(destination, "sRGB"u8, perceptualIntent);
        }
    }

    private static void WriteHeader(Stream destination, int width, int height, byte bitDepth, byte colorType)
    {
        Span<byte> header = stackalloc byte[13];
        header.Clear();
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header[4..], height);
        header[8] = bitDepth;
        header[9] = colorType;
        PngChunk.Write(destination, "IHDR"u8, header);
    }

    /// <summary>Writes the pixels as the difference from the row above.</summary>
    internal static void WriteRows(Stream destination, ReadOnlySpan<byte> rows, int rowLength, ZLibCompressionOptions compression)
    {
        using PngRows image = new(destination, rowLength, compression);
        image.Add(rows);
    }
}
