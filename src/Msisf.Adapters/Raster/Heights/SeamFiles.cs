using System.Buffers.Binary;
using System.Security.Cryptography;
using Msisf.Adapters.IO;
using Msisf.Core.Errors;
using Msisf.Core.Surface.Sources;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// Keeps the seams between several models in files, one for each gap, beside the finest model of the gap or in the user's cache: finding
/// them takes seconds for a large map. A file is found by the hash of its gap's borders, so that of another model or level has another
/// name; a damaged one counts as missing and is made again. Safe for several threads and processes.
/// </summary>
/// <remarks>
/// Layout: a magic number, SHA-256 of the rest, then little-endian 32-bit integers: number of borders, number of corners, the borders'
/// hashes (32 bytes each), the corners.
/// </remarks>
/// <param name="sets">The models.</param>
/// <param name="cacheFolder">The user's cache folder of this program, which need not exist; null if there is none.</param>
/// <param name="warn">Receives why a file can't be written.</param>
public sealed class SeamFiles(IReadOnlyList<LdemSet> sets, string? cacheFolder, Action<string> warn) : ISeamStore
{
    private const int HashBytes = 32;
    private const int NameDigits = 16;

    private static ReadOnlySpan<byte> Magic => "MSISFSE1"u8;

    /// <inheritdoc/>
    public GapTriangulation? Find(string productId, string border)
    {
        if (PlacesOf(productId, border) is not { } places)
        {
            return null;
        }

        return Read(places.Beside, productId, border) ?? (places.Cached is { } cached ? Read(cached, productId, border) : null);
    }

    /// <inheritdoc/>
    public void Keep(GapTriangulation filling)
    {
        if (PlacesOf(filling.ProductId, filling.Key) is not { } places)
        {
            return;
        }

        try
        {
            string path = places.ForWriting();
            Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(path))!);
            AtomicFile.Write(path, stream => Write(stream, filling), flushToDisk: false);
        }
        catch (Exception exception) when (exception.IsFileError() || exception is ExternalPartException)
        {
            warn($"{exception.Message} The seams of {filling.ProductId} are made again in the next run.");
        }
    }

    private SidecarPlaces? PlacesOf(string productId, string border) =>
        sets.FirstOrDefault(set => set.ProductId == productId) is { } set
            ? SidecarPlaces.Of(set, $".{border[..NameDigits]}.seam", cacheFolder)
            : null;

    private static GapTriangulation? Read(string path, string productId, string border)
    {
        try
        {
            return File.Exists(path) ? Parse(File.ReadAllBytes(path), productId, border) : null;
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return null; // an unreadable file is as good as none
        }
    }

    private static GapTriangulation? Parse(ReadOnlySpan<byte> content, string productId, string border)
    {
        int head = Magic.Length + HashBytes;
        if (content.Length < head + (2 * sizeof(int)) || !content.StartsWith(Magic)
            || !content.Slice(Magic.Length, HashBytes).SequenceEqual(SHA256.HashData(content[head..])))
        {
            return null;
        }

        ReadOnlySpan<byte> rest = content[head..];
        int borders = BinaryPrimitives.ReadInt32LittleEndian(rest);
        int corners = BinaryPrimitives.ReadInt32LittleEndian(rest[sizeof(int)..]);
        rest = rest[(2 * sizeof(int))..];
        if (borders < 1 || corners < 0 || rest.Length != ((long)borders * HashBytes) + ((long)corners * sizeof(int)))
        {
            return null;
        }

        string[] hashes = new string[borders];
        for (int i = 0; i < borders; i++, rest = rest[HashBytes..])
        {
            hashes[i] = Convert.ToHexStringLower(rest[..HashBytes]);
        }

        int[] numbers = new int[corners];
        for (int i = 0; i < corners; i++)
        {
            numbers[i] = BinaryPrimitives.ReadInt32LittleEndian(rest[(i * sizeof(int))..]);
        }

        GapTriangulation filling = new(productId, hashes, numbers);
        return filling.Key == border ? filling : null;
    }

    private static void Write(Stream stream, GapTriangulation filling)
    {
        byte[] rest = new byte[(2 * sizeof(int)) + (filling.Borders.Count * HashBytes) + (filling.Corners.Length * sizeof(int))];
        BinaryPrimitives.WriteInt32LittleEndian(rest, filling.Borders.Count);
        BinaryPrimitives.WriteInt32LittleEndian(rest.AsSpan(sizeof(int)), filling.Corners.Length);
        int at = 2 * sizeof(int);
        foreach (string border in filling.Borders)
        {
            Convert.FromHexString(border).CopyTo(rest, at);
            at += HashBytes;
        }

        foreach (int corner in filling.Corners)
        {
            BinaryPrimitives.WriteInt32LittleEndian(rest.AsSpan(at), corner);
            at += sizeof(int);
        }

        stream.Write(Magic);
        stream.Write(SHA256.HashData(rest));
        stream.Write(rest);
    }
}
