using System.Buffers;
using System.IO.MemoryMappedFiles;
using Msisf.Adapters.Interop;

namespace Msisf.Adapters.Raster;

/// <summary>A file mapped into memory: only the pages that are read are fetched. Don't use its memory after it is disposed.</summary>
internal sealed unsafe class MappedFile : IDisposable
{
    private readonly MemoryMappedFile _file;
    private readonly MemoryMappedViewAccessor _view;
    private readonly byte* _pages;

    /// <param name="stream">The file; it is closed with the mapping.</param>
    public MappedFile(FileStream stream)
    {
        _file = MemoryMappedFile.CreateFromFile(
            stream, mapName: null, capacity: 0, MemoryMappedFileAccess.Read, HandleInheritability.None, leaveOpen: false);
        _view = _file.CreateViewAccessor(0, 0, MemoryMappedFileAccess.Read);
        byte* pages = null;
        _view.SafeMemoryMappedViewHandle.AcquirePointer(ref pages);
        _pages = pages;
    }

    /// <summary>Address of the first byte.</summary>
    public byte* Start => _pages + _view.PointerOffset;

    /// <summary>A part of the file as memory of 16-bit numbers, which lives as long as the mapping.</summary>
    public Memory<ushort> Numbers(long offset, int length) => new MappedNumbers((ushort*)(Start + offset), length).Memory;

    /// <summary>Releases the pages that were read; they are mapped again when they are read again.</summary>
    public void ReleasePages() => MemoryAdvice.ReleasePages(_pages, _view.SafeMemoryMappedViewHandle.ByteLength);

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

    /// <summary>Frees nothing: the mapping does.</summary>
    private sealed class MappedNumbers(ushort* start, int length) : MemoryManager<ushort>
    {
        public override Span<ushort> GetSpan() => new(start, length);

        public override MemoryHandle Pin(int elementIndex = 0) => new(start + elementIndex);

        public override void Unpin()
        {
        }

        protected override void Dispose(bool disposing)
        {
        }
    }
}
