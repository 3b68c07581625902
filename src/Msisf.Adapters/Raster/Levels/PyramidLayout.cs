using System.Buffers.Binary;
using System.Numerics;
using System.Runtime.InteropServices;
using System.Security.Cryptography;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Lod;

namespace Msisf.Adapters.Raster.Levels;

/// <summary>
/// The layout of a sidecar: a page with the header, a checksum for each block, then the blocks, level by level from the finest one, each
/// level row by row. Blocks begin at pages and have their full size.
/// </summary>
/// <param name="PixelsPerDegree">Samples a degree of the model.</param>
internal readonly record struct PyramidLayout(int PixelsPerDegree)
{
    /// <summary>
    /// The first level that is stored. Level 1 would take half of the model's own size; it is computed, four samples for one.
    /// </summary>
    public const int FirstLevel = 2;

    public const int BlockBytes = sizeof(float) * LodLayout.BlockSamples;
    public const int ChecksumsOffset = PageBytes;
    private const int PageBytes = 4096;

    /// <summary>Stored levels; 0 or less for a model with too few.</summary>
    public int LevelCount => LodLevels.CountOf(PixelsPerDegree) - FirstLevel;

    /// <summary>Blocks of all stored levels.</summary>
    public int BlockCount => FirstBlockOf(LevelCount);

    public long FileBytes => OffsetOf(BlockCount);

    /// <summary>Index of a level's first block among all stored blocks.</summary>
    /// <param name="index">0 is level <see cref="FirstLevel"/> of the model.</param>
    public int FirstBlockOf(int index)
    {
        int first = 0;
        for (int level = 0; level < index; level++)
        {
            first += new LodLayout(PixelsPerDegree >> (FirstLevel + level)).Blocks;
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
/// <param name="PixelsPerDegree">Samples a degree of the model.</param>
/// <param name="Fingerprint">Of label, sizes and times of the model's files (<see cref="SummarySource"/>), 32 bytes.</param>
/// <param name="ContentHash">Of the model's samples (<see cref="LdemContentHash"/>), 32 bytes.</param>
/// <param name="ChecksumsHash">SHA-256 of the blocks' check sums, 32 bytes.</param>
internal sealed record PyramidHeader(int PixelsPerDegree, byte[] Fingerprint, byte[] ContentHash, byte[] ChecksumsHash)
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
        BinaryPrimitives.WriteInt32LittleEndian(numbers.AsSpan(sizeof(int)), PyramidLayout.FirstLevel);
        byte[] hashed = [.. Magic, .. numbers, .. Fingerprint, .. ContentHash, .. ChecksumsHash];
        return [.. hashed, .. SHA256.HashData(hashed)];
    }

    /// <summary>Reads a header.</summary>
    /// <returns>Null if it is none, or damaged.</returns>
    public static PyramidHeader? TryRead(ReadOnlySpan<byte> bytes) =>
        bytes.Length >= Bytes && bytes.StartsWith(Magic)
        && BinaryPrimitives.ReadInt32LittleEndian(bytes[12..]) == PyramidLayout.FirstLevel
        && bytes[HashedBytes..Bytes].SequenceEqual(SHA256.HashData(bytes[..HashedBytes]))
            ? new PyramidHeader(
                BinaryPrimitives.ReadInt32LittleEndian(bytes[8..]), bytes[16..48].ToArray(), bytes[48..80].ToArray(),
                bytes[80..112].ToArray())
            : null;
}
