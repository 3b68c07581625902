using System.Globalization;
using System.IO.MemoryMappedFiles;
using Msisf.Adapters.IO;
using Msisf.Adapters.Interop;
using Msisf.Core.Errors;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>
/// The levels of a map in a file, mapped into memory. Decoding a map takes seconds, so the file is kept in the user's cache folder. Don't
/// use its levels after it is disposed.
/// </summary>
internal sealed unsafe class MapLevelsFile : IDisposable
{
    private readonly MemoryMappedFile _file;
    private readonly MemoryMappedViewAccessor _view;
    private readonly byte* _start;

    private MapLevelsFile(MapLevelsHeader header, FileStream stream)
    {
        Header = header;
        _file = MemoryMappedFile.CreateFromFile(
            stream, mapName: null, capacity: 0, MemoryMappedFileAccess.Read, HandleInheritability.None, leaveOpen: false);
        _view = _file.CreateViewAccessor(0, 0, MemoryMappedFileAccess.Read);
        byte* start = null;
        _view.SafeMemoryMappedViewHandle.AcquirePointer(ref start);
        _start = start + _view.PointerOffset;
        Levels =
        [
            .. header.Levels.Select((size, level) => new AlbedoMapLevel(
                size.Width, size.Height, new MappedCodes((ushort*)(_start + header.OffsetOf(level)), size.Width * size.Height).Memory)),
        ];
    }

    /// <summary>What the file says of itself.</summary>
    public MapLevelsHeader Header { get; }

    /// <summary>Finest first.</summary>
    public IReadOnlyList<AlbedoMapLevel> Levels { get; }

    /// <summary>Opens the levels of a map, which are made if the cache folder has none that fit.</summary>
    /// <param name="files">The map's files.</param>
    /// <param name="cacheFolder">The user's cache folder of this program; null for a file that is deleted at the end.</param>
    /// <param name="openSource">Opens the map.</param>
    /// <exception cref="BadInputException">The map can't be read.</exception>
    /// <exception cref="ExternalPartException">The levels can't be written, or a library for the map is missing.</exception>
    public static MapLevelsFile Open(MapFiles files, string? cacheFolder, Func<MapSource> openSource)
    {
        if (cacheFolder is not null)
        {
            string cached = Path.Combine(cacheFolder, "albedo", NameOf(files.Place));
            if (TryOpen(cached, files) is { } there)
            {
                return there;
            }

            if (TryMakeFolder(Path.GetDirectoryName(cached)!))
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
    public void ReleasePages() => MemoryAdvice.ReleasePages(_start, _view.SafeMemoryMappedViewHandle.ByteLength);

    /// <summary>Unmaps the file.</summary>
    public void Dispose()
    {
        if (!_view.SafeMemoryMappedViewHandle.IsClosed)
        {
            _view.SafeMemoryMappedViewHandle.ReleasePointer();
            _view.Dispose();
            _file.Dispose();
        }
    }

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
            int length = stream.ReadAtLeast(head, head.Length, throwOnEndOfStream: false);
            if (MapLevelsHeader.TryRead(head.AsSpan(0, length)) is { } header && header.FileBytes == stream.Length
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

    private static bool TryMakeFolder(string folder)
    {
        try
        {
            Directory.CreateDirectory(folder);
            string probe = Path.Combine(folder, string.Create(CultureInfo.InvariantCulture, $".{Environment.ProcessId}"));
            File.WriteAllBytes(probe, []);
            File.Delete(probe);
            return true;
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return false;
        }
    }

    /// <summary>A name that the map of a place has for itself.</summary>
    private static string NameOf(string place) => $"{Path.GetFileNameWithoutExtension(place)}-{PathKey.Of(place)}.levels";
}
