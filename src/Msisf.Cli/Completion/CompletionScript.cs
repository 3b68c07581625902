using Msisf.App.Settings;
using Msisf.Core.Errors;

namespace Msisf.Cli.Completion;

/// <summary>
/// The scripts that let shells complete commands, options and values; all of it is made from the table, and stands in the script.
/// </summary>
internal static class CompletionScript
{
    /// <summary>All commands by the words that call them, each in quotes: 'ldem pyramid'.</summary>
    /// <param name="separator">Stands between two.</param>
    public static string CommandPaths(string separator) =>
        string.Join(separator, CommandTable.All.Where(entry => entry.Path.Length > 0).Select(entry => $"'{entry.Path}'"));

    /// <summary>The script of a shell.</summary>
    /// <param name="shell">Its name.</param>
    /// <exception cref="UsageException">No script is made for it.</exception>
    public static string For(string shell) => shell switch
    {
        "bash" => BashCompletion.Script(),
        "zsh" => ZshCompletion.Script(),
        "fish" => FishCompletion.Script(),
        _ => throw new UsageException(
            $"'{shell}' is no shell that msis completion knows. Give one of {string.Join(", ", CommandTable.Completion.Argument!.Words)}."),
    };
}
