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
        [.. command.Options.Where(option => values.Words(option) is not null).Select(option => $"{option.Name}={values.Text(option)}")];

    /// <summary>The options of the words of <see cref="ToWords"/>.</summary>
    public static OptionValues FromWords(IEnumerable<string> words) => new(words.Select(word => word.Split('=', 2)).Select(
        pair => KeyValuePair.Create(pair[0], new OptionValue([pair[^1]]))));
}
