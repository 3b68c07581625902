using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.Cli.Completion;

/// <summary>Makes the completion script for fish.</summary>
internal static class FishCompletion
{
    public static string Script() => $$"""
        # Completion of msis for fish; made by: msis completion fish
        function __msis_in --description 'Whether the words before the cursor call this command of msis'
            set -l words (commandline -opc)
            set -e words[1]
            set -l path
            for word in $words
                set -l next (string trim -- "$path $word")
                contains -- $next {{CompletionScript.CommandPaths(" ")}}; or break
                set path $next
            end
            test "$path" = "$argv[1]"
        end
        complete -c msis -f
        {{string.Join('\n', CommandTable.All.SelectMany(entry => Lines(entry.Path, entry.Command)))}}

        """.ReplaceLineEndings("\n");

    private static IEnumerable<string> Lines(string path, CommandSpec command)
    {
        string start = $"complete -c msis -n \"__msis_in '{path}'\"";
        foreach (CommandSpec inner in command.Commands)
        {
            yield return $"{start} -a {inner.Name} -d {Quoted(inner.Summary.TrimEnd('.'))}";
        }

        if (command.Argument is { } argument)
        {
            yield return argument.Words.Count > 0 ? $"{start} -a '{string.Join(' ', argument.Words)}'" : $"{start} -F";
        }

        foreach (OptionSpec option in command.Options)
        {
            yield return $"{start} {string.Join(' ', option.Aliases.Prepend(option.Name).Select(Name))}{Value(option)} -d "
                + $"{Quoted(option.Help)}";
        }
    }

    private static string Name(string name) => name switch
    {
        _ when name.StartsWith("--", StringComparison.Ordinal) => $"-l {name[2..]}",
        { Length: 2 } => $"-s {Quoted(name[1..])}",
        _ => $"-o {name[1..]}",
    };

    private static string Value(OptionSpec option) => option switch
    {
        { ValueName: null } => string.Empty,
        PathSpec { Kind: PathKind.Folder } => " -x -a '(__fish_complete_directories)'",
        PathSpec => " -r -F",
        { Suggestions.Count: 0 } => " -x",
        { ListSeparator: "," } => $" -x -a '(__fish_append , {string.Join(' ', option.Suggestions)})'",
        _ => $" -x -a '{string.Join(' ', option.Suggestions)}'",
    };

    private static string Quoted(string text) =>
        $"'{text.Replace("\\", "\\\\", StringComparison.Ordinal).Replace("'", "\\'", StringComparison.Ordinal)}'";
}
