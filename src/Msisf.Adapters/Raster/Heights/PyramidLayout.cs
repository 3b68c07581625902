using System.Buffers.Binary;
using System.Numerics;
using System.Runtime.InteropServices;
using System.Security.Cryptography;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// The layout of a sidecar: a page with the header, a checksum for each block, then the blocks, level by level from the finest one, each
/// level row by row. Blocks begin at pages and have their full size.
/// </summary>
/// <param name="PixelsPerDegree">Samples a degree of a model of the whole Moon; 0 for a map.</param>
/// <param name="Model">The blocks that the model itself would have.</param>
/// <param name="FirstLevel">The first level that is stored.</param>
/// <param name="LevelCount">Stored levels; 0 or less for a model with too few.</param>
internal readonly record struct PyramidLayout(int PixelsPerDegree, LodLayout Model, int FirstLevel, int LevelCount)
{
    public const int BlockBytes = sizeof(float) * LodLayout.BlockSamples;
    public const int ChecksumsOffset = PageBytes;
    private const int PageBytes = 4096;

    /// <summary>Level 1 would take half of the size of a model of 16-bit numbers; it is computed, four samples for one.</summary>
    private const int LeastFirstLevel = 2;

    /// <summary>The sidecar of a model of the whole Moon.</summary>
    public static PyramidLayout OfMoon(int pixelsPerDegree) => new(
        pixelsPerDegree, new LodLayout(pixelsPerDegree), LeastFirstLevel, LodLevels.CountOf(pixelsPerDegree) - LeastFirstLevel);

    /// <summary>The sidecar of a map: as fine as a size allows.</summary>
    /// <param name="mostBytes">The size.</param>
    public static PyramidLayout OfMap(ITerrainGrid map, long mostBytes)
    {
        int levels = MapLevels.CountOf(map);
        PyramidLayout layout = new(0, LodLayout.Of(map), LeastFirstLevel, levels - LeastFirstLevel);
        while (layout.LevelCount > 0 && layout.FileBytes > mostBytes)
        {
            layout = layout.From(layout.FirstLevel + 1);
        }

        return layout;
    }

    /// <summary>The sidecar of the same model without its finest levels.</summary>
    public PyramidLayout From(int firstLevel) =>
        this with { FirstLevel = firstLevel, LevelCount = LevelCount + FirstLevel - firstLevel };

    /// <summary>Blocks of all stored levels.</summary>
    public int BlockCount => FirstBlockOf(LevelCount);

    public long FileBytes => OffsetOf(BlockCount);

    /// <summary>Index of a level's first block among all stored blocks.</summary>
    /// <param name="index">0 is level <see cref="FirstLevel"/> of the model.</param>
    public int FirstBlockOf(int index)
    {
        LodLayout level = Model;
        for (int halving = 0; halving < FirstLevel; halving++)
        {
            level = level.Halved();
        }

        int first = 0;
        for (int before = 0; before < index; before++, level = level.Halved())
        {
            first += level.Blocks;
        }

        return first;
    }

    /// <summary>Where a block begins; checksums before the first one fill whole pages.</summary>
    public long OffsetOf(int block) =>
        ((ChecksumsOffset + ((long)BlockCount * sizeof(uint)) + PageBytes - 1) / PageBytes * PageBytes) + ((long)block * BlockBytes);

    /// <summary>CRC-32C of a block's bytes.</summary>
    public static uint ChecksumOf(ReadOnlySpan<float> heights)
    {
        uint checksum = uint.MaxValue;
        foreach (ulong bytes in MemoryMarshal.Cast<float, ulong>(heights))
        {
            checksum = BitOperations.Crc32C(checksum, bytes);
        }

        return checksum;
    }
}

/// <summary>The first bytes of a sidecar: which model it was made of, and the checksums of the rest.</summary>
/// <param name="PixelsPerDegree">Samples a degree of a model of the whole Moon; 0 for a map.</param>
/// <param name="FirstLevel">The first level that is stored.</param>
/// <param name="Fingerprint">Hash of sizes and times of the model's files, and of what their values mean, 32 bytes.</param>
/// <param name="ContentHash">
/// Hash of the samples of a model of the whole Moon (<see cref="LdemContentHash"/>), 32 bytes; zeros for a map.
/// </param>
/// <param name="ChecksumsHash">SHA-256 of the blocks' check sums, 32 bytes.</param>
internal sealed record PyramidHeader(
    int PixelsPerDegree, int FirstLevel, byte[] Fingerprint, byte[] ContentHash, byte[] ChecksumsHash)
{
    /// <summary>Magic number, two numbers, three hashes, and the hash of all that.</summary>
    public const int Bytes = HashedBytes + SHA256.HashSizeInBytes;

    private const int HashedBytes = 8 + (2 * sizeof(int)) + (3 * SHA256.HashSizeInBytes);

    /// <summary>Samples and checksums are in the machine's byte order; a file of the other order is refused.</summary>
    private static ReadOnlySpan<byte> Magic => BitConverter.IsLittleEndian ? "MSISFPL1"u8 : "MSISFPB1"u8;

    public byte[] ToBytes()
    {
        byte[] numbers = new byte[2 * sizeof(int)];
        BinaryPrimitives.WriteInt32LittleEndian(numbers, PixelsPerDegree);
        BinaryPrimitives.WriteInt32LittleEndian(numbers.AsSpan(sizeof(int)), FirstLevel);
        byte[] hashed = [.. Magic, .. numbers, .. Fingerprint, .. ContentHash, .. ChecksumsHash];
        return [.. hashed, .. SHA256.HashData(hashed)];
    }

    /// <summary>Reads a header.</summary>
    /// <returns>Null if it is none, or damaged.</returns>
    public static PyramidHeader? TryRead(ReadOnlySpan<byte> bytes) =>
        bytes.Length >= Bytes && bytes.StartsWith(Magic)
        && bytes[HashedBytes..Bytes].SequenceEqual(SHA256.HashData(bytes[..HashedBytes]))
            ? new PyramidHeader(
                BinaryPrimitives.ReadInt32LittleEndian(bytes[8..]), BinaryPrimitives.ReadInt32LittleEndian(bytes[12..]),
                bytes[16..48].ToArray(), bytes[48..80].ToArray(), bytes[80..112].ToArray())
            : null;
}
