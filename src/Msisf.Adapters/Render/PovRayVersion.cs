using System.Text.RegularExpressions;
using Msisf.Adapters.Programs;

namespace Msisf.Adapters.Render;

/// <summary>Finds the version of POV-Ray: versions draw differently.</summary>
public static partial class PovRayVersion
{
    /// <summary>The answer of a program that names no version, such as one that stands in for POV-Ray.</summary>
    public const string Unknown = "unknown";

    /// <summary>The highest exit code of a program's own; those of killed programs are higher.</summary>
    private const int LastOwnExitCode = 128;

    private static readonly TimeSpan LongestAnswer = TimeSpan.FromSeconds(60); // over a network file system at its busiest

    /// <summary>Asks the program.</summary>
    /// <param name="program">Its file.</param>
    /// <returns>E.g. "3.7.0.10.unofficial", or <see cref="Unknown"/>.</returns>
    /// <exception cref="PovRayException">
    /// It can't be started, does not answer, or is killed: frames of an unknown version would pass for others.
    /// </exception>
    public static async Task<string> AskAsync(string program)
    {
        try
        {
            ProcessResult result = await new ChildProgram(program, ["--version"]) { TimeLimit = LongestAnswer }
                .RunAsync(CancellationToken.None).ConfigureAwait(false);
            Match version = Number().Match(result.Output + result.Error);
            return version.Success ? version.Groups[1].Value
                : result.ExitCode <= LastOwnExitCode ? Unknown
                : throw new PovRayException(
                    $"{program} --version: was killed by signal {result.ExitCode - LastOwnExitCode}. Run it again.");
        }
        catch (TimeoutException exception)
        {
            throw new PovRayException($"{program} --version: does not answer. Give the path of POV-Ray 3.7 with --pov-path.", exception);
        }
    }

    [GeneratedRegex(@"POV-Ray (?:\w+ )*v?(\d+\.\d+\S*)")]
    private static partial Regex Number();
}
