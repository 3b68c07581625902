using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>What msis view says before it starts anything.</summary>
public class ViewCommandTests
{
    [Theory]
    [InlineData("no-such-folder", "no-such-folder: there is no such file or folder.")]
    [InlineData("--catalogues craters=no-such-file.csv", "no-such-file.csv: there is no such file or folder.")]
    [InlineData("--folders a=.,a=..", "--folders a=..: each part has a name of its own")]
    [InlineData("--folders a=", "--folders a=: each part is a path")]
    [InlineData("--listen 0.0.0.0:0", "can be reached from other computers")]
    public void View_WrongPathsAndAddresses_AreAnErrorOfOneLine(string arguments, string words)
    {
        CommandLineRun run = CommandLineRun.Of(["view", "--no-browser", .. arguments.Split(' ')]);

        Assert.Equal(1, run.ExitCode);
        Assert.Empty(run.Output);
        Assert.Contains(words, run.Error, StringComparison.Ordinal);
        Assert.Single(run.Error.Split('\n', StringSplitOptions.RemoveEmptyEntries));
    }
}
