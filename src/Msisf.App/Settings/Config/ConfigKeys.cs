using Msisf.Adapters.Input;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings.Config;

/// <summary>
/// The keys that a configuration file may contain: the long names of all options, except options that apply to one call only.
/// </summary>
internal static class ConfigKeys
{
    private static readonly Dictionary<string, OptionSpec> Keys = new(StringComparer.Ordinal);
    private static readonly Dictionary<string, string> Refused = new(StringComparer.Ordinal);

    static ConfigKeys()
    {
        foreach (IGrouping<string, OptionSpec> same in CommandTable.All.SelectMany(
            command => command.Command.Options).GroupBy(option => option.Key))
        {
            if (ReasonAgainst([.. same]) is { } reason)
            {
                Refused.Add(same.Key, reason);
            }
            else
            {
                Keys.Add(same.Key, same.First());
            }
        }
    }

    /// <summary>The option of each key, in the order of the help text.</summary>
    public static IEnumerable<OptionSpec> Allowed => Keys.Values;

    /// <summary>Whether an option may be set in a configuration file.</summary>
    public static bool Allows(OptionSpec option) => Keys.ContainsKey(option.Key);

    /// <summary>Gets the option of a key, and its value as it would be typed on the command line.</summary>
    /// <param name="fileName">Name of the file, for messages.</param>
    /// <param name="isOfRun">Whether all options are those of a run, so that no key means another thing with another command.</param>
    /// <exception cref="BadInputException">There is no such key, or it can't have this value.</exception>
    public static (OptionSpec Option, string Text) Read(ConfigEntry entry, string fileName, bool isOfRun = false)
    {
        OptionSpec? ofRun = isOfRun
            ? CommandTable.OptionsOfRun.FirstOrDefault(known => known.Key == entry.Key && ReasonAgainst([known]) is null)
            : null;
        string place = $"{fileName}, line {entry.Line}, column {entry.Column}: ";
        if (ofRun is null && Refused.TryGetValue(entry.Key, out string? reason))
        {
            throw new BadInputException(
                $"{place}'{entry.Key}' can't be in a configuration file: it {reason}. Give it on the command line.");
        }

        if ((ofRun ?? Keys.GetValueOrDefault(entry.Key)) is not { } option)
        {
            throw new BadInputException(
                $"{place}{NumberText.Shown(entry.Key)} is not an option{Hint(entry.Key)} "
                    + "'msis config show' lists all.");
        }

        if (entry.IsList)
        {
            return option.ListSeparator is { } separator
                ? (option, string.Join(separator, entry.Values))
                : throw new BadInputException($"{place}'{entry.Key}' takes one value, not a list. Leave the brackets or the dashes out.");
        }

        string value = option is FlagSpec ? entry.Values[0].ToLowerInvariant() : entry.Values[0];
        return option is not FlagSpec || value is "true" or "false"
            ? (option, value)
            : throw new BadInputException($"{place}'{entry.Key}' is {NumberText.Shown(entry.Values[0])}; true or false is needed.");
    }

    private static string Hint(string key) =>
        NearestName.Question(key.TrimStart('-'), Keys.Keys, ".");

    private static string? ReasonAgainst(OptionSpec[] same) => same switch
    {
        _ when CameraOptions.Group.Options.Contains(same[0]) => "says where the camera is, or when",
        _ when same.Any(option => option.IsOfOneCall) => "belongs to one call",
        _ when same.Select(option => option.ValueName).Distinct().Count() > 1 => "means another thing with each command",
        _ => null,
    };
}
