using System.Security.Cryptography;
using Msisf.Adapters.IO;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>
/// The levels of a map in a file, mapped into memory. Decoding a map takes seconds, so the file is kept in the user's cache folder. Don't
/// use its levels after it is disposed.
/// </summary>
internal sealed class MapLevelsFile : IDisposable
{
    private readonly MappedFile _file;

    private MapLevelsFile(MapLevelsHeader header, FileStream stream)
    {
        Header = header;
        _file = new MappedFile(stream);
        Levels =
        [
            .. header.Levels.Select((size, level) => new AlbedoMapLevel(
                size.Width, size.Height, _file.Numbers(header.OffsetOf(level), size.Width * size.Height))),
        ];
    }

    /// <summary>What the file says of itself.</summary>
    public MapLevelsHeader Header { get; }

    /// <summary>Finest first.</summary>
    public IReadOnlyList<AlbedoMapLevel> Levels { get; }

    /// <summary>Opens the levels of a map, which are made if the cache folder has none that fit.</summary>
    /// <param name="cacheFolder">The user's cache folder of this program; null for a file that is deleted at the end.</param>
    /// <param name="openSource">Opens the map.</param>
    /// <exception cref="BadInputException">The map can't be read.</exception>
    /// <exception cref="ExternalPartException">The levels can't be written, or a library for the map is missing.</exception>
    public static MapLevelsFile Open(MapFiles files, string? cacheFolder, Func<MapSource> openSource)
    {
        if (cacheFolder is not null)
        {
            string cached = Path.Combine(
                cacheFolder, "albedo", $"{Path.GetFileNameWithoutExtension(files.Place)}-{PathKey.Of(files.Place)}.levels");
            if (TryOpen(cached, files) is { } there)
            {
                return there;
            }

            if (SidecarPlaces.TakesFiles(Path.GetDirectoryName(cached)!, isMade: true))
            {
                using MapSource source = openSource();
                AtomicFile.Write(cached, stream => MapLevelsWriter.Write(files, source, stream), flushToDisk: false);
                return TryOpen(cached, files)
                    ?? throw new ExternalPartException($"{cached}: the levels of {files.Place} were written, but can't be read again.");
            }
        }

        return OpenTemporary(files, openSource);
    }

    /// <summary>Releases the pages that were read; they are mapped again when they are read again.</summary>
    public void ReleasePages() => _file.ReleasePages();

    /// <summary>Unmaps the file.</summary>
    public void Dispose() => _file.Dispose();

    private static MapLevelsFile OpenTemporary(MapFiles files, Func<MapSource> openSource)
    {
        string temporary = Path.Combine(Path.GetTempPath(), $"msisf-{Guid.NewGuid():N}.levels");
        return FileErrors.ToExternalPart($"{temporary}: the levels of {files.Place} can't be written", () =>
        {
            FileStream stream = new(
                temporary, FileMode.CreateNew, FileAccess.ReadWrite, FileShare.None, bufferSize: 65536, FileOptions.DeleteOnClose);
            try
            {
                using MapSource source = openSource();
                MapLevelsHeader header = MapLevelsWriter.Write(files, source, stream);
                stream.Flush();
                return new MapLevelsFile(header, stream);
            }
            catch
            {
                stream.Dispose();
                throw;
            }
        });
    }

    /// <summary>The levels in a file if they are complete and of the map as it is now.</summary>
    private static MapLevelsFile? TryOpen(string cached, MapFiles files)
    {
        if (!File.Exists(cached))
        {
            return null;
        }

        try
        {
            FileStream stream = new(cached, FileMode.Open, FileAccess.Read, FileShare.Read | FileShare.Delete);
            byte[] head = new byte[MapLevelsHeader.Bytes];
            stream.ReadAtLeast(head, head.Length, throwOnEndOfStream: false);
            if (MapLevelsHeader.TryRead(head) is { } header && header.FileBytes == stream.Length
                && (header.SourceBytes, header.SourceWritten) == files.State())
            {
                return new MapLevelsFile(header, stream);
            }

            stream.Dispose();
            return null;
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return null;
        }
    }
}

/// <summary>
/// The first bytes of a file with the levels of a map: which map it was made of, and what its codes mean. In little-endian order: magic
/// number, length and time of the map, its checksum, size, codes and extent; SHA-256 of these 128 bytes with their zeros; the number of
/// files if there are several, and the SHA-256 of each.
/// </summary>
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

    private const ulong Magic = 0x33_4C_42_4C_41_53_49_4D; // "MISALBL3": version 3, with the files' own scales
    private const int HashedBytes = 128;
    private const int HashBytes = SHA256.HashSizeInBytes;

    /// <summary>Most files of a map: the checksums of more don't fit into the header.</summary>
    public const int MaxFiles = (Bytes - HashedBytes - HashBytes - sizeof(int)) / HashBytes;

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
    public long OffsetOf(int level) => Bytes + Levels.Take(level).Sum(
        size => (((long)size.Width * size.Height * sizeof(ushort)) + Bytes - 1) / Bytes * Bytes);

    /// <summary>The length of the file.</summary>
    public long FileBytes => OffsetOf(Levels.Count);

    /// <summary>The header as the file has it.</summary>
    public byte[] ToBytes()
    {
        byte[] bytes = new byte[Bytes];
        using BinaryWriter writer = new(new MemoryStream(bytes));
        writer.Write(Magic);
        writer.Write(SourceBytes);
        writer.Write(SourceWritten);
        writer.Write(SourceHash);
        writer.Write(Width);
        writer.Write(Height);
        foreach (double number in (double[])
            [Offset, Step, Extent?.West ?? double.NaN, Extent?.North ?? 0.0, Extent?.Width ?? 0.0, Extent?.Height ?? 0.0])
        {
            writer.Write(number);
        }

        writer.BaseStream.Position = HashedBytes;
        writer.Write(SHA256.HashData(bytes.AsSpan(0, HashedBytes)));
        if (FileHashes.Count > 1)
        {
            writer.Write(FileHashes.Count);
            writer.Write(FileHashes.SelectMany(hash => hash).ToArray());
        }

        return bytes;
    }

    /// <summary>Reads a header; null if it is damaged or of another version.</summary>
    public static MapLevelsHeader? TryRead(byte[] bytes)
    {
        using BinaryReader reader = new(new MemoryStream(bytes));
        if (bytes.Length < Bytes || reader.ReadUInt64() != Magic
            || !SHA256.HashData(bytes.AsSpan(0, HashedBytes)).AsSpan().SequenceEqual(bytes.AsSpan(HashedBytes, HashBytes)))
        {
            return null;
        }

        (long sourceBytes, long written, byte[] sourceHash) = (reader.ReadInt64(), reader.ReadInt64(), reader.ReadBytes(HashBytes));
        (int width, int height) = (reader.ReadInt32(), reader.ReadInt32());
        double[] numbers = [.. Enumerable.Range(0, 6).Select(_ => reader.ReadDouble())];
        reader.BaseStream.Position = HashedBytes + HashBytes;
        byte[][] fileHashes =
            [.. Enumerable.Range(0, Math.Clamp(reader.ReadInt32(), 0, MaxFiles)).Select(_ => reader.ReadBytes(HashBytes))];
        return fileHashes.Length > 0 && !MapFiles.HashOf(fileHashes).AsSpan().SequenceEqual(sourceHash) ? null : new MapLevelsHeader(
            sourceBytes, written, fileHashes.Length > 0 ? fileHashes : [sourceHash], width, height, numbers[0], numbers[1],
            double.IsNaN(numbers[2]) ? null : new MapExtent(numbers[2], numbers[3], numbers[4], numbers[5]));
    }
}
