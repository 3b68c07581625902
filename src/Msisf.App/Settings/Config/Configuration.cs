using Msisf.App.Host;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings.Config;

/// <summary>Adds the values of the configuration files to a command line, which takes precedence.</summary>
internal static class Configuration
{
    /// <summary>The options of a call together with those of the configuration files.</summary>
    /// <exception cref="BadInputException">A file has an error, or the file of <c>--config</c> does not exist.</exception>
    public static OptionValues Behind(OptionValues line, CommandSpec command, ProgramHost host)
    {
        string? given = line.Text(RunOptions.Config);
        bool hasUserFile = ConfigFiles.UserFile(host) is { } path && Path.Exists(path);
        if (given is null && !(hasUserFile && command.Options.Any(ConfigKeys.Allows)))
        {
            return line; // by far the most calls: no file is looked at
        }

        return line.With(ConfigRules.Applicable(new ConfigFiles(host).Read(given), line, command)
            .Select(value => KeyValuePair.Create(value.Option.Name, value.ToOptionValue())));
    }

    /// <summary>Prints each key, its value and the source of the value (file and line, or "default"), separated by tabs.</summary>
    /// <param name="given">The user's <c>--config</c>, or null.</param>
    /// <exception cref="BadInputException">As for <see cref="Behind"/>.</exception>
    public static void Show(string? given, ProgramHost host)
    {
        Dictionary<string,
        ConfigValue> values = new ConfigFiles(host).Read(given).ToDictionary(value => value.Option.Key, StringComparer.Ordinal);
        if (given is not null)
        {
            host.Log.Note($"{given}: read (--config).");
        }

        host.Log.Note(ConfigFiles.UserFile(host) is { } path
            ? $"{path}: {(Path.Exists(path) ? "read" : "not there")} (the user's file)."
            : "no folder for the user's file: neither XDG_CONFIG_HOME nor HOME is set.");
        foreach (OptionSpec option in ConfigKeys.Allowed)
        {
            host.Results.WriteLine(values.TryGetValue(option.Key, out ConfigValue? value)
                ? $"{option.Key}\t{value.Text.Replace(PathSpec.Separator, ", ", StringComparison.Ordinal)}\t{value.File}:{value.Line}"
                : $"{option.Key}\t{DefaultOf(option)}\tdefault");
        }
    }

    private static string DefaultOf(OptionSpec option) => option is FlagSpec ? "false" : option.DefaultValue ?? option.DefaultNote ?? "-";
}
