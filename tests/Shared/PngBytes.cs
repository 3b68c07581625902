using System.Buffers.Binary;
using System.IO.Compression;
using System.Text;

namespace Msisf.TestSupport;

/// <summary>PNG files made by hand from ISO/IEC 15948, apart from the program's own code.</summary>
internal static class PngBytes
{
    /// <summary>A file: the signature and its chunks.</summary>
    public static byte[] File(params byte[][] chunks) =>
        [0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, .. chunks.SelectMany(chunk => chunk)];

    /// <summary>An image of 8 bit RGB in one grey.</summary>
    public static byte[] Grey(int width, int height, byte level)
    {
        byte[] row = [0, .. Enumerable.Repeat(level, 3 * width)];
        return File(Header(width, height), Data([.. Enumerable.Range(0, height).SelectMany(_ => row)]), End());
    }

    /// <summary>IHDR of 8 bit RGB.</summary>
    public static byte[] Header(int width, int height)
    {
        byte[] header = [0, 0, 0, 0, 0, 0, 0, 0, 8, 2, 0, 0, 0];
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), height);
        return Chunk("IHDR", header);
    }

    /// <summary>IDAT of rows that each begin with their filter.</summary>
    public static byte[] Data(byte[] rows)
    {
        using MemoryStream compressed = new();
        using (ZLibStream zlib = new(compressed, CompressionLevel.Fastest))
        {
            zlib.Write(rows);
        }

        return Chunk("IDAT", compressed.ToArray());
    }

    /// <summary>IEND as the standard prints it.</summary>
    public static byte[] End() => [0, 0, 0, 0, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82];

    public static byte[] Chunk(string type, ReadOnlySpan<byte> data)
    {
        byte[] chunk = new byte[data.Length + 12];
        BinaryPrimitives.WriteInt32BigEndian(chunk, data.Length);
        Encoding.ASCII.GetBytes(type, chunk.AsSpan(4));
        data.CopyTo(chunk.AsSpan(8));
        BinaryPrimitives.WriteUInt32BigEndian(chunk.AsSpan(chunk.Length - 4), Crc(chunk.AsSpan(4, data.Length + 4)));
        return chunk;
    }

    /// <summary>Bit by bit, as the polynomial says; the program's own goes by table.</summary>
    private static uint Crc(ReadOnlySpan<byte> bytes)
    {
        uint crc = uint.MaxValue;
        foreach (byte b in bytes)
        {
            for (int bit = 0; bit < 8; bit++)
            {
                crc = (crc >> 1) ^ ((((crc ^ (uint)(b >> bit)) & 1) != 0) ? 0xEDB88320 : 0);
            }
        }

        return ~crc;
    }
}
