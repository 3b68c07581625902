using System.CommandLine;
using System.CommandLine.Parsing;
using Msisf.Adapters.Input;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.Cli.Parsing;

/// <summary>Rejects errors that the parser ignores: an option given twice, and options before a command that does not have them.</summary>
internal static class StrayOptions
{
    /// <exception cref="UsageException">An option is given twice, or does not belong to the command.</exception>
    public static void Refuse(ParseResult line, CommandSpec command)
    {
        if (Repeated(line, command) is { } repeated)
        {
            throw new UsageException(repeated);
        }

        foreach (OptionResult option in OptionsOf(line.CommandResult))
        {
            // A value in braces takes all words up to the next option, including a misspelt option. The value of --pov-options may
            // contain words that look like options.
            if (option.Option.Name != PovOptions.MoreOptions.Name
                && option.Tokens.Select(token => token.Value).FirstOrDefault(IsNoValue) is string word)
            {
                throw new UsageException(
                    $"{Misspelling.OfOption(word, command)} It comes where the value of {option.Option.Name} ends.");
            }
        }

        if (line.CommandResult.Children.OfType<ArgumentResult>().SelectMany(argument => argument.Tokens)
            .FirstOrDefault(token => IsNoValue(token.Value)) is { } misspelt)
        {
            throw new UsageException(Misspelling.OfOption(misspelt.Value, command));
        }

        for (SymbolResult? outer = line.CommandResult.Parent; outer is CommandResult before; outer = outer.Parent)
        {
            if (OptionsOf(before).FirstOrDefault() is OptionResult stray)
            {
                throw new UsageException(
                    $"{stray.Option.Name} comes before the command {line.CommandResult.Command.Name}. "
                        + $"Put the command first, and see msis {line.CommandResult.Command.Name} --help for its options.");
            }
        }
    }

    /// <summary>The problem with the first option that is given more than once; null if none is.</summary>
    /// <param name="line">The parsed command line, which may have errors.</param>
    public static string? Repeated(ParseResult line, CommandSpec command) =>
        OptionsOf(line.CommandResult).FirstOrDefault(option => option.IdentifierTokenCount > 1
            && !command.Options.Any(spec => spec.Name == option.Option.Name && spec.MayBeRepeated)) is { } repeated
            ? $"{repeated.Option.Name} is given {repeated.IdentifierTokenCount} times. Give it once"
                + (repeated.IdentifierTokenCount > 2 ? ", and quote a value in braces: the shell may have taken it apart." : ".")
            : null;

    private static bool IsNoValue(string word) =>
        word.StartsWith("--", StringComparison.Ordinal)
        || (word.Length > 1 && word[0] == '-' && char.IsAsciiLetter(word[1]) && !IsNotFiniteByName(word)
            && !IsAxes(word));

    /// <summary>Whether a word is a pair of axes such as -x,+y.</summary>
    private static bool IsAxes(string word) => word.Length > 2 && word[2] == ',';

    /// <summary>
    /// Whether a word such as -Infinity or -NaN is a number that is not finite, for which the number parser has its own error message.
    /// </summary>
    private static bool IsNotFiniteByName(string word) =>
        word.StartsWith("-Inf", StringComparison.OrdinalIgnoreCase) || word.StartsWith("-NaN", StringComparison.OrdinalIgnoreCase);

    private static IEnumerable<OptionResult> OptionsOf(CommandResult command) =>
        command.Children.OfType<OptionResult>().Where(option => !option.Implicit);
}

/// <summary>Says what a word of the command line that nothing takes was probably meant to be.</summary>
internal static class Misspelling
{
    /// <summary>The problem with the words that the parser could not match; null if it matched all.</summary>
    public static string? In(ParseResult line, CommandSpec command)
    {
        // A word behind a misspelt option is its value.
        string? word = line.UnmatchedTokens.FirstOrDefault(IsOption) ?? (line.UnmatchedTokens is [var first, ..] ? first : null);
        return word is null ? null : IsOption(word) ? OfOption(word, command) : OfWord(word, IsInPlaceOfCommand(word, line), command);
    }

    /// <summary>The problem with a word that looks like an option.</summary>
    /// <param name="word">The word, e.g. "--rendrer" or "--rendrer=native".</param>
    public static string OfOption(string word, CommandSpec command)
    {
        string name = word.Split('=')[0];
        string[] names = [.. command.Options.SelectMany(option => option.Aliases.Append(option.Name))];
        return name == "-h"
            ? "-h is not an option here; --help shows which there are."
            : $"{Shown(name)} is not an option{NearestName.Question(name, [.. names.Where(IsLong)], ".")}";
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
            ? $"{Shown(word)} is not a command{NearestName.Question(word, [.. command.Commands.Select(inner => inner.Name)], ".")}"
            : $"{Shown(word)} does not belong to any option. Leave it out, or quote it with the value before it.";

    private static string Shown(string word) => IsOption(word) && word.All(char.IsAscii) ? word : NumberText.Shown(word);

    private static bool IsOption(string word) => word.Length > 1 && word[0] == '-';

    private static bool IsLong(string name) => name.StartsWith("--", StringComparison.Ordinal);
}
