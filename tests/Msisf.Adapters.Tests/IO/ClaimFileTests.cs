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
    public void TryTake_TakenByAnotherObjectOnThePath_IsRefusedUntilGivenBack()
    {
        using TemporaryFolder folder = new();
        using ClaimFile one = ClaimFile.Open(folder[".claims"]);
        using ClaimFile two = ClaimFile.Open(Path.Combine(folder.Path, ".", ".claims"));
        Claim? first = one.TryTake("frame 1");
        Assert.NotNull(first);
        Assert.Null(two.TryTake("frame 1"));
        first.Dispose();
        using Claim? second = two.TryTake("frame 1");
        Assert.NotNull(second);
        first.Dispose(); // given back already
        Assert.Null(one.TryTake("frame 1"));
    }

    /// <summary>Two names of one folder are one folder; a link to itself is none, and holds within the process.</summary>
    [Fact]
    public void TryTake_TakenByTheNameOfALink_IsRefused()
    {
        using TemporaryFolder folder = new();
        Directory.CreateDirectory(folder["real/inner"]);
        Directory.CreateSymbolicLink(folder["first"], "real");
        Directory.CreateSymbolicLink(folder["second"], folder["first/inner"]);
        Directory.CreateSymbolicLink(folder["round"], folder["round/x"]);
        using ClaimFile one = ClaimFile.Open(folder["real/inner/.claims"]);
        using ClaimFile two = ClaimFile.Open(folder["second/.claims"]);
        using ClaimFile round = ClaimFile.Open(folder["round/.claims"]);
        using Claim? first = one.TryTake("frame 1");
        Assert.NotNull(first);
        Assert.Null(two.TryTake("frame 1"));
        using Claim? other = round.TryTake("frame 1");
        Assert.NotNull(other);
    }

    [Fact]
    public void Dispose_OneOfTwo_GivesBackItsOwnClaimsOnly()
    {
        using TemporaryFolder folder = new();
        using ClaimFile kept = ClaimFile.Open(folder[".claims"]);
        using Claim? first = kept.TryTake("frame 1");
        ClaimFile closed = ClaimFile.Open(folder[".claims"]);
        Claim? second = closed.TryTake("frame 2");
        Assert.NotNull(second);
        closed.Dispose();
        closed.Dispose();
        second.Dispose();
        using ClaimFile next = ClaimFile.Open(folder[".claims"]);
        Assert.Null(next.TryTake("frame 1"));
        using Claim? taken = next.TryTake("frame 2");
        Assert.NotNull(taken);
        Assert.Throws<ObjectDisposedException>(() => closed.TryTake("frame 3"));
    }

    /// <summary>The system would drop every lock of the process on the file.</summary>
    [RequiresFact(Part.Python)]
    public void Dispose_OneOfTwo_KeepsOtherProcessesOutOfTheOthersClaims()
    {
        using TemporaryFolder folder = new();
        using ClaimFile kept = ClaimFile.Open(folder[".claims"]);
        using Claim? first = kept.TryTake("frame 1");
        ClaimFile.Open(folder[".claims"]).Dispose();
        const string Script = "import fcntl, sys; fcntl.lockf(open(sys.argv[1], 'r+b'), fcntl.LOCK_EX | fcntl.LOCK_NB)";
        ChildRun other = ChildRun.Of(TestParts.Python!, ["-c", Script, folder[".claims"]], folder.Path);

        Assert.Contains("BlockingIOError", other.Error, StringComparison.Ordinal);
        first!.Dispose();
        ChildRun.Of(TestParts.Python!, ["-c", Script, folder[".claims"]], folder.Path).Succeeded();
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
