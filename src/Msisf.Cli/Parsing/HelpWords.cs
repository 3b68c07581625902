using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.Cli.Parsing;

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
