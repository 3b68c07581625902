using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Msisf.Adapters.Interop;

/// <summary>Where CFITSIO has a file until it is copied to a stream: in memory or on disk.</summary>
internal interface IFitsStore : IDisposable
{
    /// <summary>Opens it as a file; <see cref="CFitsio.Gate"/> is held.</summary>
    int Open(out CFitsioHandle file, ref int status);

    /// <summary>Copies a part of the file.</summary>
    void CopyTo(Stream destination, long start, long end);
}

/// <summary>A FITS file on disk for what is too large for memory; it goes when it is done with.</summary>
/// <param name="path">Where no file is yet.</param>
internal sealed class FitsDiskFile(string path) : IFitsStore
{
    /// <summary>bytes: what is copied at once.</summary>
    private const int CopiedAtOnce = 1 << 20;

    public int Open(out CFitsioHandle file, ref int status) => CFitsioNative.ffdkinit(out file, path, ref status);

    public void CopyTo(Stream destination, long start, long end)
    {
        using FileStream file = new(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
        file.Position = start;
        byte[] bytes = new byte[CopiedAtOnce];
        for (long left = end - start; left > 0;)
        {
            int count = (int)Math.Min(left, bytes.Length);
            file.ReadExactly(bytes, 0, count);
            destination.Write(bytes, 0, count);
            left -= count;
        }
    }

    public void Dispose() => File.Delete(path);
}

/// <summary>The memory that holds a FITS file. CFITSIO keeps pointers into it, and may move and resize it.</summary>
internal sealed unsafe class FitsMemory : IFitsStore
{
    private readonly Block* _block;

    /// <summary>Takes memory.</summary>
    /// <param name="capacity">bytes; CFITSIO takes more if it needs it.</param>
    public FitsMemory(nuint capacity)
    {
        _block = (Block*)NativeMemory.AllocZeroed((nuint)sizeof(Block));

        // CFITSIO takes all of the memory for the file, and looks for units behind the last one: what an earlier file left there would be
        // such a unit.
        _block->Address = NativeMemory.AllocZeroed(capacity);
        _block->Size = capacity;
    }

    public int Open(out CFitsioHandle file, ref int status) =>
        CFitsioNative.ffimem(out file, &_block->Address, &_block->Size, step: 0, &Reallocate, ref status);

    public void CopyTo(Stream destination, long start, long end)
    {
        using UnmanagedMemoryStream bytes = new((byte*)_block->Address + start, end - start);
        bytes.CopyTo(destination, bufferSize: 1 << 20);
    }

    public void Dispose()
    {
        NativeMemory.Free(_block->Address);
        NativeMemory.Free(_block);
    }

    [UnmanagedCallersOnly(CallConvs = [typeof(CallConvCdecl)])]
    private static void* Reallocate(void* address, nuint size)
    {
        try
        {
            return NativeMemory.Realloc(address, size);
        }
        catch (OutOfMemoryException)
        {
            return null; // C's way to say so; CFITSIO reports it
        }
    }

    private struct Block
    {
        public void* Address;
        public nuint Size;
    }
}
