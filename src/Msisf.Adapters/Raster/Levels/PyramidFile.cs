using System.IO.MemoryMappedFiles;
using System.Runtime.InteropServices;
using System.Security.Cryptography;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Levels;

/// <summary>A model's sidecar (docs/elevation-formats.md), mapped into memory. Don't use its levels after it is disposed.</summary>
public sealed unsafe class PyramidFile : IDisposable
{
    private readonly PyramidHeader _header;
    private readonly MemoryMappedFile _file;
    private readonly MemoryMappedViewAccessor _view;
    private readonly PyramidLevel[] _levels;

    private PyramidFile(string path, PyramidHeader header, FileStream stream, uint[] checksums, IGlobalGrid source)
    {
        FilePath = path;
        _header = header;
        _file = MemoryMappedFile.CreateFromFile(
            stream, mapName: null, capacity: 0, MemoryMappedFileAccess.Read, HandleInheritability.None, leaveOpen: false);
        _view = _file.CreateViewAccessor(0, 0, MemoryMappedFileAccess.Read);
        byte* mapped = null;
        _view.SafeMemoryMappedViewHandle.AcquirePointer(ref mapped);
        byte* start = mapped + _view.PointerOffset;
        PyramidLayout layout = new(header.PixelsPerDegree);
        _levels = new PyramidLevel[layout.LevelCount];
        for (int index = 0; index < _levels.Length; index++)
        {
            int first = layout.FirstBlockOf(index);
            _levels[index] = new PyramidLevel(
                source, PyramidLayout.FirstLevel + index, path, (float*)(start + layout.OffsetOf(first)), checksums, first);
        }
    }

    /// <summary>Where it is.</summary>
    public string FilePath { get; }

    /// <summary>The stored levels, finest first: level 2 of the model and all coarser ones.</summary>
    public IReadOnlyList<IGlobalGrid> Levels => _levels;

    /// <summary>Opens a sidecar if it is complete and of this model. Neither its samples nor the model's are read for that.</summary>
    /// <param name="path">The file.</param>
    /// <param name="image">The model.</param>
    /// <param name="problem">Why it can't be used; null if it can, or if there is none.</param>
    public static PyramidFile? TryOpen(string path, LdemImage image, out string? problem)
    {
        problem = null;
        if (!File.Exists(path))
        {
            return null;
        }

        FileStream? stream = null;
        PyramidFile? file = null;
        try
        {
            stream = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read);
            (file, problem) = Open(path, stream, image);
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            problem = $"can't be read: {exception.Message}";
        }
        finally
        {
            if (file is null)
            {
                stream?.Dispose();
            }
        }

        return file;
    }

    /// <summary>Reads the whole sidecar and the whole model, and compares both with the checksums that the sidecar was made with.</summary>
    /// <param name="image">The model.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <exception cref="BadInputException">A block is damaged, or the model's samples are others.</exception>
    public void Verify(LdemImage image, CancellationToken cancellation)
    {
        foreach (PyramidLevel level in _levels)
        {
            level.Verify();
        }

        using LdemContentHash content = new(image);
        for (int line = 0; line < 180 * image.PixelsPerDegree; line += image.PixelsPerDegree)
        {
            cancellation.ThrowIfCancellationRequested();
            content.Append(line, image.PixelsPerDegree);
        }

        if (!content.Finish().SequenceEqual(_header.ContentHash))
        {
            throw new BadInputException(
                $"{FilePath}: it was made of other samples than {image.Set.Location} has now. Make it again with 'msis ldem pyramid'.");
        }
    }

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

    private static (PyramidFile? File, string? Problem) Open(string path, FileStream stream, LdemImage image)
    {
        Span<byte> head = stackalloc byte[PyramidHeader.Bytes];
        int length = stream.ReadAtLeast(head, head.Length, throwOnEndOfStream: false);
        if (PyramidHeader.TryRead(head[..length]) is not { } header)
        {
            return (null, "it is damaged, or no pyramid of this version");
        }

        if (header.PixelsPerDegree != image.PixelsPerDegree || !header.Fingerprint.SequenceEqual(SummarySource.Of(image.Set).Fingerprint()))
        {
            return (null, $"it is of another model, or {image.ProductId} was changed or copied since");
        }

        PyramidLayout layout = new(header.PixelsPerDegree);
        if (stream.Length != layout.FileBytes)
        {
            return (null, FormattableString.Invariant($"it has {stream.Length} bytes, {layout.FileBytes} expected"));
        }

        uint[] checksums = new uint[layout.BlockCount];
        stream.Position = PyramidLayout.ChecksumsOffset;
        stream.ReadExactly(MemoryMarshal.AsBytes(checksums.AsSpan()));
        return SHA256.HashData(MemoryMarshal.AsBytes(checksums.AsSpan())).AsSpan().SequenceEqual(header.ChecksumsHash)
            ? (new PyramidFile(path, header, stream, checksums, image), null)
            : (null, "it is damaged");
    }
}
