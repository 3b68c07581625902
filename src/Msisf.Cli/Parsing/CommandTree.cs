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
    private const string VersionOption = "--version";

    private readonly Dictionary<Command, ParsedCommand> _commands = new(ReferenceEqualityComparer.Instance);
    private readonly IReadOnlyList<string> _arguments;

    /// <summary>Builds the tree; only commands that may be called get their options, because that takes time.</summary>
    /// <param name="arguments">The arguments that it is to parse.</param>
    /// <param name="showHelp">Prints the help of a command; receives its path, e.g. "ldem pyramid", and the command.</param>
    /// <param name="run">Runs a call; receives a command that has an action.</param>
    public CommandTree(
        IReadOnlyList<string> arguments,
        Action<string, CommandSpec> showHelp,
        Func<CommandSpec, ParseResult, CancellationToken, Task<int>> run)
    {
        _arguments = arguments;
        Root = (RootCommand)Create(string.Empty, CommandTable.Render, new RootCommand(), run);

        // -h is the image height (thesis appendix A), so it can't stand for --help.
        HelpOption help = Root.Options.OfType<HelpOption>().Single();
        help.Aliases.Remove("-h");
        help.Aliases.Remove("/h");
        help.Action = new ShowHelp(line => showHelp(PathOf(line), SpecOf(line)));
    }

    public RootCommand Root { get; }

    /// <summary>The path of a parsed line's command, e.g. "ldem pyramid"; empty for the render command.</summary>
    public string PathOf(ParseResult line) => _commands[line.CommandResult.Command].Path;

    public CommandSpec SpecOf(ParseResult line) => _commands[line.CommandResult.Command].Spec;

    public OptionValues ValuesOf(ParseResult line)
    {
        ParsedCommand command = _commands[line.CommandResult.Command];
        string[] words = command.Argument is not null && line.GetResult(command.Argument) is { } given
            ? [.. given.Tokens.Select(token => token.Value)]
            : [];
        return new OptionValues(
            command.Options
                .Select(option => KeyValuePair.Create(option.Name, line.GetResult(option)))
                .Where(pair => pair.Value is { Implicit: false })
                .Select(pair => KeyValuePair.Create(pair.Key, new OptionValue([.. pair.Value!.Tokens.Select(token => token.Value)]))),
            words.Length > 0 ? string.Join(' ', words) : null,
            words);
    }

    private Command Create(string path, CommandSpec spec, Command command, Func<CommandSpec, ParseResult, CancellationToken, Task<int>> run)
    {
        bool mayBeCalled = MayBeCalled(path);
        Option[] options = mayBeCalled ? [.. spec.Options.Where(IsNotOfTheParser).Select(OptionOf)] : [];
        Argument? argument = mayBeCalled && spec.Argument is { } positional ? ArgumentOf(positional) : null;
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

        if (spec.Commands.Count == 0 || ReferenceEquals(spec, CommandTable.Render))
        {
            command.SetAction((line, cancellation) => run(spec, line, cancellation));
        }

        _commands.Add(command, new ParsedCommand(path, spec, options, argument));
        return command;
    }

    /// <summary>
    /// Whether the arguments may call a command: all of its words are among them; for the render command, the first one is not an other
    /// command, and more is asked for than the version.
    /// </summary>
    private bool MayBeCalled(string path) =>
        _arguments.Any(argument => argument.StartsWith('@')) // a file of arguments may name any command
        || (path.Length == 0
            ? _arguments.Count == 0
                || !(_arguments is [VersionOption] || CommandTable.Render.Commands.Any(command => command.Name == _arguments[0]))
            : path.Split(' ').All(_arguments.Contains));

    /// <summary>System.CommandLine has the options --help and --version itself.</summary>
    private static bool IsNotOfTheParser(OptionSpec option) =>
        !ReferenceEquals(option, RunOptions.Help) && !ReferenceEquals(option, RunOptions.Version);

    private static Argument ArgumentOf(ArgumentSpec spec) => spec.TakesSeveralWords
        ? new Argument<string[]>(spec.Name) { Arity = ArgumentArity.ZeroOrMore }
        : new Argument<string?>(spec.Name) { Arity = spec.IsOptional ? ArgumentArity.ZeroOrOne : ArgumentArity.ExactlyOne };

    private static Option OptionOf(OptionSpec spec)
    {
        string[] aliases = [.. spec.Aliases];
        return spec switch
        {
            FlagSpec => new Option<bool>(spec.Name, aliases) { Arity = ArgumentArity.Zero },
            { TakesSeveralWords: true } =>
                new Option<string[]>(spec.Name, aliases) { Arity = ArgumentArity.OneOrMore, AllowMultipleArgumentsPerToken = true },
            { MayBeRepeated: true } => new Option<string[]>(spec.Name, aliases) { Arity = ArgumentArity.OneOrMore },
            TextSpec { ValueIfBare: not null } => new Option<string?>(spec.Name, aliases) { Arity = ArgumentArity.ZeroOrOne },
            _ => new Option<string?>(spec.Name, aliases),
        };
    }

    private sealed record ParsedCommand(string Path, CommandSpec Spec, IReadOnlyList<Option> Options, Argument? Argument);

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
