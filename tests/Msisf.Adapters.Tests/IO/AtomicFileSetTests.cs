using Msisf.Adapters.IO;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.IO;

public sealed class AtomicFileSetTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Commit_TwoFiles_ReplacesBothAndLeavesNoOther()
    {
        File.WriteAllText(_folder["a"], "old");
        using (AtomicFileSet files = new())
        {
            files.WriteText(_folder["a"], writer => writer.WriteLine("new"));
            files.WriteText(_folder["b"], writer => writer.Write("two"));
            Assert.Equal("old", File.ReadAllText(_folder["a"]));
            files.Commit();
        }

        Assert.Equal("new\n", File.ReadAllText(_folder["a"]));
        Assert.Equal("two", File.ReadAllText(_folder["b"]));
        Assert.Equal(2, Directory.GetFiles(_folder.Path).Length);
    }

    [Fact]
    public void Dispose_SecondFileFails_LeavesTheFirstAsItWas()
    {
        File.WriteAllText(_folder["a"], "old");
        using (AtomicFileSet files = new())
        {
            files.WriteText(_folder["a"], writer => writer.Write("new"));
            Assert.Throws<InvalidOperationException>(() => files.Write(_folder["b"], _ => throw new InvalidOperationException()));
        }

        Assert.Equal("old", File.ReadAllText(_folder["a"]));
        Assert.Single(Directory.GetFiles(_folder.Path));
    }
}
