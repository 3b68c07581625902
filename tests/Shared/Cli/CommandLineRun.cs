using Msisf.App.Host;
using Msisf.Cli;
using Msisf.Cli.Output;

namespace Msisf.TestSupport;

/// <summary>
/// One call of the program, and what came of it: in this process, or, where MSISF_PROGRAM names a built program, of that one.
/// </summary>
internal sealed record CommandLineRun(int ExitCode, string Output, string Error)
{
    /// <summary>Far above what any call here takes, even on a busy machine.</summary>
    private const double LimitSeconds = 600.0;

    /// <summary>Runs the program.</summary>
    /// <exception cref="TimeoutException">It did not end in time; the message has what it was called with.</exception>
    /// <param name="arguments">As <c>main</c> gets them.</param>
    /// <param name="standardInput">What stands on standard input.</param>
    /// <param name="environment">
    /// Variables other than those of the tests. Without XDG_CONFIG_HOME it is a folder that is not there, so that the settings of whoever
    /// runs the tests play no part.
    /// </param>
    public static CommandLineRun Of(
        IReadOnlyList<string> arguments, string standardInput = "", Dictionary<string, string>? environment = null)
    {
        Dictionary<string, string> variables = new(environment ?? []);
        variables.TryAdd("XDG_CONFIG_HOME", "/no-settings");
        if (TestedProgram.Named is { } built)
        {
            ChildRun run = ChildRun.Of(built, arguments, Environment.CurrentDirectory, standardInput, variables);
            return new CommandLineRun(run.ExitCode, run.Output, run.Error);
        }

        using StringWriter output = new();
        using StringWriter error = new();
        string? Variable(string name) => variables.GetValueOrDefault(name) ?? Environment.GetEnvironmentVariable(name);
        ProgramHost host = ConsoleHost.Create(output, error, () => new StringReader(standardInput), TimeProvider.System, Variable);
        int exitCode = Within.Seconds(
            LimitSeconds, $"msis {string.Join(' ', arguments)}", Task.Run(() => CommandLineProgram.RunAsync(arguments, host)))
            .GetAwaiter()
            .GetResult();
        return new CommandLineRun(exitCode, output.ToString(), error.ToString());
    }
}
