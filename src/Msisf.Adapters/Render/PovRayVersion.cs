using System.ComponentModel;
using System.Diagnostics;
using System.Text.RegularExpressions;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Render;

/// <summary>Which POV-Ray it is: versions draw differently.</summary>
public static partial class PovRayVersion
{
    /// <summary>A program that answers something else: one that stands in for POV-Ray.</summary>
    public const string Unknown = "unknown";

    /// <summary>The system's own for a program that it has killed are higher.</summary>
    private const int LastOwnExitCode = 128;

    private static readonly TimeSpan LongestAnswer = TimeSpan.FromSeconds(60); // over a network file system at its busiest

    /// <summary>Asks the program.</summary>
    /// <param name="program">Its file.</param>
    /// <returns>E.g. "3.7.0.10.unofficial", or <see cref="Unknown"/>.</returns>
    /// <exception cref="PovRayException">It can't be started, does not answer, or is killed: frames of an unknown version would pass for others.</exception>
    public static async Task<string> AskAsync(string program)
    {
        ProcessStartInfo start = new(program, ["--version"])
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        using CancellationTokenSource limit = new(LongestAnswer);
        using Process process = new() { StartInfo = start };
        try
        {
            process.Start();
            process.StandardInput.Close();
            Task<string> output = process.StandardOutput.ReadToEndAsync(limit.Token);
            Task<string> error = process.StandardError.ReadToEndAsync(limit.Token);
            Match version = Number().Match(await output.ConfigureAwait(false) + await error.ConfigureAwait(false));
            await process.WaitForExitAsync(limit.Token).ConfigureAwait(false);
            return version.Success ? version.Groups[1].Value
                : process.ExitCode <= LastOwnExitCode ? Unknown
                : throw new PovRayException($"{program} --version: was killed by signal {process.ExitCode - LastOwnExitCode}. Run it again.");
        }
        catch (Exception exception) when (exception is OperationCanceledException or Win32Exception or IOException)
        {
            throw new PovRayException($"{program} --version: {(exception is OperationCanceledException ? "does not answer" : exception.Message)}. Give the path of POV-Ray 3.7 with --pov-path.", exception);
        }
        finally
        {
            End(process);
        }
    }

    private static void End(Process process)
    {
        try
        {
            process.Kill(entireProcessTree: true);
        }
        catch (Exception exception) when (exception is InvalidOperationException or Win32Exception)
        {
            return; // it never started, or has ended
        }
    }

    [GeneratedRegex(@"POV-Ray (?:\w+ )*v?(\d+\.\d+\S*)")]
    private static partial Regex Number();
}
