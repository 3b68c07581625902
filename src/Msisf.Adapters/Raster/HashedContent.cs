using System.Security.Cryptography;

namespace Msisf.Adapters.Raster;

/// <summary>
/// The content of a file of the program's own: a head that says what it is, SHA-256 of the values, the values, in little-endian order.
/// </summary>
internal static class HashedContent
{
    /// <summary>Writes content.</summary>
    /// <param name="stream">An empty file.</param>
    /// <param name="write">Writes the values.</param>
    public static void Write(Stream stream, ReadOnlySpan<byte> head, Action<BinaryWriter> write)
    {
        using MemoryStream values = new();
        using BinaryWriter writer = new(values);
        write(writer);
        writer.Flush();
        stream.Write(head);
        stream.Write(SHA256.HashData(values.GetBuffer().AsSpan(0, (int)values.Length)));
        values.WriteTo(stream);
    }

    /// <summary>The values; null if the content has another head, or is damaged.</summary>
    public static BinaryReader? TryRead(ReadOnlySpan<byte> content, ReadOnlySpan<byte> head)
    {
        int start = head.Length + SHA256.HashSizeInBytes;
        return content.Length >= start && content.StartsWith(head)
            && content[head.Length..start].SequenceEqual(SHA256.HashData(content[start..]))
            ? new BinaryReader(new MemoryStream(content[start..].ToArray()))
            : null;
    }
}
