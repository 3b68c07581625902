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

    /// <summary>MADV_WILLNEED: the pages are read now, and only they.</summary>
    private const int WillNeed = 3;

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

    /// <summary>
    /// Has the pages of some lines of a mapped file read, unless two of the lines are in memory already. Without it the first access to
    /// a line reads all around it, as far as the system's read-ahead goes: far more than a block of a wide model needs.
    /// </summary>
    /// <param name="first">The first byte of the first line.</param>
    /// <param name="stride">Bytes from line to line.</param>
    /// <param name="lines">Number of lines, at least 1.</param>
    /// <param name="bytes">Bytes of each line, at least 1.</param>
    /// <remarks>
    /// Linux says that all pages are in memory if a file neither belongs to the user nor may be written by them; then nothing is
    /// asked for. Looking first keeps a model that was read before as fast as it was: advice costs 0.5 microseconds a line.
    /// </remarks>
    public static void Prefetch(nint first, long stride, int lines, int bytes)
    {
        // Blocks of vertices share their outermost lines with their neighbours.
        if (!OperatingSystem.IsLinux() || (IsLineInMemory(lines / 4) && IsLineInMemory(3 * lines / 4)))
        {
            return;
        }

        if (stride - bytes < Environment.SystemPageSize)
        {
            Advise(first, StartOf(lines - 1) + bytes);
            return;
        }

        for (int line = 0; line < lines; line++)
        {
            Advise(StartOf(line), StartOf(line) + bytes);
        }

        nint StartOf(int line) => first + (nint)(line * stride);
        bool IsLineInMemory(int line) => IsInMemory(StartOf(line)) && IsInMemory(StartOf(line) + bytes - 1);
    }

    private static void Advise(nint first, nint end)
    {
        nint page = PageOf(first);
        _ = madvise((void*)page, (nuint)(end - page), WillNeed);
    }

    /// <summary>Whether the page of an address is in memory, as far as the system says so.</summary>
    internal static bool IsInMemory(nint address)
    {
        byte isThere = 0;
        return mincore((void*)PageOf(address), 1, &isThere) == 0 && (isThere & 1) != 0;
    }

    private static nint PageOf(nint address) => address & ~((nint)Environment.SystemPageSize - 1);

    [LibraryImport("libc")]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    private static partial int madvise(void* address, nuint length, int advice);

    [LibraryImport("libc")]
    [UnmanagedCallConv(CallConvs = [typeof(CallConvCdecl)])]
    private static partial int mincore(void* address, nuint length, byte* isThere);
}
