using System.Buffers.Binary;
using System.Text;

namespace Msisf.Adapters.Render;

/// <summary>Checks a PNG file chunk by chunk and leaves out what is not image, so that equal images are equal bytes.</summary>
public static class PngFile
{
    private const int BufferSize = 65536;
    private const int HeaderLength = 13;

    internal static ReadOnlySpan<byte> Signature => [0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A];

    /// <summary>Copies a whole PNG without its time stamps and texts (POV-Ray writes tIME and a tEXt with the render date).</summary>
    /// <param name="source">The file, from its first byte to its end.</param>
    /// <param name="destination">Receives the copy; on failure it holds a part, which its owner throws away.</param>
    /// <param name="name">The file's name for the message.</param>
    /// <exception cref="BadInputException">Not a PNG, cut off, or damaged: a chunk's check value is wrong.</exception>
    public static PngHeader CopyImage(Stream source, Stream destination, string name)
    {
        byte[] buffer = new byte[BufferSize];
        ReadExactly(source, buffer.AsSpan(0, Signature.Length), name);
        if (!buffer.AsSpan(0, Signature.Length).SequenceEqual(Signature))
        {
            throw Damaged(name, "it does not start as a PNG file does");
        }

        destination.Write(Signature);
        PngHeader? header = null;
        bool hasPixels = false;
        while (true)
        {
            ReadExactly(source, buffer.AsSpan(0, 8), name);
            uint length = BinaryPrimitives.ReadUInt32BigEndian(buffer);
            string type = Encoding.Latin1.GetString(buffer, 4, 4);
            if (length > int.MaxValue)
            {
                throw Damaged(name, $"chunk {type} has {length} bytes");
            }

            Stream kept = IsImage(type) ? destination : Stream.Null;
            kept.Write(buffer, 0, 8);
            CopyChunk(source, kept, (int)length, type, buffer, name);
            if ((header is null) != (type == "IHDR") || (type == "IHDR" && length != HeaderLength))
            {
                throw Damaged(name, "IHDR is not its first chunk, or not its only one, or not 13 bytes long");
            }

            // Still in the buffer: the chunk is shorter than it.
            header ??= ParseHeader(buffer.AsSpan(0, HeaderLength), name);
            hasPixels |= type == "IDAT";
            if (type == "IEND")
            {
                break;
            }
        }

        if (!hasPixels)
        {
            throw Damaged(name, "it has no IDAT chunk");
        }

        return source.ReadByte() < 0 ? header.Value : throw Damaged(name, "it goes on after its end chunk");
    }

    /// <summary>Checks that a PNG is whole.</summary>
    /// <param name="source">The file, from its first byte to its end.</param>
    /// <param name="name">The file's name for the message.</param>
    /// <exception cref="BadInputException">Not a PNG, cut off, or damaged.</exception>
    public static PngHeader Check(Stream source, string name) => CopyImage(source, Stream.Null, name);

    /// <summary>Checks the image of a finished frame.</summary>
    /// <exception cref="BadInputException">Not a PNG, cut off, or damaged; the message has the path.</exception>
    /// <exception cref="ExternalPartException">It can't be read.</exception>
    public static PngHeader CheckFile(string path) => FileErrors.ToExternalPart($"{path}: can't be read", () =>
    {
        using FileStream stream = File.OpenRead(path);
        return Check(stream, path);
    });

    private static bool IsImage(string type) => type is not ("tIME" or "tEXt" or "zTXt" or "iTXt" or "eXIf");

    /// <summary>Copies data and check value; of a chunk that fits, the data stay at the start of the buffer.</summary>
    private static void CopyChunk(Stream source, Stream destination, int length, string type, byte[] buffer, string name)
    {
        uint crc = PngCrc.Update(PngCrc.Start, buffer.AsSpan(4, 4));
        for (int left = length; left > 0;)
        {
            Span<byte> part = buffer.AsSpan(0, Math.Min(left, buffer.Length));
            ReadExactly(source, part, name);
            crc = PngCrc.Update(crc, part);
            destination.Write(part);
            left -= part.Length;
        }

        Span<byte> stored = stackalloc byte[4];
        ReadExactly(source, stored, name);
        destination.Write(stored);
        if (BinaryPrimitives.ReadUInt32BigEndian(stored) != PngCrc.Finish(crc))
        {
            throw Damaged(name, $"the check value of a chunk {type} is wrong");
        }
    }

    private static PngHeader ParseHeader(ReadOnlySpan<byte> data, string name)
    {
        int width = BinaryPrimitives.ReadInt32BigEndian(data);
        int height = BinaryPrimitives.ReadInt32BigEndian(data[4..]);
        return width > 0 && height > 0
            ? new PngHeader(width, height, data[8], data[9])
            : throw Damaged(name, $"its size is {width} x {height} px");
    }

    private static void ReadExactly(Stream source, Span<byte> destination, string name)
    {
        if (source.ReadAtLeast(destination, destination.Length, throwOnEndOfStream: false) < destination.Length)
        {
            throw Damaged(name, "it is cut off before its end chunk");
        }
    }

    private static BadInputException Damaged(string name, string reason) =>
        new($"{name}: not a whole PNG image: {reason}. Render it again.");
}

/// <summary>What a PNG image's IHDR chunk says.</summary>
/// <param name="Width">px.</param>
/// <param name="Height">px.</param>
/// <param name="BitDepth">Bits a sample: 1, 2, 4, 8 or 16.</param>
/// <param name="ColorType">PNG's code: 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGB and alpha.</param>
public readonly record struct PngHeader(int Width, int Height, int BitDepth, int ColorType);

/// <summary>A chunk of a PNG file (ISO/IEC 15948, section 5.3): length, type, data, check value.</summary>
internal static class PngChunk
{
    private const int TypeLength = 4;

    /// <summary>Writes a whole chunk.</summary>
    /// <param name="type">Four letters.</param>
    /// <param name="data">May be empty.</param>
    public static void Write(Stream destination, ReadOnlySpan<byte> type, ReadOnlySpan<byte> data)
    {
        Span<byte> head = stackalloc byte[4 + TypeLength];
        BinaryPrimitives.WriteInt32BigEndian(head, data.Length);
        type.CopyTo(head[4..]);
        destination.Write(head);
        destination.Write(data);
        Span<byte> check = stackalloc byte[4];
        uint crc = PngCrc.Update(PngCrc.Update(PngCrc.Start, type), data);
        BinaryPrimitives.WriteUInt32BigEndian(check, PngCrc.Finish(crc));
        destination.Write(check);
    }
}
