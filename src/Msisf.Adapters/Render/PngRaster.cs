using System.Buffers.Binary;
using System.IO.Compression;

namespace Msisf.Adapters.Render;

/// <summary>A PNG image (ISO/IEC 15948) as its samples: to join strips of one image, and to write equal images as equal bytes.</summary>
public sealed class PngRaster
{
    private const int ChunkFrame = 12; // length, type, check value
    private const int HeaderLength = 13;
    private const int SignatureLength = 8;

    private readonly byte[] _head;
    private readonly byte[] _rows;
    private readonly int _rowLength;

    private PngRaster(byte[] head, byte[] rows, int rowLength)
    {
        _head = head;
        _rows = rows;
        _rowLength = rowLength;
    }

    /// <summary>Reads an image.</summary>
    /// <param name="source">The file, from its first byte to its end.</param>
    /// <param name="name">The file's name for the message.</param>
    /// <exception cref="BadInputException">Not a PNG, cut off, damaged, or interlaced.</exception>
    public static PngRaster Read(Stream source, string name)
    {
        using MemoryStream copy = new();
        PngHeader header = PngFile.CopyImage(source, copy, name);
        ReadOnlySpan<byte> file = copy.GetBuffer().AsSpan(0, (int)copy.Length);
        if (file[SignatureLength + ChunkFrame + HeaderLength - 5] != 0)
        {
            throw new BadInputException($"{name}: an interlaced PNG image; leave that option out.");
        }

        int sampleBits = header.BitDepth * Channels(header.ColorType, name);
        int rowLength = ((header.Width * sampleBits) + 7) / 8;
        using MemoryStream compressed = new();
        int headLength = SplitOffData(file, compressed);
        byte[] rows = new byte[header.Height * rowLength];
        Unpack(compressed, rows, rowLength, Math.Max(1, sampleBits / 8), name);
        return new PngRaster(file[..headLength].ToArray(), rows, rowLength);
    }

    /// <summary>The image of some of whose rows each strip has, and the rest black.</summary>
    /// <param name="strips">Images of one size and kind, from the topmost strip to the lowest.</param>
    /// <param name="firstRows">The first row of each; it ends where the next begins.</param>
    public static PngRaster Join(IReadOnlyList<PngRaster> strips, IReadOnlyList<int> firstRows)
    {
        if (strips.Count == 1)
        {
            return strips[0];
        }

        byte[] rows = new byte[strips[0]._rows.Length];
        for (int strip = 0; strip < strips.Count; strip++)
        {
            int start = firstRows[strip] * strips[strip]._rowLength;
            int end = strip + 1 < strips.Count ? firstRows[strip + 1] * strips[strip]._rowLength : rows.Length;
            strips[strip]._rows.AsSpan(start, end - start).CopyTo(rows.AsSpan(start));
        }

        return new PngRaster(strips[0]._head, rows, strips[0]._rowLength);
    }

    /// <summary>Writes the image: the same samples give the same bytes, whoever compressed them before.</summary>
    public void Write(Stream destination)
    {
        destination.Write(_head);
        PngWriter.WriteRows(destination, _rows, _rowLength, new ZLibCompressionOptions { CompressionLevel = 6 });
        PngChunk.Write(destination, "IEND"u8, []);
    }

    /// <summary>The numbers of a detector (<see cref="PngWriter.WriteNumbers"/>), by rows; null if the image has grey levels.</summary>
    public ushort[]? DetectorNumbers()
    {
        int chunk = _head.AsSpan().IndexOf("sBIT"u8);
        if (chunk < 0)
        {
            return null;
        }

        int bits = _head[chunk + 4];
        ushort[] numbers = new ushort[_rows.Length / sizeof(ushort)];
        for (int i = 0; i < numbers.Length; i++)
        {
            numbers[i] = (ushort)(BinaryPrimitives.ReadUInt16BigEndian(_rows.AsSpan(i * sizeof(ushort))) >> (16 - bits));
        }

        return numbers;
    }

    /// <returns>Length of all that is before the pixels.</returns>
    private static int SplitOffData(ReadOnlySpan<byte> file, MemoryStream compressed)
    {
        int head = 0;
        for (int position = SignatureLength; position < file.Length;)
        {
            int length = BinaryPrimitives.ReadInt32BigEndian(file[position..]);
            if (file.Slice(position + 4, 4).SequenceEqual("IDAT"u8))
            {
                head = head == 0 ? position : head;
                compressed.Write(file.Slice(position + 8, length));
            }

            position += length + ChunkFrame;
        }

        compressed.Position = 0;
        return head;
    }

    private static void Unpack(MemoryStream compressed, byte[] rows, int rowLength, int pixelLength, string name)
    {
        using ZLibStream stream = new(compressed, CompressionMode.Decompress);
        byte[] filter = new byte[1];
        ReadOnlySpan<byte> above = new byte[rowLength];
        try
        {
            for (int start = 0; start < rows.Length; start += rowLength)
            {
                Span<byte> row = rows.AsSpan(start, rowLength);
                stream.ReadExactly(filter);
                stream.ReadExactly(row);
                Unfilter(filter[0], row, above, pixelLength, name);
                above = row;
            }
        }
        catch (Exception exception) when (exception is InvalidDataException or EndOfStreamException)
        {
            throw new BadInputException($"{name}: not a whole PNG image: its pixels can't be unpacked. Render it again.", exception);
        }
    }

    private static int Channels(int colorType, string name) => colorType switch
    {
        0 or 3 => 1,
        2 => 3,
        4 => 2,
        6 => 4,
        _ => throw new BadInputException($"{name}: a PNG image of the unknown colour type {colorType}."),
    };

    /// <summary>Section 9 of the standard.</summary>
    private static void Unfilter(byte filter, Span<byte> row, ReadOnlySpan<byte> above, int pixel, string name)
    {
        for (int i = 0; i < row.Length; i++)
        {
            int left = i >= pixel ? row[i - pixel] : 0;
            int corner = i >= pixel ? above[i - pixel] : 0;
            row[i] += filter switch
            {
                0 => 0,
                1 => (byte)left,
                2 => above[i],
                3 => (byte)((left + above[i]) / 2),
                4 => (byte)Paeth(left, above[i], corner),
                _ => throw new BadInputException($"{name}: a PNG image with the unknown filter {filter}."),
            };
        }
    }

    private static int Paeth(int left, int above, int corner)
    {
        int estimate = left + above - corner;
        int toLeft = Math.Abs(estimate - left);
        int toAbove = Math.Abs(estimate - above);
        int toCorner = Math.Abs(estimate - corner);
        return toLeft <= toAbove && toLeft <= toCorner ? left : toAbove <= toCorner ? above : corner;
    }
}
