using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.Cli.Completion;

/// <summary>Makes the completion script for zsh.</summary>
internal static class ZshCompletion
{
    /// <summary>The whole script; it can be sourced or stored as _msis in a folder of $fpath.</summary>
    public static string Script() => $$"""
        #compdef msis
        # Completion of msis for zsh; made by: msis completion zsh
        _msis() {
            # The command comes first.
            local command= next
            while (( CURRENT > 2 )); do
                next="$command${command:+ }$words[2]"
                case $next in
                    {{CompletionScript.CommandPaths(" | ")}}) command=$next ;;
                    *) break ;;
                esac
                shift words
                (( CURRENT-- ))
            done

            case $command in
        {{string.Join('\n', CommandTable.All.Select(entry => Command(entry.Path, entry.Command)))}}
            esac
        }
        if [[ $funcstack[1] == _msis ]]; then
            _msis "$@"
        else
            compdef _msis msis
        fi

        """.ReplaceLineEndings("\n");

    private static string Command(string path, CommandSpec command)
    {
        IEnumerable<string> specs = command.Options.SelectMany(Specs);
        if (command.Commands.Count > 0)
        {
            IEnumerable<string> choices = command.Commands.Select(
                inner => $"{inner.Name}\\:\"{Escaped(inner.Summary.TrimEnd('.'))}\"");
            specs = specs.Append(Quoted($"1:command:(({string.Join(' ', choices)}))"));
        }
        else if (command.Argument is { } argument)
        {
            specs = specs.Append(
                Quoted($"1:{argument.Name}:{(argument.Words.Count > 0 ? $"({string.Join(' ', argument.Words)})" : "_files")}"));
        }

        return $"        '{path}') _arguments {string.Join(' ', specs)} ;;";
    }

    /// <summary>The specifications of an option's names, which exclude each other.</summary>
    private static IEnumerable<string> Specs(OptionSpec option)
    {
        string[] names = [option.Name, .. option.Aliases];
        string value = option.ValueName is { } name ? $":{Escaped(name)}:{Action(option)}" : string.Empty;
        string EqualsSign(string called) =>
            option.ValueName is not null && called.StartsWith("--", StringComparison.Ordinal) ? "=" : string.Empty;
        return names.Select(
            called => Quoted($"({string.Join(' ', names)}){called}{EqualsSign(called)}[{Escaped(option.Help)}]{value}"));
    }

    private static string Action(OptionSpec option) => option switch
    {
        PathSpec { Kind: PathKind.Folder } => "_files -/",
        PathSpec => "_files",
        { Suggestions.Count: 0 } => " ",
        { ListSeparator: "," } => $"_values -s , {option.Key} {string.Join(' ', option.Suggestions)}",
        _ => $"({string.Join(' ', option.Suggestions)})",
    };

    /// <summary>Escapes the characters with a special meaning in the specifications of _arguments.</summary>
    private static string Escaped(string text) => text
        .Replace(
            "\\",
            "\\\\",
            StringComparison.Ordinal).Replace("[", "\\[", StringComparison.Ordinal).Replace("]", "\\]", StringComparison.Ordinal)
        .Replace(":", "\\:", StringComparison.Ordinal).Replace("\"", "\\\"", StringComparison.Ordinal);

    private static string Quoted(string text) => $"'{text.Replace("'", "'\\''", StringComparison.Ordinal)}'";
}
