using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Msisf.Adapters.Interop;

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
