using Msisf.App.Settings;

namespace Msisf.Cli.Completion;

/// <summary>
/// Makes the scripts with which shells complete commands, options and values; each script contains all data that it needs.
/// </summary>
internal static class CompletionScript
{
    /// <summary>The names of all commands, each in quotes, e.g. 'ldem pyramid'.</summary>
    /// <param name="separator">Separator between two names.</param>
    public static string CommandPaths(string separator) =>
        string.Join(separator, CommandTable.All.Where(entry => entry.Path.Length > 0).Select(entry => $"'{entry.Path}'"));

    /// <param name="shell">Name of the shell.</param>
    /// <exception cref="UsageException">The shell is not supported.</exception>
    public static string For(string shell) => shell.ToLowerInvariant() switch
    {
        "bash" => BashCompletion.Script(),
        "zsh" => ZshCompletion.Script(),
        "fish" => FishCompletion.Script(),
        _ => throw new UsageException(
            $"'{shell}' is not a shell that msis knows. Give one of {string.Join(", ", CommandTable.Completion.Argument!.Words)}."),
    };
}
