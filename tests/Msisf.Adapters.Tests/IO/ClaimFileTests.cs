using Msisf.Adapters.IO;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.IO;

public sealed class ClaimFileTests
{
    [Fact]
    public void TryTake_TakenByAnotherThread_IsRefusedUntilGivenBack()
    {
        using TemporaryFolder folder = new();
        using ClaimFile claims = ClaimFile.Open(Path.Combine(folder.Path, ".claims"));
        Claim? first = claims.TryTake("frame 1");
        Assert.NotNull(first);
        Assert.Equal(!OperatingSystem.IsMacOS(), first.IsExclusive);
        Assert.Null(claims.TryTake("frame 1"));
        using IDisposable? other = claims.TryTake("frame 2");
        Assert.NotNull(other);
        first.Dispose();
        first.Dispose();
        using IDisposable? again = claims.TryTake("frame 1");
        Assert.NotNull(again);
    }

    [Fact]
    public void TryTake_FolderThatIsNotThere_HoldsWithinTheProcess()
    {
        using TemporaryFolder folder = new();
        using ClaimFile claims = ClaimFile.Open(Path.Combine(folder.Path, "none", ".claims"));
        using Claim? first = claims.TryTake("frame 1");
        Assert.NotNull(first);
        Assert.False(first.IsExclusive);
        Assert.Null(claims.TryTake("frame 1"));
    }

    [Fact]
    public void TryTake_ManyNames_LeavesAnEmptyFile()
    {
        using TemporaryFolder folder = new();
        string path = Path.Combine(folder.Path, ".claims");
        using (ClaimFile claims = ClaimFile.Open(path))
        {
            Assert.All(Enumerable.Range(0, 100), index => Assert.NotNull(claims.TryTake($"frame {index}")));
        }

        Assert.Equal(0, new FileInfo(path).Length);
    }
}
