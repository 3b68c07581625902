using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>
/// The options of msis serve as msis hands them to the server's program: one word "--name=value" for each option that is given, so that
/// the program needs no parser of its own.
/// </summary>
internal static class ServeArguments
{
    /// <summary>The words for the options of a call.</summary>
    public static IReadOnlyList<string> ToWords(OptionValues values, CommandSpec command) =>
        [.. command.Options.SelectMany(option => Words(option, values))];

    private static IEnumerable<string> Words(OptionSpec option, OptionValues values)
    {
        if (values.Words(option) is not { } words)
        {
            return [];
        }

        return option.MayBeRepeated ? words.Select(word => $"{option.Name}={word}") : [$"{option.Name}={values.Text(option)}"];
    }

    /// <summary>The options of the words of <see cref="ToWords"/>.</summary>
    public static OptionValues FromWords(IEnumerable<string> words) => new(words.Select(word => word.Split('=', 2))
        .GroupBy(pair => pair[0], pair => pair[^1])
        .Select(option => KeyValuePair.Create(option.Key, new OptionValue([.. option]))));
}
