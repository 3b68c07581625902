using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary><c>msis serve</c> says what is wrong before anything is started.</summary>
public sealed class ServeCommandTests
{
    [Theory]
    [InlineData("--listen", "0.0.0.0:8810", "msis: error: --listen 0.0.0.0:8810 can be reached from other computers. Add --token-file")]
    [InlineData("--queue", "0", "msis: error: --queue is '0'; a whole number from 1 to 10000 is needed.")]
    [InlineData("--tls-key", "key.pem", "msis: error: --tls-certificate and --tls-key belong together.")]
    public void Run_WrongOption_IsAUsageError(string option, string value, string error)
    {
        CommandLineRun run = CommandLineRun.Of(["serve", option, value]);

        Assert.Equal(1, run.ExitCode);
        Assert.StartsWith(error, run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Run_WithoutTheServersProgram_NamesWhatIsMissing()
    {
        CommandLineRun run = CommandLineRun.Of(["serve"], environment: new() { ["MSISF_SERVER"] = "/nowhere" });

        Assert.Equal(3, run.ExitCode);
        Assert.StartsWith("msis: error: msis-server is not in /nowhere, ", run.Error, StringComparison.Ordinal);
        Assert.Contains("scripts/build.sh", run.Error, StringComparison.Ordinal);
    }
}
