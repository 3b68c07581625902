using Msisf.Adapters.Cluster;
using Msisf.Adapters.Programs;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Cluster;

public sealed class SlurmProgramTests
{
    private static readonly SlurmProgram Programs = new("/usr/bin:/bin");

    [Fact]
    public async Task CallAsync_Command_GivesWhatItWritesAndItsCode()
    {
        ProcessResult result = await Programs.CallAsync("sh", ["-c", "echo $PATH; echo bad >&2; exit 3"], CancellationToken.None);

        Assert.Equal((3, "/usr/bin:/bin\n", "bad\n"), (result.ExitCode, result.Output, result.Error));
    }

    [Fact]
    public async Task CallAsync_CommandThatIsNotThere_NamesIt()
    {
        Assert.True(Programs.Has("sh"));
        Assert.False(Programs.Has("no-such-command"));
        ExternalPartException error = await Assert.ThrowsAsync<ExternalPartException>(
            () => Programs.CallAsync("no-such-command", [], CancellationToken.None));
        Assert.Equal("no no-such-command on the PATH.", error.Message);
    }
}
