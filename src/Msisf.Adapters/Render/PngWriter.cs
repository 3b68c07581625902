using System.Buffers;
using System.Buffers.Binary;
using System.IO.Compression;
using System.Numerics;
using System.Runtime.InteropServices;
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
    private const byte UpFilter = 2;

    /// <summary>Bytes that go to the compressor at once, about: as much as its window.</summary>
    private const int BatchLength = 32768;

    private static ReadOnlySpan<byte> Signature => [0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A];

    /// <summary>Writes an image of 8 bits.</summary>
    /// <param name="destination">The file; stays open.</param>
    /// <param name="levels">By rows from the top, each from left to right.</param>
    /// <param name="width">px; the number of levels is a multiple of it.</param>
    /// <param name="transfer">What the levels mean, for the file's gamma.</param>
    public static void Write(Stream destination, ReadOnlySpan<byte> levels, int width, GreyTransfer transfer)
    {
        WriteHead(destination, width, levels.Length / width, bitDepth: 8, transfer);
        WriteRows(destination, levels, width, RunsOnly());
        PngChunk.Write(destination, "IEND"u8, []);
    }

    /// <summary>Writes an image of 16 bits; parameters as with 8.</summary>
    public static void Write(Stream destination, ReadOnlySpan<ushort> levels, int width, GreyTransfer transfer) =>
        Write(destination, levels, width, transfer, significantBits: null);

    private static void Write(Stream destination, ReadOnlySpan<ushort> levels, int width, GreyTransfer transfer, byte? significantBits)
    {
        WriteHead(destination, width, levels.Length / width, bitDepth: 16, transfer);
        if (significantBits is byte bits)
        {
            PngChunk.Write(destination, "sBIT"u8, [bits]);
        }

        ushort[] networkOrder = ArrayPool<ushort>.Shared.Rent(levels.Length);
        if (BitConverter.IsLittleEndian)
        {
            BinaryPrimitives.ReverseEndianness(levels, networkOrder);
        }
        else
        {
            levels.CopyTo(networkOrder);
        }

        WriteRows(destination, MemoryMarshal.AsBytes(networkOrder.AsSpan(0, levels.Length)), 2 * width, RunsOnly());
        ArrayPool<ushort>.Shared.Return(networkOrder);
        PngChunk.Write(destination, "IEND"u8, []);
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
        ushort[] samples = ArrayPool<ushort>.Shared.Rent(numbers.Length);
        uint max = (1u << bits) - 1;
        for (int i = 0; i < numbers.Length; i++)
        {
            samples[i] = (ushort)(((numbers[i] * (uint)ushort.MaxValue) + (max / 2)) / max);
        }

        Write(destination, samples.AsSpan(0, numbers.Length), width, GreyTransfer.Linear, (byte)bits);
        ArrayPool<ushort>.Shared.Return(samples);
    }

    /// <summary>Writes colours of three numbers of 16 bits, which mean what the reader takes them for.</summary>
    /// <param name="destination">The file; stays open.</param>
    /// <param name="colors">Three numbers a pixel, by rows from the top, each from left to right.</param>
    /// <param name="width">px.</param>
    public static void WriteColors(Stream destination, ReadOnlySpan<ushort> colors, int width)
    {
        const int channels = 3;
        destination.Write(Signature);
        WriteHeader(destination, width, colors.Length / channels / width, bitDepth: 16, TrueColorType);
        byte[] bytes = new byte[sizeof(ushort) * colors.Length];
        for (int i = 0; i < colors.Length; i++)
        {
            BinaryPrimitives.WriteUInt16BigEndian(bytes.AsSpan(sizeof(ushort) * i), colors[i]);
        }

        WriteRows(destination, bytes, sizeof(ushort) * channels * width, RunsOnly());
        PngChunk.Write(destination, "IEND"u8, []);
    }

    private static ZLibCompressionOptions RunsOnly() =>
        new() { CompressionLevel = 1, CompressionStrategy = ZLibCompressionStrategy.RunLengthEncoding };

    private static void WriteHead(Stream destination, int width, int height, byte bitDepth, GreyTransfer transfer)
    {
        destination.Write(Signature);
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
        using PngDataStream data = new(destination);
        using ZLibStream compressor = new(data, compression);
        int rowsPerBatch = Math.Max(1, BatchLength / (rowLength + 1));
        byte[] batch = ArrayPool<byte>.Shared.Rent(rowsPerBatch * (rowLength + 1));
        int used = 0;
        for (int start = 0; start < rows.Length; start += rowLength)
        {
            ReadOnlySpan<byte> row = rows.Slice(start, rowLength);
            ReadOnlySpan<byte> above = start == 0 ? [] : rows.Slice(start - rowLength, rowLength);
            batch[used] = UpFilter;
            Subtract(row, above, batch.AsSpan(used + 1, rowLength));
            used += rowLength + 1;
            if (used == rowsPerBatch * (rowLength + 1))
            {
                compressor.Write(batch, 0, used);
                used = 0;
            }
        }

        compressor.Write(batch, 0, used);
        ArrayPool<byte>.Shared.Return(batch);
    }

    /// <summary>Differences modulo 256; what is above the first row counts as 0.</summary>
    private static void Subtract(ReadOnlySpan<byte> row, ReadOnlySpan<byte> above, Span<byte> difference)
    {
        if (above.IsEmpty)
        {
            row.CopyTo(difference);
            return;
        }

        int i = 0;
        for (; i <= row.Length - Vector<byte>.Count; i += Vector<byte>.Count)
        {
            (new Vector<byte>(row[i..]) - new Vector<byte>(above[i..])).CopyTo(difference[i..]);
        }

        for (; i < row.Length; i++)
        {
            difference[i] = (byte)(row[i] - above[i]);
        }
    }
}
