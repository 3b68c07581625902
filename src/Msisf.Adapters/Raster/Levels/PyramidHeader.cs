using System.Buffers.Binary;
using System.Security.Cryptography;
using Msisf.Adapters.Raster.Heights;

namespace Msisf.Adapters.Raster.Levels;

/// <summary>The first bytes of a sidecar: which model it was made of, and the checksums of the rest.</summary>
/// <param name="PixelsPerDegree">Samples a degree of the model.</param>
/// <param name="Fingerprint">Of label, sizes and times of the model's files (<see cref="SummarySource"/>), 32 bytes.</param>
/// <param name="ContentHash">Of the model's samples (<see cref="LdemContentHash"/>), 32 bytes.</param>
/// <param name="ChecksumsHash">SHA-256 of the blocks' check sums, 32 bytes.</param>
internal sealed record PyramidHeader(int PixelsPerDegree, byte[] Fingerprint, byte[] ContentHash, byte[] ChecksumsHash)
{
    /// <summary>Magic number, two numbers, three hashes, and the hash of all that.</summary>
    public const int Bytes = 8 + (2 * sizeof(int)) + (4 * SHA256.HashSizeInBytes);

    /// <summary>Samples and checksums are in the machine's byte order; a file of the other order is refused.</summary>
    private static ReadOnlySpan<byte> Magic => BitConverter.IsLittleEndian ? "MSISFPL1"u8 : "MSISFPB1"u8;

    public byte[] ToBytes()
    {
        byte[] bytes = new byte[Bytes];
        Magic.CopyTo(bytes);
        BinaryPrimitives.WriteInt32LittleEndian(bytes.AsSpan(8), PixelsPerDegree);
        BinaryPrimitives.WriteInt32LittleEndian(bytes.AsSpan(12), PyramidLayout.FirstLevel);
        Fingerprint.CopyTo(bytes, 16);
        ContentHash.CopyTo(bytes, 48);
        ChecksumsHash.CopyTo(bytes, 80);
        SHA256.HashData(bytes.AsSpan(0, 112), bytes.AsSpan(112));
        return bytes;
    }

    /// <summary>Reads a header.</summary>
    /// <returns>Null if it is none, or damaged.</returns>
    public static PyramidHeader? TryRead(ReadOnlySpan<byte> bytes)
    {
        bool isWhole = bytes.Length >= Bytes
            && bytes.StartsWith(Magic)
            && BinaryPrimitives.ReadInt32LittleEndian(bytes[12..]) == PyramidLayout.FirstLevel
            && bytes[112..Bytes].SequenceEqual(SHA256.HashData(bytes[..112]));
        return isWhole
            ? new PyramidHeader(
                BinaryPrimitives.ReadInt32LittleEndian(bytes[8..]),
                bytes[16..48].ToArray(),
                bytes[48..80].ToArray(),
                bytes[80..112].ToArray())
            : null;
    }
}
