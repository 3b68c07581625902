using System.CommandLine;
using System.Text.RegularExpressions;

namespace Msisf.Cli.Options.Config;

/// <summary>
/// What an option is if nobody gives it, as its help text says it: "(default 40)", or "(default)" for the first of the choices or behind
/// the word.
/// </summary>
internal static partial class DefaultText
{
    /// <summary>The default; "-" where there is none.</summary>
    public static string Of(Option option)
    {
        if (option is Option<bool>)
        {
            return "false";
        }

        Match match = DefaultInHelp().Match(option.Description ?? string.Empty);
        return match switch
        {
            { Success: false } => "-",
            _ when match.Groups["value"].Success => match.Groups["value"].Value,
            _ when option.HelpName!.Contains('|') => option.HelpName.Split('|')[0],
            _ => match.Groups["word"].Value,
        };
    }

    [GeneratedRegex(@"(?<word>\S+) \(default(:? (?<value>.+?))?(?=\)|, |: )")]
    private static partial Regex DefaultInHelp();
}
