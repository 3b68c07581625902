using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Msisf.Adapters.Interop;

/// <summary>Tells the operating system which mapped memory is not needed for now. Where it takes no such advice, nothing happens.</summary>
internal static unsafe partial class MemoryAdvice
{
    /// <summary>
    /// MADV_DONTNEED of Linux's mman.h: pages of a mapped file leave the process, and are mapped again when they are read.
    /// </summary>
    private const int DoNotNeed = 4;

    /// <summary>Releases pages of a read-only mapping. Other threads may read them meanwhile.</summary>
    /// <param name="start">The mapping's first byte.</param>
    /// <param name="length">Bytes.</param>
    public static void ReleasePages(byte* start, ulong length)
    {
        if (OperatingSystem.IsLinux())
        {
            _ = madvise(start, (nuint)length, DoNotNeed);
        }
    }

    [LibraryImport("libc")]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    private static partial int madvise(void* address, nuint length, int advice);
}
