using Msisf.App.Settings;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.App.Tests.Settings;

public sealed class NamedPathsTests
{
    [Fact]
    public void Read_NamesAndPaths_AreWholePathsByName()
    {
        IReadOnlyDictionary<string, string> paths = Read("--folders earlier=runs/a,/data/b/,c.tab,d=x=y");

        Assert.Equal(["b", "c.tab", "d", "earlier"], paths.Keys.Order(StringComparer.Ordinal));
        Assert.Equal(Path.Combine(Environment.CurrentDirectory, "runs", "a"), paths["earlier"]);
        Assert.Equal("/data/b/", paths["b"]);
        Assert.Equal(Path.Combine(Environment.CurrentDirectory, "x=y"), paths["d"]);
    }

    [Fact]
    public void Read_OptionThatIsNotGiven_IsNone() => Assert.Empty(Read(string.Empty));

    [Theory]
    [InlineData("a=x,a=y", "'a' is none")]
    [InlineData("runs/a,other/a", "'a' is none")]
    [InlineData("=x", "'' is none")]
    [InlineData("a/b=x", "'a/b' is none")]
    [InlineData("a=", "each part is a path")]
    [InlineData("a=x,", "each part is a path")]
    public void Read_NameTwiceOrEmptyPart_IsRefused(string value, string words) =>
        Assert.Contains(words, Assert.Throws<UsageException>(() => Read($"--folders {value}")).Message, StringComparison.Ordinal);

    private static IReadOnlyDictionary<string, string> Read(string words) => NamedPaths.Read(ViewOptions.Folders, Given.Options(words));
}
