using System.Security.Cryptography;
using Msisf.Adapters.IO;

namespace Msisf.Adapters.Raster;

/// <summary>
/// The possible places of a file that is derived from a model: beside the model, or, if that folder can't be written to, in the user's
/// cache.
/// </summary>
/// <param name="Cached">In the cache, under a name of the model's own place; null without a cache.</param>
public sealed record SidecarPlaces(string Beside, string? Cached)
{
    /// <summary>The places for a model.</summary>
    /// <param name="productId">The model's name.</param>
    /// <param name="extension">Extension of the file, with its dot.</param>
    /// <param name="cacheFolder">The user's cache folder of this program, which need not exist; null if there is none.</param>
    internal static SidecarPlaces Of(string beside, string productId, string extension, string? cacheFolder) =>
        new(beside, cacheFolder is null ? null : Path.Combine(cacheFolder, $"{productId}-{PathKey.Of(beside)}{extension}"));

    /// <summary>Reads the file: what is beside the model, otherwise what the cache has.</summary>
    internal T? Read<T>(Func<string, T?> read)
        where T : class => read(Beside) ?? (Cached is null ? null : read(Cached));

    /// <summary>The first place whose folder takes files; without a cache the failure of writing says why.</summary>
    public string ForWriting() =>
        Cached is null || TakesFiles(Path.GetDirectoryName(Path.GetFullPath(Beside))!) ? Beside : Cached;

    /// <summary>Whether files can be made in a folder.</summary>
    /// <param name="isMade">Whether it is made if it is missing.</param>
    internal static bool TakesFiles(string folder, bool isMade = false)
    {
        try
        {
            if (isMade)
            {
                Directory.CreateDirectory(folder);
            }

            string probe = Path.Combine(folder, Path.GetRandomFileName());
            using FileStream file = new(
                probe, FileMode.CreateNew, FileAccess.Write, FileShare.None, bufferSize: 1, FileOptions.DeleteOnClose);
            return true;
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return false;
        }
    }
}

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
