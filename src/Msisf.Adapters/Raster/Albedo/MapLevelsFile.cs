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
