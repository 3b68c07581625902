using System.CommandLine;
using System.CommandLine.Parsing;
using Msisf.App.Host;
using Msisf.Cli.Commands;
using Msisf.Cli.Options.Config;
using Msisf.Core.Errors;

namespace Msisf.Cli;

/// <summary>From arguments to an exit code; the one place where failures end.</summary>
internal static class CommandLineProgram
{
    /// <summary>A run that the user ended, as shells have it: 128 + SIGINT.</summary>
    private const int ExitCancelled = 130;

    private const int ExitUsage = 1;
    private const int ExitBug = 70;

    /// <summary>Runs one command.</summary>
    /// <param name="arguments">As <c>main</c> gets them.</param>
    /// <param name="host">The world.</param>
    /// <param name="cancellation">Ends the run, as Ctrl-C does.</param>
    public static async Task<int> RunAsync(IReadOnlyList<string> arguments, ProgramHost host, CancellationToken cancellation = default)
    {
        RootCommand root = RenderCommand.Create(host);
        Configuration configuration = new(root, host);
        try
        {
            root.Subcommands.Add(PatternsCommand.Create(host));
            root.Subcommands.Add(LdemCommand.Create(host));
            root.Subcommands.Add(CheckCommand.CreateStatus(host));
            root.Subcommands.Add(CheckCommand.CreateVerify(host));
            root.Subcommands.Add(MergeCommand.Create(host));
            root.Subcommands.Add(BatchConvertCommand.Create(host));
            root.Subcommands.Add(SubmitCommand.Create(host));
            root.Subcommands.Add(ConfigCommand.Create(configuration, host));
            ParseResult line = configuration.Parse(arguments);
            if (line.Errors.Count > 0)
            {
                host.Log.Error($"{string.Join(" ", line.Errors.Select(error => error.Message))} See {HelpCall(line)}.");
                return ExitUsage;
            }

            InvocationConfiguration invocation = new()
            {
                EnableDefaultExceptionHandler = false,
                Output = host.Results,
                ProcessTerminationTimeout = Timeout.InfiniteTimeSpan,
            };
            return await line.InvokeAsync(invocation, cancellation).ConfigureAwait(false);
        }
        catch (OperationCanceledException)
        {
            host.Log.Error("ended by the user; finished frames are complete, no other files are left.");
            return ExitCancelled;
        }
        catch (MsisfException exception)
        {
            host.Log.Error(configuration.WithOrigin(exception.Message));
            return exception.ExitCode;
        }
        catch (Exception exception)
        {
            host.Log.Error(
                $"a bug in msis, please report it with the command line and this text: {exception.GetType().Name}: {exception.Message}");
            host.Log.Raw(exception.StackTrace ?? string.Empty);
            return ExitBug;
        }
    }

    private static string HelpCall(ParseResult line)
    {
        string command = string.Empty;
        for (SymbolResult? result = line.CommandResult; result is CommandResult { Parent: not null } inner; result = inner.Parent)
        {
            command = $"{inner.Command.Name} {command}";
        }

        return $"msis {command}--help";
    }
}
