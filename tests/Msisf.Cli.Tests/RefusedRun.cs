using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>A run that must end with its exit code and one line of error, without a stack and without a file.</summary>
internal static class RefusedRun
{
    /// <summary>Runs and checks.</summary>
    /// <param name="folder">Empty; stays so.</param>
    /// <param name="arguments">Without the folder of the outputs.</param>
    /// <param name="exitCode">Expected.</param>
    /// <param name="message">Part of the line.</param>
    public static void Check(TemporaryFolder folder, string[] arguments, int exitCode, string message)
    {
        CommandLineRun run = CommandLineRun.Of(WithOutputFolder(folder, arguments));

        Assert.True(exitCode == run.ExitCode, $"exit code {run.ExitCode}, expected {exitCode}: {run.Error}");
        string error = Assert.Single(
            run.Error.Split('\n', StringSplitOptions.RemoveEmptyEntries),
            line => line.StartsWith("msis: error: ", StringComparison.Ordinal));
        Assert.Contains(message, error, StringComparison.Ordinal);
        Assert.DoesNotContain("   at ", run.Error, StringComparison.Ordinal);
        Assert.Empty(Directory.EnumerateFileSystemEntries(folder.Path));
    }

    /// <summary>Adds a folder of outputs that is not there yet, where that makes sense.</summary>
    public static string[] WithOutputFolder(TemporaryFolder folder, string[] arguments) =>
        arguments.Contains("patterns") || arguments.Contains("ldem") || arguments[0].StartsWith('@') || arguments.Length < 2
            ? arguments
            : [.. arguments, "--output-dir", folder["new"]];
}
