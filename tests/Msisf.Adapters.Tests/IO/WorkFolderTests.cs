using Msisf.Adapters.IO;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.IO;

public sealed class WorkFolderTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Dispose_FolderWithFiles_IsGone()
    {
        using (WorkFolder work = WorkFolder.In(_folder.Path))
        {
            File.WriteAllText(Path.Combine(work.Path, "image.png"), "x");
            Directory.CreateDirectory(Path.Combine(work.Path, "inner"));
            File.WriteAllText(Path.Combine(work.Path, "inner", "lock"), "x");
        }

        Assert.Empty(Directory.EnumerateFileSystemEntries(_folder.Path));
    }

    [Fact]
    public void RemoveStale_LockIsFree_RemovesTheFolderAndNothingElse()
    {
        Directory.CreateDirectory(_folder[".msis-1-killed"]);
        File.WriteAllText(_folder[".msis-1-killed/lock"], string.Empty);
        Directory.CreateDirectory(_folder[".msis-2-killed-before-it-had-a-lock"]);
        Directory.CreateDirectory(_folder["msis-mine"]);
        File.WriteAllText(_folder["msis-mine/lock"], string.Empty);

        Assert.Equal(2, WorkFolder.RemoveStale(_folder.Path));

        Assert.Equal(["msis-mine"], Directory.EnumerateDirectories(_folder.Path).Select(Path.GetFileName));
    }

    [Fact]
    public void RemoveStale_FolderInUse_Stays()
    {
        using WorkFolder work = WorkFolder.In(_folder.Path);

        Assert.Equal(0, WorkFolder.RemoveStale(_folder.Path));

        Assert.True(Directory.Exists(work.Path));
    }

    /// <summary>A folder that is just being made looks like remains, until it is locked.</summary>
    [Fact]
    public async Task In_OthersRemoveRemainsMeanwhile_EachFolderIsThereAndLocked()
    {
        using CancellationTokenSource stop = new();
        Task[] others = [.. Enumerable.Range(0, 2).Select(_ => Task.Run(() =>
        {
            while (!stop.IsCancellationRequested)
            {
                WorkFolder.RemoveStale(_folder.Path);
            }
        }))];
        for (int i = 0; i < 200; i++)
        {
            using WorkFolder work = WorkFolder.In(_folder.Path);
            Assert.True(Directory.Exists(work.Path));
        }

        await stop.CancelAsync();
        await Within.Seconds(60, "the end of those who remove remains", Task.WhenAll(others));
        Assert.Empty(Directory.EnumerateFileSystemEntries(_folder.Path));
    }
}
