using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.Cli.Help;

/// <summary>Prints the help of a command for a terminal of 80 columns.</summary>
internal static class HelpText
{
    /// <summary>Column of the descriptions: names longer than this are followed by a line break.</summary>
    private const int Column = 27;

    /// <summary>Prints the help: of the program itself what most calls need, of other commands all but the options of a run.</summary>
    /// <param name="path">The words by which the command is called; empty for the render command.</param>
    public static void Write(TextWriter output, string path, CommandSpec command) =>
        Print(output, path.Length == 0 ? FirstPage(command) : TakesRun(command) ? WithoutRun(path, command) : Lines(path, command));

    /// <summary>Prints the help with all options.</summary>
    public static void WriteAll(TextWriter output, string path, CommandSpec command) => Print(output, Lines(path, command));

    /// <summary>Prints the options of a topic.</summary>
    public static void WriteTopic(TextWriter output, string topic) => Print(output,
    [
        $"msis: options for {topic}",
        .. ShortHelp.Topics[topic]().SelectMany(GroupLines),
    ]);

    private static void Print(TextWriter output, IEnumerable<string> lines)
    {
        foreach (string line in lines)
        {
            output.WriteLine(line);
        }
    }

    private static IEnumerable<string> FirstPage(CommandSpec command) =>
    [
        $"msis - {command.Summary}",
        .. UsageOf(string.Empty, command).Select((usage, index) => (index == 0 ? "Usage: " : "       ") + usage),
        .. Examples(command),
        string.Empty,
        .. ShortHelp.Tasks.SelectMany(task => task.Options.SelectMany(
            option => Entry($"{option.Option.Name} {option.Value}".TrimEnd(), option.About)).Prepend($"{task.Task}:")),
        string.Empty,
        .. TextLayout.Lines($"Commands: {string.Join(", ", command.Commands.Select(inner => inner.Name))}.", 0),
        .. TextLayout.Lines(
            $"More: msis COMMAND --help; msis help TOPIC ({string.Join(", ", ShortHelp.Topics.Keys)}); msis --help {ShortHelp.All}; "
                + "docs/README.md.", 0),
    ];

    /// <summary>Whether a command has the options of a run beside its own.</summary>
    private static bool TakesRun(CommandSpec command) => command.Groups.Any(group => group.Title == CameraOptions.Group.Title);

    private static IEnumerable<string> WithoutRun(string path, CommandSpec command)
    {
        HashSet<string> ofRun = [.. CommandTable.Render.Groups.Select(group => group.Title)];
        return
        [
            .. Lines(path, command, command.Groups.Where(group => !ofRun.Contains(group.Title))),
            string.Empty,
            .. TextLayout.Lines(
                $"It takes all options of a run too: msis --help has those that matter, msis {path} --help {ShortHelp.All} has all.", 0),
        ];
    }

    /// <summary>The names and value of an option, e.g. "-f, --fov DEGREES".</summary>
    public static string CallOf(OptionSpec option) =>
        string.Join(", ", option.Aliases.Append(option.Name)) + (option.ValueName is null ? string.Empty : $" {option.ValueName}");

    /// <summary>The usage of a command, one line for each form of the call.</summary>
    public static IEnumerable<string> UsageOf(string path, CommandSpec command)
    {
        string call = $"msis {path}".TrimEnd();
        if (command.Commands.Count == 0 || path.Length == 0)
        {
            string argument = command.Argument switch
            {
                null => string.Empty,
                { IsOptional: true } optional => $" [{optional.Name}]",
                { } needed => $" {needed.Name}",
            };
            yield return $"{call}{argument} [OPTIONS]";
        }

        if (command.Commands.Count > 0)
        {
            yield return $"{call} COMMAND [OPTIONS]";
        }
    }

    private static IEnumerable<string> Lines(string path, CommandSpec command) => Lines(path, command, command.Groups);

    private static IEnumerable<string> Lines(string path, CommandSpec command, IEnumerable<OptionGroup> groups) =>
    [
        .. TextLayout.Lines($"{$"msis {path}".TrimEnd()} - {command.Summary}", 0),
        string.Empty,
        .. UsageOf(path, command).Select((usage, index) => (index == 0 ? "Usage: " : "       ") + usage),
        .. command.Details is null ? [] : TextLayout.Lines(command.Details, 0).Prepend(string.Empty),
        .. Examples(command),
        .. command.Argument is { } argument ? Section("Argument", null, Entry(argument.Name, argument.Help)) : [],
        .. groups.SelectMany(GroupLines),
        .. command.Commands.Count > 0
            ? Section(
                "Commands",
                "msis COMMAND --help shows what a command takes.",
                command.Commands.SelectMany(inner => Entry(inner.Name, inner.Summary.TrimEnd('.'))))
            : [],
    ];

    private static IEnumerable<string> Examples(CommandSpec command) => command.Examples.Count == 0
        ? []
        : Section(command.Examples.Count == 1 ? "Example" : "Examples", null, command.Examples.SelectMany(example =>
            TextLayout.Lines(example.Meaning, 2).Concat(TextLayout.CallLines(example.Call, 4))));

    private static IEnumerable<string> GroupLines(OptionGroup group) =>
        Section(group.Title, group.Note, group.Options.SelectMany(OptionLines));

    private static IEnumerable<string> Section(string title, string? note, IEnumerable<string> lines) =>
        [string.Empty, $"{title}:", .. note is null ? [] : TextLayout.Lines(note, 2), .. lines];

    private static IEnumerable<string> OptionLines(OptionSpec option)
    {
        string call = option.Aliases.Count == 0 ? $"    {CallOf(option)}" : CallOf(option);
        return Entry(call, option.Notes.Length == 0 ? option.Help : $"{option.Help} ({option.Notes})");
    }

    private static IEnumerable<string> Entry(string call, string text)
    {
        string[] lines = [.. TextLayout.Lines(text, Column)];
        string left = $"  {call}";
        return left.Length + 2 <= Column ? [left.PadRight(Column) + lines[0].TrimStart(), .. lines[1..]] : [left, .. lines];
    }
}

/// <summary>The ways to ask for help besides --help.</summary>
internal static class HelpWords
{
    /// <summary>
    /// Turns -h into --help where it stands alone, or alone behind a command: -h is the image height (thesis appendix A), which needs a
    /// number. The word behind --help is that of msis help.
    /// </summary>
    public static IReadOnlyList<string> Replace(IReadOnlyList<string> arguments) =>
        arguments.Count > 1 && arguments[^2] == RunOptions.Help.Name && Find(arguments.SkipLast(2)) is not null
            ? [CommandTable.Help.Name, .. arguments.SkipLast(2), arguments[^1]] :
        arguments.Count > 0 && arguments[^1] == "-h" && Find(arguments.SkipLast(1)) is not null
            ? [.. arguments.SkipLast(1), RunOptions.Help.Name]
            : arguments;

    /// <summary>The command of some words, e.g. "ldem", "pyramid"; null if there is none. No word calls the render command.</summary>
    public static CommandSpec? Find(IEnumerable<string> words)
    {
        CommandSpec? command = CommandTable.Render;
        foreach (string word in words)
        {
            command = command?.Commands.FirstOrDefault(inner => inner.Name == word);
        }

        return command;
    }
}
