using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.Cli.Help;

/// <summary>Prints the help of a command for a terminal of 80 columns.</summary>
internal static class HelpText
{
    /// <summary>Column of the descriptions: names longer than this are followed by a line break.</summary>
    private const int Column = 27;

    /// <summary>Prints the help.</summary>
    /// <param name="path">The words by which the command is called; empty for the render command.</param>
    public static void Write(TextWriter output, string path, CommandSpec command)
    {
        foreach (string line in Lines(path, command))
        {
            output.WriteLine(line);
        }
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

    private static IEnumerable<string> Lines(string path, CommandSpec command) =>
    [
        .. TextLayout.Lines($"{$"msis {path}".TrimEnd()} - {command.Summary}", 0),
        string.Empty,
        .. UsageOf(path, command).Select((usage, index) => (index == 0 ? "Usage: " : "       ") + usage),
        .. command.Details is null ? [] : TextLayout.Lines(command.Details, 0).Prepend(string.Empty),
        .. Examples(command),
        .. command.Argument is { } argument ? Section("Argument", null, Entry(argument.Name, argument.Help)) : [],
        .. command.Groups.SelectMany(group => Section(group.Title, group.Note, group.Options.SelectMany(OptionLines))),
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
    /// number.
    /// </summary>
    public static IReadOnlyList<string> Replace(IReadOnlyList<string> arguments) =>
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
