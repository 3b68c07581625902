using Msisf.Adapters.Programs;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Programs;

public sealed class SearchPathTests
{
    [Fact]
    public void Find_InTwoFoldersUnderTwoNames_TakesTheFirstFolder()
    {
        using TemporaryFolder first = new();
        using TemporaryFolder second = new();
        File.WriteAllText(Path.Combine(first.Path, "b"), string.Empty);
        File.WriteAllText(Path.Combine(second.Path, "a"), string.Empty);

        Assert.Equal(Path.Combine(first.Path, "b"), SearchPath.Find($"{first.Path}{Path.PathSeparator}{second.Path}", "a", "b"));
    }

    [Fact]
    public void Find_FolderOfThatName_IsNoProgram()
    {
        using TemporaryFolder folder = new();
        Directory.CreateDirectory(Path.Combine(folder.Path, "a"));

        Assert.Null(SearchPath.Find(folder.Path, "a"));
    }
}
