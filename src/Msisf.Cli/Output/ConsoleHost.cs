using Msisf.App.Host;

namespace Msisf.Cli.Output;

/// <summary>Makes the host of the command-line program: results go to standard output, everything else to standard error.</summary>
internal static class ConsoleHost
{
    /// <summary>Creates the host.</summary>
    /// <param name="results">Standard output.</param>
    /// <param name="error">Standard error.</param>
    /// <param name="standardInput">Opens standard input.</param>
    /// <param name="environment">Gets a variable of the environment.</param>
    public static ProgramHost Create(
        TextWriter results, TextWriter error, Func<TextReader> standardInput, TimeProvider clock, Func<string, string?> environment)
    {
        ResultsWriter output = new(results);
        ConsoleLog log = new(error);
        return new ProgramHost(clock, environment)
        {
            Results = output,
            Log = log,
            Progress = new ProgressDisplay(output, log, clock),
            StandardInput = standardInput,
        };
    }
}
