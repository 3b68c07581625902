using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.Cli.Completion;

/// <summary>Makes the completion script for bash.</summary>
internal static class BashCompletion
{
    public static string Script() => $$"""
        # Completion of msis for bash; made by: msis completion bash
        _msis() {
            local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} command= words= last
            COMPREPLY=()

            # bash takes "--option=value" for three words.
            if [[ $cur == = ]]; then
                cur=
            elif [[ $prev == = ]]; then
                prev=${COMP_WORDS[COMP_CWORD - 2]}
            fi

            # The command comes first, one of two words at most.
            local i path
            for ((i = 1; i < COMP_CWORD && i < 3; i++)); do
                path=$command${command:+ }${COMP_WORDS[i]}
                case $path in
                    {{CompletionScript.CommandPaths(" | ")}}) command=$path ;;
                    *) break ;;
                esac
            done

            case "$command:$prev" in
        {{string.Join('\n', Values())}}
            esac

            case $command in
        {{string.Join('\n', CommandTable.All.Select(entry => Command(entry.Path, entry.Command)))}}
            esac
            if [[ $cur != -* && -z $words ]]; then
                compopt -o filenames 2>/dev/null
                COMPREPLY=($(compgen -f -- "$cur"))
            else
                COMPREPLY=($(compgen -W "$words" -- "$cur"))
            fi
        }
        complete -F _msis msis

        """.ReplaceLineEndings("\n");

    /// <summary>
    /// The case branches that complete option values; an option whose values are the same in all commands has one branch for all of them.
    /// </summary>
    private static IEnumerable<string> Values()
    {
        var options = CommandTable.All.SelectMany(
            entry =>
                entry.Command.Options.Select(option => (entry.Path, Option: option))).Where(entry => entry.Option.ValueName is not null);
        foreach (var same in options.GroupBy(entry => entry.Option.Name))
        {
            bool isOne = same.Select(entry => Action(entry.Option)).Distinct().Count() == 1;
            foreach ((string path, OptionSpec option) in isOne ? same.Take(1) : same)
            {
                string command = isOne ? "*" : $"'{path}'";
                yield return $"        {string.Join(" | ", option.Aliases.Append(option.Name).Select(name => $"{command}:{name}"))}) "
                    + $"{Action(option)} ;;";
            }
        }
    }

    private static string Action(OptionSpec option) => option switch
    {
        PathSpec { Kind: PathKind.Folder } => "compopt -o filenames 2>/dev/null; COMPREPLY=($(compgen -d -- \"$cur\")); return",
        PathSpec => "compopt -o filenames 2>/dev/null; COMPREPLY=($(compgen -f -- \"$cur\")); return",
        { Suggestions.Count: 0 } => "return",
        { ListSeparator: "," } => $"last=${{cur##*,}}; COMPREPLY=($(compgen -P \"${{cur%\"$last\"}}\" -W "
            + $"'{string.Join(' ', option.Suggestions)}' -- \"$last\")); return",
        _ => $"COMPREPLY=($(compgen -W '{string.Join(' ', option.Suggestions)}' -- \"$cur\")); return",
    };

    /// <summary>
    /// The case branch of one command with the words that are possible where no option value is expected: options, subcommands, or values
    /// of the argument.
    /// </summary>
    private static string Command(string path, CommandSpec command)
    {
        string others = string.Join(' ', command.Commands.Select(inner => inner.Name).Concat(command.Argument?.Words ?? []));
        string options = string.Join(' ', command.Options.SelectMany(option => option.Aliases.Append(option.Name)));
        return $"        '{path}') if [[ $cur == -* ]]; then words='{options}'; else words='{others}'; fi ;;";
    }
}
