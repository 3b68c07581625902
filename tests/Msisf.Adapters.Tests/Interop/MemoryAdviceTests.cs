using System.IO.MemoryMappedFiles;
using Msisf.Adapters.Interop;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Interop;

public sealed class MemoryAdviceTests : IDisposable
{
    private const long Stride = 4L << 20;
    private const int Lines = 16;

    private readonly string _path = Path.Combine(AppContext.BaseDirectory, $"advice-{Guid.NewGuid():N}.bin");

    public void Dispose() => File.Delete(_path);

    /// <summary>
    /// The pages that must not be there are 2 MB away: the system may read some more than it is asked for. Blocks of vertices share their
    /// outermost lines, so these say nothing about the others.
    /// </summary>
    [OnDiskTheory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task Prefetch_LinesOfAFileThatNobodyHasRead_FetchesTheirPagesOnly(bool areOutermostThere)
    {
        using FileStream stream = new(_path, FileMode.CreateNew, FileAccess.ReadWrite, FileShare.Read);
        stream.SetLength(Lines * Stride);
        using MemoryMappedFile file = MemoryMappedFile.CreateFromFile(
            stream, null, 0, MemoryMappedFileAccess.Read, HandleInheritability.None, leaveOpen: true);
        using MemoryMappedViewAccessor view = file.CreateViewAccessor(0, 0, MemoryMappedFileAccess.Read);
        nint start = view.SafeMemoryMappedViewHandle.DangerousGetHandle();
        Assert.False(IsInMemory(3, 100_000));

        if (areOutermostThere)
        {
            MemoryAdvice.Prefetch(start + 100_000, (Lines - 2) * Stride, lines: 2, bytes: 9000);
        }

        MemoryAdvice.Prefetch(start + 100_000, Stride, Lines - 1, bytes: 9000);

        // The system may still be reading when the call returns.
        await Within.Seconds(60, "the lines' pages", () => Enumerable.Range(0, Lines - 1).All(
            line => IsInMemory(line, 100_000) && IsInMemory(line, 108_999)));
        Assert.All(Enumerable.Range(0, Lines - 1), line => Assert.False(IsInMemory(line, Stride / 2)));
        Assert.False(IsInMemory(Lines - 1, 100_000));

        bool IsInMemory(int line, long place) => MemoryAdvice.IsInMemory(start + (nint)((line * Stride) + place));
    }

    /// <summary>A theory of pages of files: a file in memory has none to fetch, and only Linux tells which are there.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    private sealed class OnDiskTheoryAttribute : TheoryAttribute
    {
        public OnDiskTheoryAttribute()
        {
            bool isOnDisk = OperatingSystem.IsLinux() && new DriveInfo(AppContext.BaseDirectory).DriveFormat != "tmpfs";
            Skip = isOnDisk ? null : "missing: a file system on a disk, of Linux";
        }
    }
}
