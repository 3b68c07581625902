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
        if (TestedProgram.Named is not { } built)
        {
            return InThisProcess(arguments, standardInput, environment);
        }

        ChildRun run = ChildRun.Of(built, arguments, Environment.CurrentDirectory, standardInput, Variables(environment));
        return new CommandLineRun(run.ExitCode, run.Output, run.Error);
    }

    /// <summary>Runs the program in this process, whatever MSISF_PROGRAM names; otherwise as <see cref="Of"/>.</summary>
    public static CommandLineRun InThisProcess(
        IReadOnlyList<string> arguments, string standardInput = "", Dictionary<string, string>? environment = null)
    {
        Dictionary<string, string> variables = Variables(environment);
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

    private static Dictionary<string, string> Variables(Dictionary<string, string>? given)
    {
        Dictionary<string, string> variables = new(given ?? []);
        variables.TryAdd("XDG_CONFIG_HOME", "/no-settings");
        return variables;
    }
}
