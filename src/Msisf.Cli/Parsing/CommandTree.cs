using System.CommandLine;
using System.CommandLine.Help;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.Cli.Parsing;

/// <summary>
/// The table of commands as a System.CommandLine tree; option values stay text, so that configuration files and the command line are parsed
/// alike.
/// </summary>
internal sealed class CommandTree
{
    private readonly Dictionary<Command, ParsedCommand> _commands = new(ReferenceEqualityComparer.Instance);

    /// <summary>Builds the tree.</summary>
    /// <param name="showHelp">Prints the help of a command; receives its path, e.g. "ldem pyramid", and the command.</param>
    /// <param name="run">Runs a call; receives a command that has an action.</param>
    public CommandTree(Action<string, CommandSpec> showHelp, Func<CommandSpec, ParseResult, CancellationToken, Task<int>> run)
    {
        Root = (RootCommand)Create(string.Empty, CommandTable.Render, new RootCommand(), run);

        // -h is the image height (thesis appendix A), so it can't stand for --help.
        HelpOption help = Root.Options.OfType<HelpOption>().Single();
        help.Aliases.Remove("-h");
        help.Aliases.Remove("/h");
        help.Action = new ShowHelp(line => showHelp(PathOf(line), SpecOf(line)));
    }

    /// <summary>The root command, which is the program itself.</summary>
    public RootCommand Root { get; }

    /// <summary>The path of a parsed line's command, e.g. "ldem pyramid"; empty for the render command.</summary>
    public string PathOf(ParseResult line) => _commands[line.CommandResult.Command].Path;

    /// <summary>The command of a parsed line.</summary>
    public CommandSpec SpecOf(ParseResult line) => _commands[line.CommandResult.Command].Spec;

    /// <summary>The option values of a parsed line.</summary>
    public OptionValues ValuesOf(ParseResult line)
    {
        ParsedCommand command = _commands[line.CommandResult.Command];
        return new OptionValues(
            command.Options
                .Select(option => KeyValuePair.Create(option.Name, line.GetResult(option)))
                .Where(pair => pair.Value is { Implicit: false })
                .Select(pair => KeyValuePair.Create(pair.Key, new OptionValue([.. pair.Value!.Tokens.Select(token => token.Value)]))),
            command.Argument is null ? null : line.GetValue(command.Argument));
    }

    private Command Create(string path, CommandSpec spec, Command command, Func<CommandSpec, ParseResult, CancellationToken, Task<int>> run)
    {
        Option[] options = [.. spec.Options.Where(option => option != RunOptions.Help && option != RunOptions.Version).Select(OptionOf)];
        Argument<string?>? argument = spec.Argument is { } positional
            ? new Argument<string?>(positional.Name) { Arity = positional.IsOptional ? ArgumentArity.ZeroOrOne : ArgumentArity.ExactlyOne }
            : null;
        foreach (Option option in options)
        {
            command.Options.Add(option);
        }

        if (argument is not null)
        {
            command.Arguments.Add(argument);
        }

        foreach (CommandSpec inner in spec.Commands)
        {
            command.Subcommands.Add(Create($"{path} {inner.Name}".TrimStart(), inner, new Command(inner.Name), run));
        }

        if (spec.Commands.Count == 0 || spec == CommandTable.Render)
        {
            command.SetAction((line, cancellation) => run(spec, line, cancellation));
        }

        _commands.Add(command, new ParsedCommand(path, spec, options, argument));
        return command;
    }

    private static Option OptionOf(OptionSpec spec)
    {
        string[] aliases = [.. spec.Aliases];
        return spec switch
        {
            FlagSpec => new Option<bool>(spec.Name, aliases) { Arity = ArgumentArity.Zero },
            { TakesSeveralWords: true } =>
                new Option<string[]>(spec.Name, aliases) { Arity = ArgumentArity.OneOrMore, AllowMultipleArgumentsPerToken = true },
            _ => new Option<string?>(spec.Name, aliases),
        };
    }

    private sealed record ParsedCommand(string Path, CommandSpec Spec, IReadOnlyList<Option> Options, Argument<string?>? Argument);

    private sealed class ShowHelp(Action<ParseResult> show) : System.CommandLine.Invocation.SynchronousCommandLineAction
    {
        public override bool ClearsParseErrors => true;

        public override int Invoke(ParseResult parseResult)
        {
            show(parseResult);
            return 0;
        }
    }
}
