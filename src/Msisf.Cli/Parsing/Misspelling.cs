using System.CommandLine;
using System.CommandLine.Parsing;
using Msisf.Adapters.Input;
using Msisf.App.Settings.Specs;

namespace Msisf.Cli.Parsing;

/// <summary>Says what a word of the command line that nothing takes was probably meant to be.</summary>
internal static class Misspelling
{
    /// <summary>The problem with the words that the parser could not match; null if it matched all.</summary>
    /// <param name="line">The parsed command line.</param>
    /// <param name="command">The command of the line.</param>
    public static string? In(ParseResult line, CommandSpec command)
    {
        // A word behind a misspelt option is its value.
        string? word = line.UnmatchedTokens.FirstOrDefault(IsOption) ?? (line.UnmatchedTokens is [var first, ..] ? first : null);
        return word is null ? null : IsOption(word) ? OfOption(word, command) : OfWord(word, IsInPlaceOfCommand(word, line), command);
    }

    /// <summary>The problem with a word that looks like an option.</summary>
    /// <param name="word">The word, e.g. "--rendrer" or "--rendrer=native".</param>
    /// <param name="command">The command that does not have it.</param>
    public static string OfOption(string word, CommandSpec command)
    {
        string name = word.Split('=')[0];
        string[] names = [.. command.Options.SelectMany(option => option.Aliases.Append(option.Name))];
        return name == "-h"
            ? "-h is no option here; --help shows which there are."
            : $"{Shown(name)} is no option{Sentence(NearestName.Question(name, [.. names.Where(IsLong)]))}";
    }

    private static bool IsInPlaceOfCommand(string word, ParseResult line)
    {
        int depth = 0;
        for (SymbolResult? outer = line.CommandResult.Parent; outer is CommandResult; outer = outer.Parent)
        {
            depth++;
        }

        return line.Tokens[depth].Value == word;
    }

    private static string OfWord(string word, bool isInPlaceOfCommand, CommandSpec command) =>
        isInPlaceOfCommand && command.Commands.Count > 0
            ? $"{Shown(word)} is no command{Sentence(NearestName.Question(word, [.. command.Commands.Select(inner => inner.Name)]))}"
            : $"{Shown(word)} belongs to no option. Leave it out, or quote it with the value before it.";

    private static string Sentence(string question) => question.Length > 0 ? question : ".";

    private static string Shown(string word) => IsOption(word) && word.All(char.IsAscii) ? word : NumberText.Shown(word);

    private static bool IsOption(string word) => word.Length > 1 && word[0] == '-';

    private static bool IsLong(string name) => name.StartsWith("--", StringComparison.Ordinal);
}
