using System.Buffers.Binary;
using System.Security.Cryptography;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>The first bytes of a file with the levels of a map: which map it was made of, and what its codes mean.</summary>
/// <param name="SourceBytes">Length of the map's file, or of all of them.</param>
/// <param name="SourceWritten">When that was last written, UTC ticks; of several files see <see cref="MapFiles.State"/>.</param>
/// <param name="FileHashes">SHA-256 of the map's files.</param>
/// <param name="Width">Pixels of the finest level from west to east.</param>
/// <param name="Height">Pixels of the finest level from north to south.</param>
/// <param name="Offset">Stored value of the map at the code 0.</param>
/// <param name="Step">Stored value of the map for a step of the code.</param>
/// <param name="Extent">What the map shows; null if its file does not say.</param>
internal sealed record MapLevelsHeader(
    long SourceBytes, long SourceWritten, IReadOnlyList<byte[]> FileHashes, int Width, int Height, double Offset, double Step,
    MapExtent? Extent)
{
    /// <summary>Size of the header.</summary>
    public const int Bytes = 4096;

    private const ulong Magic = 0x31_4C_42_4C_41_53_49_4D; // "MISALBL1": version 1
    private const int HashedBytes = 128;

    /// <summary>Behind the header's own checksum: the number of files if there are several, and the SHA-256 of each.</summary>
    private const int FileHashesStart = HashedBytes + SHA256.HashSizeInBytes;

    /// <summary>Most files of a map: the checksums of more don't fit into the header.</summary>
    public const int MaxFiles = (Bytes - FileHashesStart - sizeof(int)) / SHA256.HashSizeInBytes;

    /// <summary>The checksum of the map.</summary>
    public byte[] SourceHash { get; } = MapFiles.HashOf(FileHashes);

    /// <summary>The sizes of the levels, finest first, down to one pixel.</summary>
    public IReadOnlyList<(int Width, int Height)> Levels
    {
        get
        {
            List<(int Width, int Height)> levels = [(Width, Height)];
            while (levels[^1] is not (1, 1))
            {
                levels.Add(AlbedoMapLevel.Below(levels[^1].Width, levels[^1].Height));
            }

            return levels;
        }
    }

    /// <summary>Where a level begins in the file; that of the level after the last is the file's length.</summary>
    public long OffsetOf(int level)
    {
        long offset = Bytes;
        foreach ((int width, int height) in Levels.Take(level))
        {
            offset += (((long)width * height * sizeof(ushort)) + Bytes - 1) / Bytes * Bytes;
        }

        return offset;
    }

    /// <summary>The length of the file.</summary>
    public long FileBytes => OffsetOf(Levels.Count);

    /// <summary>The header as the file has it.</summary>
    public byte[] ToBytes()
    {
        byte[] bytes = new byte[Bytes];
        Span<byte> rest = bytes;
        BinaryPrimitives.WriteUInt64LittleEndian(rest, Magic);
        BinaryPrimitives.WriteInt64LittleEndian(rest[8..], SourceBytes);
        BinaryPrimitives.WriteInt64LittleEndian(rest[16..], SourceWritten);
        SourceHash.CopyTo(rest[24..]);
        BinaryPrimitives.WriteInt32LittleEndian(rest[56..], Width);
        BinaryPrimitives.WriteInt32LittleEndian(rest[60..], Height);
        double[] numbers = [Offset, Step, Extent?.West ?? double.NaN, Extent?.North ?? 0.0, Extent?.Width ?? 0.0, Extent?.Height ?? 0.0];
        for (int i = 0; i < numbers.Length; i++)
        {
            BinaryPrimitives.WriteDoubleLittleEndian(rest[(64 + (8 * i))..], numbers[i]);
        }

        SHA256.HashData(rest[..HashedBytes], rest[HashedBytes..]);
        if (FileHashes.Count > 1)
        {
            BinaryPrimitives.WriteInt32LittleEndian(rest[FileHashesStart..], FileHashes.Count);
            for (int i = 0; i < FileHashes.Count; i++)
            {
                FileHashes[i].CopyTo(rest[PlaceOfHash(i)..]);
            }
        }

        return bytes;
    }

    /// <summary>Reads a header; null if it is damaged or of another version.</summary>
    public static MapLevelsHeader? TryRead(ReadOnlySpan<byte> bytes)
    {
        if (bytes.Length < Bytes || BinaryPrimitives.ReadUInt64LittleEndian(bytes) != Magic
            || !SHA256.HashData(bytes[..HashedBytes]).AsSpan().SequenceEqual(bytes.Slice(HashedBytes, SHA256.HashSizeInBytes)))
        {
            return null;
        }

        byte[] sourceHash = bytes.Slice(24, SHA256.HashSizeInBytes).ToArray();
        List<byte[]> fileHashes = [];
        int files = Math.Clamp(BinaryPrimitives.ReadInt32LittleEndian(bytes[FileHashesStart..]), 0, MaxFiles);
        for (int i = 0; i < files; i++)
        {
            fileHashes.Add(bytes.Slice(PlaceOfHash(i), SHA256.HashSizeInBytes).ToArray());
        }

        if (files > 0 && !MapFiles.HashOf(fileHashes).AsSpan().SequenceEqual(sourceHash))
        {
            return null;
        }

        double[] numbers = new double[6];
        for (int i = 0; i < numbers.Length; i++)
        {
            numbers[i] = BinaryPrimitives.ReadDoubleLittleEndian(bytes[(64 + (8 * i))..]);
        }

        return new MapLevelsHeader(
            BinaryPrimitives.ReadInt64LittleEndian(bytes[8..]),
            BinaryPrimitives.ReadInt64LittleEndian(bytes[16..]),
            files > 0 ? fileHashes : [sourceHash],
            BinaryPrimitives.ReadInt32LittleEndian(bytes[56..]),
            BinaryPrimitives.ReadInt32LittleEndian(bytes[60..]),
            numbers[0],
            numbers[1],
            double.IsNaN(numbers[2]) ? null : new MapExtent(numbers[2], numbers[3], numbers[4], numbers[5]));
    }

    private static int PlaceOfHash(int file) => FileHashesStart + sizeof(int) + (file * SHA256.HashSizeInBytes);
}
