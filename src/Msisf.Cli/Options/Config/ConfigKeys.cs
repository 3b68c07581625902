using System.CommandLine;
using System.CommandLine.Help;
using Msisf.Adapters.Input;
using Msisf.Core.Errors;

namespace Msisf.Cli.Options.Config;

/// <summary>
/// What may stand in a configuration file: the long names of the commands' options, but for those that belong to one call.
/// </summary>
internal sealed class ConfigKeys
{
    private const string OfOneCall = "belongs to one call. Give it on the command line";

    private static readonly string[] OptionsOfOneCall =
    [
        "config", "for-batch", "frame-times", "frames", "frames-per-piece", "list-patterns", "overwrite", "pieces", "print-frames",
        "script", "verify", "wait",
    ];

    private static readonly string[] NamesOfPaths = ["DIR", "FILE", "FOLDER", "PATH"];

    private readonly Dictionary<string, Option> _allowed = new(StringComparer.Ordinal);
    private readonly Dictionary<string, string> _refused = new(StringComparer.Ordinal);

    /// <summary>Collects the options of all commands.</summary>
    public ConfigKeys(Command root)
    {
        string[] places = [.. new ModeOptions().All.Select(KeyOf)];
        foreach (IGrouping<string, Option> same in OptionsBelow(root).GroupBy(KeyOf))
        {
            if (places.Contains(same.Key))
            {
                _refused.Add(same.Key, "says where the camera is, or when. Give it on the command line");
            }
            else if (OptionsOfOneCall.Contains(same.Key))
            {
                _refused.Add(same.Key, OfOneCall);
            }
            else if (same.Select(option => option.HelpName).Distinct().Count() > 1)
            {
                _refused.Add(same.Key, "means another thing with each command. Give it on the command line");
            }
            else
            {
                _allowed.Add(same.Key, same.First());
            }
        }
    }

    /// <summary>An option for each key, in the order in which the commands declare them.</summary>
    public IEnumerable<Option> Allowed => _allowed.Values;

    /// <summary>The key of an option.</summary>
    public static string KeyOf(Option option) => option.Name.TrimStart('-');

    /// <summary>Whether an option may stand in a file.</summary>
    public bool Allows(Option option) => _allowed.ContainsKey(KeyOf(option));

    /// <summary>Whether the value is a path, which is relative to the file that it stands in.</summary>
    public bool IsPath(string key) => NamesOfPaths.Contains(_allowed[key].HelpName);

    /// <summary>What the option's text is on the command line.</summary>
    /// <param name="entry">The key and its values.</param>
    /// <param name="fileName">For messages.</param>
    /// <exception cref="BadInputException">No key, or not with such a value.</exception>
    public string TextOf(ConfigEntry entry, string fileName)
    {
        string place = $"{fileName}, line {entry.Line}, column {entry.Column}: ";
        if (_refused.TryGetValue(entry.Key, out string? reason))
        {
            throw new BadInputException($"{place}'{entry.Key}' can't stand in a configuration file: it {reason}.");
        }

        if (!_allowed.TryGetValue(entry.Key, out Option? option))
        {
            throw new BadInputException(
                $"{place}{NumberText.Shown(entry.Key)} is no option. The nearest one is '{NearestName.To(entry.Key, _allowed.Keys)}'; "
                    + $"'msis config show' lists all.");
        }

        if (entry.IsList)
        {
            return SeparatorOf(option) is string separator
                ? string.Join(separator, entry.Values)
                : throw new BadInputException($"{place}'{entry.Key}' takes one value, not a list. Leave the brackets or the dashes out.");
        }

        return option is not Option<bool> || entry.Values[0] is "true" or "false"
            ? entry.Values[0]
            : throw new BadInputException($"{place}'{entry.Key}' is {NumberText.Shown(entry.Values[0])}; true or false is needed.");
    }

    /// <summary>What stands between the words of an option that takes several.</summary>
    private static string? SeparatorOf(Option option) => option.HelpName switch
    {
        "TEXT" => " ",
        string name when name.Split('|').Contains("LIST") => ",",
        _ => null,
    };

    private static IEnumerable<Option> OptionsBelow(Command command) =>
        command.Options.Where(option => option is not (HelpOption or VersionOption)).Concat(command.Subcommands.SelectMany(OptionsBelow));
}
