using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Msisf.Adapters.Interop;

/// <summary>Tells the operating system what mapped memory is not needed for now. Only advice: where it can't be given, nothing happens.</summary>
internal static unsafe partial class MemoryAdvice
{
    /// <summary>MADV_DONTNEED of Linux's mman.h: of a mapped file, pages leave the process; what is read again is mapped again.</summary>
    private const int DoNotNeed = 4;

    /// <summary>Gives pages of a read-only mapping back. Other threads may read them meanwhile.</summary>
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
