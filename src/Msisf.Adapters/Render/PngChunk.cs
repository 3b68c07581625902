using System.Buffers.Binary;

namespace Msisf.Adapters.Render;

/// <summary>A chunk of a PNG file (ISO/IEC 15948, section 5.3): length, type, data, check value.</summary>
internal static class PngChunk
{
    private const int TypeLength = 4;

    /// <summary>Writes a whole chunk.</summary>
    /// <param name="destination">The file.</param>
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
