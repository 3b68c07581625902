using System.Security.Cryptography;
using Msisf.Adapters.IO;
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
/// <param name="cacheFolder">The user's cache folder of this program, which need not exist; null if there is none.</param>
/// <param name="warn">Receives why a file can't be written.</param>
public sealed class SeamFiles(IReadOnlyList<LdemSet> sets, string? cacheFolder, Action<string> warn) : ISeamStore
{
    private const int NameDigits = 16;

    private static ReadOnlySpan<byte> Magic => "MSISFSE1"u8;

    /// <inheritdoc/>
    public GapTriangulation? Find(string productId, string border) =>
        PlacesOf(productId, border)?.Read(path => Read(path, productId, border));

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
            AtomicFile.Write(path, stream => HashedContent.Write(stream, Magic, writer => Write(writer, filling)), flushToDisk: false);
        }
        catch (Exception exception) when (exception.IsFileError() || exception is ExternalPartException)
        {
            warn($"{exception.Message} The seams of {filling.ProductId} are made again in the next run.");
        }
    }

    private SidecarPlaces? PlacesOf(string productId, string border) =>
        sets.FirstOrDefault(set => set.ProductId == productId)?.PlacesOf($".{border[..NameDigits]}.seam", cacheFolder);

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

    private static GapTriangulation? Parse(byte[] content, string productId, string border)
    {
        using BinaryReader? reader = HashedContent.TryRead(content, Magic);
        if (reader is null || reader.BaseStream.Length < 2 * sizeof(int))
        {
            return null;
        }

        (int borders, int corners) = (reader.ReadInt32(), reader.ReadInt32());
        if (borders < 1 || corners < 0 || reader.BaseStream.Length - reader.BaseStream.Position
            != ((long)borders * SHA256.HashSizeInBytes) + ((long)corners * sizeof(int)))
        {
            return null;
        }

        string[] hashes = [.. Enumerable.Range(0, borders).Select(_ => Convert.ToHexStringLower(reader.ReadBytes(SHA256.HashSizeInBytes)))];
        GapTriangulation filling = new(productId, hashes, [.. Enumerable.Range(0, corners).Select(_ => reader.ReadInt32())]);
        return filling.Key == border ? filling : null;
    }

    private static void Write(BinaryWriter writer, GapTriangulation filling)
    {
        writer.Write(filling.Borders.Count);
        writer.Write(filling.Corners.Length);
        foreach (string border in filling.Borders)
        {
            writer.Write(Convert.FromHexString(border));
        }

        foreach (int corner in filling.Corners)
        {
            writer.Write(corner);
        }
    }
}
