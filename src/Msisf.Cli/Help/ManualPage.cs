using System.Text;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.Cli.Help;

/// <summary>Makes the manual page msis(1) in roff with the macro package man.</summary>
internal static class ManualPage
{
    /// <summary>The whole page.</summary>
    public static string Text(string version)
    {
        CommandSpec program = CommandTable.Render;
        StringBuilder page = new();
        Line(page, $".TH MSIS 1 \"\" \"msis {Escaped(version)}\" \"Synthetic images of the Moon\"");
        Line(page, ".SH NAME");
        Line(page, $"msis \\- {Escaped(char.ToLowerInvariant(program.Summary[0]) + program.Summary[1..].TrimEnd('.'))}");
        Line(page, ".SH SYNOPSIS");
        foreach ((string path, CommandSpec command) in CommandTable.All.Where(
            entry => entry.Path.Length == 0 || entry.Command.Commands.Count == 0))
        {
            Line(page, $".B {Escaped(HelpText.UsageOf(path, command).First())}");
            Line(page, ".br");
        }

        Line(page, ".SH DESCRIPTION");
        Line(page, Escaped(program.Details!));
        Line(page, ".SH EXAMPLES");
        foreach ((string meaning, string call) in CommandTable.All.SelectMany(entry => entry.Command.Examples))
        {
            Line(page, ".PP");
            Line(page, Escaped(meaning));
            Line(page, ".PP");
            Line(page, ".RS 4\n.nf");
            Line(page, string.Join('\n', TextLayout.CallLines(call, 0).Select(Escaped)));
            Line(page, ".fi\n.RE");
        }

        Line(page, ".SH OPTIONS");
        Groups(page, program.Groups);
        Line(page, ".SH COMMANDS");
        foreach ((string path, CommandSpec command) in CommandTable.All.Where(
            entry => entry.Path.Length > 0 && entry.Command.Commands.Count == 0))
        {
            Line(page, $".SS {Escaped(HelpText.UsageOf(path, command).First())}");
            Line(page, Escaped($"{command.Summary} {command.Details}".TrimEnd()));
            Options(page, command.Options.Where(option => !program.Options.Contains(option)));
        }

        Line(page, ".SH EXIT STATUS");
        foreach ((int code, string meaning) in ExitCodes.All)
        {
            Tagged(page, code.ToString(CultureInfo.InvariantCulture), meaning);
        }

        return page.ToString();
    }

    private static void Groups(StringBuilder page, IEnumerable<OptionGroup> groups)
    {
        foreach (OptionGroup group in groups)
        {
            Line(page, $".SS {Escaped(group.Title)}");
            if (group.Note is not null)
            {
                Line(page, Escaped(group.Note));
            }

            Options(page, group.Options);
        }
    }

    private static void Options(StringBuilder page, IEnumerable<OptionSpec> options)
    {
        foreach (OptionSpec option in options)
        {
            Tagged(page, HelpText.CallOf(option), option.Notes.Length == 0 ? option.Help : $"{option.Help} ({option.Notes})");
        }
    }

    private static void Tagged(StringBuilder page, string tag, string text)
    {
        Line(page, ".TP");
        Line(page, $".B {Escaped(tag)}");
        Line(page, Escaped(text));
    }

    private static void Line(StringBuilder page, string line) => page.Append(line).Append('\n');

    /// <summary>
    /// Escapes a text for roff: hyphens can be copied, and no line begins with a dot or an apostrophe, which would make it a request.
    /// </summary>
    private static string Escaped(string text)
    {
        string escaped = text.Replace("\\", "\\e", StringComparison.Ordinal).Replace("-", "\\-", StringComparison.Ordinal).Replace(
            "'", "\\(aq", StringComparison.Ordinal).Replace("\"", "\\(dq", StringComparison.Ordinal);
        return escaped.StartsWith('.') ? $"\\&{escaped}" : escaped;
    }
}

/// <summary>The exit codes and their meanings, for the manual page and docs/command-line-rules.md.</summary>
internal static class ExitCodes
{
    public static IReadOnlyList<(int Code, string Meaning)> All { get; } =
    [
        (0, "all is well"),
        (1, "wrong, missing or forbidden options; an option's value that is not such a word or number, or out of range"),
        (
            2,
            "a file does not hold what it should, a configuration file too; or values that are right by themselves don't fit the model "
                + "or the machine"),
        (
            3,
            "CSPICE, POV-Ray or the file system failed or is missing; or some images of several failed (they are named, "
                + "the others are complete)"),
        (4, "valid input without an image in it: an empty batch file or interval (an image that misses the Moon is valid)"),
        (5, "status, verify, merge: images are missing, damaged, failed or of other settings"),
        (70, "a bug: please report the message with its stack"),
        (130, "ended by Ctrl-C, SIGTERM or a terminal that went away; finished images are complete, no other files are left"),
    ];
}

/// <summary>Breaks text into lines for a terminal of 80 columns.</summary>
internal static class TextLayout
{
    /// <summary>Maximum length of a line, columns: the last of 80 columns is unused because some terminals break there.</summary>
    public const int Width = 79;

    /// <summary>Breaks a text into indented lines; a word longer than a line gets its own line.</summary>
    /// <param name="text">The text: words separated by blanks.</param>
    /// <param name="indent">Indentation of each line, columns.</param>
    public static IEnumerable<string> Lines(string text, int indent)
    {
        string line = string.Empty;
        foreach (string word in text.Split(' ', StringSplitOptions.RemoveEmptyEntries))
        {
            if (line.Length > 0 && indent + line.Length + 1 + word.Length > Width)
            {
                yield return new string(' ', indent) + line;
                line = string.Empty;
            }

            line = line.Length == 0 ? word : $"{line} {word}";
        }

        yield return new string(' ', indent) + line;
    }

    /// <summary>Breaks a call of the program into lines, each continued by a backslash before an option.</summary>
    /// <param name="indent">Indentation of the first line, columns.</param>
    public static IEnumerable<string> CallLines(string call, int indent)
    {
        const string BeforeOption = " --";
        const int Continuation = 5;
        string line = new(' ', indent);
        foreach (string part in call.Split(BeforeOption).Select((part, index) => index == 0 ? part : BeforeOption + part))
        {
            if (line.Length + part.Length + " \\".Length > Width && line.Length > indent)
            {
                yield return $"{line} \\";
                line = new string(' ', indent + Continuation - 1);
            }

            line += part;
        }

        yield return line;
    }
}
