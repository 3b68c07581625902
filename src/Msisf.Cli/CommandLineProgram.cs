using System.CommandLine;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Config;
using Msisf.App.Settings.Specs;
using Msisf.Cli.Commands;
using Msisf.Cli.Help;
using Msisf.Cli.Parsing;

namespace Msisf.Cli;

/// <summary>Runs the program from its arguments to its exit code; all exceptions are caught here.</summary>
internal sealed class CommandLineProgram
{
    /// <summary>Exit code of a run that the user cancelled, by the convention of shells: 128 + SIGINT.</summary>
    private const int ExitCancelled = 130;

    private const int ExitUsage = 1;
    private const int ExitBug = 70;

    private readonly ProgramHost _host;
    private readonly IReadOnlyList<string> _arguments;
    private readonly CommandTree _tree;
    private OptionValues _values = new([]);

    private CommandLineProgram(IReadOnlyList<string> arguments, ProgramHost host)
    {
        _host = host;
        _arguments = HelpWords.Replace(arguments);
        _tree = new CommandTree(_arguments, (path, command) => HelpText.Write(host.Results, path, command), RunAsync);
    }

    /// <param name="arguments">Arguments as passed to <c>main</c>.</param>
    public static async Task<int> RunAsync(IReadOnlyList<string> arguments, ProgramHost host, CancellationToken cancellation = default)
    {
        CommandLineProgram program = new(arguments, host);
        try
        {
            return await program.RunAsync(cancellation).ConfigureAwait(false);
        }
        catch (OperationCanceledException)
        {
            host.Log.Error("ended by the user; finished frames are complete, no other files are left.");
            return ExitCancelled;
        }
        catch (MsisfException exception)
        {
            host.Log.Error(program._values.MessageOf(exception));
            return program._values.ExitCodeOf(exception);
        }
        catch (Exception exception)
        {
            host.Log.Error(
                $"a bug in msis, please report it with the command line and this text: {exception.GetType().Name}: {exception.Message}");
            host.Log.Raw(exception.StackTrace ?? string.Empty);
            return ExitBug;
        }
    }

    private async Task<int> RunAsync(CancellationToken cancellation)
    {
        ParseResult line = _tree.Root.Parse([.. _arguments], new ParserConfiguration { ResponseFileTokenReplacer = ResponseFile.TryRead });
        if (line.Errors.Count > 0)
        {
            string problem = StrayOptions.Repeated(line, _tree.SpecOf(line))
                ?? Misspelling.In(line, _tree.SpecOf(line))
                ?? string.Join(" ", line.Errors.Select(error => error.Message));
            _host.Log.Error($"{problem} {HelpHint(line)}");
            return ExitUsage;
        }

        InvocationConfiguration invocation = new()
        {
            EnableDefaultExceptionHandler = false,
            Output = _host.Results,
            ProcessTerminationTimeout = Timeout.InfiniteTimeSpan,
        };
        return await line.InvokeAsync(invocation, cancellation).ConfigureAwait(false);
    }

    private Task<int> RunAsync(CommandSpec command, ParseResult line, CancellationToken cancellation)
    {
        if (line.Tokens.Count == 0)
        {
            HelpText.Write(_host.Results, string.Empty, command);
            return Task.FromResult(0);
        }

        StrayOptions.Refuse(line, command);
        _values = LookOptions.Behind(Configuration.Behind(LookOptions.Behind(_tree.ValuesOf(line)), command, _host));
        if (command.Options.FirstOrDefault(option => option.IsRequired && _values.Text(option) is null) is { } missing)
        {
            throw new UsageException($"{missing.Name} is required. {HelpHint(line)}");
        }

        return CommandActions.Of(command)(new CommandCall(_values, [.. line.Tokens.Select(token => token.Value)], _host), cancellation);
    }

    private string HelpHint(ParseResult line) => $"See {$"msis {_tree.PathOf(line)}".TrimEnd()} --help.";
}
