using Msisf.App.Host;

namespace Msisf.Cli.Output;

/// <summary>The world of a command line: results on standard output, all else on standard error.</summary>
internal static class ConsoleHost
{
    /// <summary>Makes it.</summary>
    /// <param name="results">Standard output.</param>
    /// <param name="error">Standard error.</param>
    /// <param name="standardInput">Opens standard input.</param>
    /// <param name="clock">The time.</param>
    /// <param name="environment">The variables of the environment.</param>
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
