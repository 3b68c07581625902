using System.CommandLine;

namespace Msisf.Cli.Options;

/// <summary>Makes options whose values stay text: numbers are read by one parser for files and command line alike.</summary>
internal static class OptionFactory
{
    public static Option<string?> Value(string name, string[] aliases, string valueName, string description) =>
        new(name, aliases) { HelpName = valueName, Description = description };

    /// <summary>A value in braces, quoted, or as the separate words that a shell's brace expansion makes of it.</summary>
    public static Option<string[]> Words(string name, string[] aliases, string valueName, string description) =>
        new(name, aliases)
        {
            HelpName = valueName,
            Description = description,
            Arity = ArgumentArity.OneOrMore,
            AllowMultipleArgumentsPerToken = true,
        };

    public static Option<bool> Flag(string name, string[] aliases, string description) =>
        new(name, aliases) { Description = description, Arity = ArgumentArity.Zero };
}
