using Msisf.Adapters.Input;
using Msisf.App.Host;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings.Config;

/// <summary>Finds and reads the configuration files of a call: the file of <c>--config</c> and the user's file.</summary>
internal sealed class ConfigFiles(ProgramHost host)
{
    /// <summary>
    /// Path of the user's file: $XDG_CONFIG_HOME/msisf/config.yaml, then %APPDATA%\msisf\config.yaml, then ~/.config/msisf/config.yaml;
    /// null if there is no such folder.
    /// </summary>
    public static string? UserFile(ProgramHost host) =>
        host.ConfigFolder is { } folder ? Path.Combine(folder, "config.yaml") : null;

    /// <summary>Reads both files.</summary>
    /// <param name="given">The user's <c>--config</c>, or null.</param>
    /// <returns>One value per key; the given file takes precedence over the user's.</returns>
    /// <exception cref="UsageException">The given path is empty.</exception>
    /// <exception cref="BadInputException">The given file does not exist, or a file has an error.</exception>
    public IReadOnlyCollection<ConfigValue> Read(string? given)
    {
        Dictionary<string, ConfigValue> values = new(StringComparer.Ordinal);
        if (given is not null)
        {
            Add(values, given.Trim().Length > 0 ? given : throw new UsageException("--config is empty; a path is needed."), rank: 1);
        }

        if (UserFile(host) is { } path && Path.Exists(path))
        {
            Add(values, path, rank: 2);
        }

        return values.Values;
    }

    private void Add(Dictionary<string, ConfigValue> values, string path, int rank)
    {
        foreach (ConfigValue value in Values(path, ReadEntries(path), rank))
        {
            values.TryAdd(value.Option.Key, value);
        }
    }

    /// <summary>The options of a file's keys.</summary>
    /// <param name="path">The file; relative paths in it start at its folder.</param>
    /// <param name="rank">See <see cref="ConfigValue"/>.</param>
    /// <param name="isOfRun">Whether all options are those of a run.</param>
    /// <exception cref="BadInputException">A key is not an option, or can't have its value.</exception>
    public IEnumerable<ConfigValue> Values(string path, IEnumerable<ConfigEntry> entries, int rank = 1, bool isOfRun = false)
    {
        foreach (ConfigEntry entry in entries)
        {
            (OptionSpec option, string text) = ConfigKeys.Read(entry, path, isOfRun);
            yield return new ConfigValue(option, option is PathSpec ? PathsFrom(path, text) : text, path, entry.Line, rank);
        }
    }

    private static IReadOnlyList<ConfigEntry> ReadEntries(string path)
    {
        if (!File.Exists(path))
        {
            throw new BadInputException(Directory.Exists(path)
                ? $"{path}: is a folder; a configuration file is needed."
                : $"--config {path}: there is no such file.");
        }

        return FileErrors.ToBadInput($"{path}: the configuration file can't be read", () =>
        {
            using FileStream stream = File.OpenRead(path);
            return ConfigFileReader.Read(stream, path);
        });
    }

    /// <summary>Resolves each of the paths of an option.</summary>
    private string PathsFrom(string file, string paths) =>
        string.Join(PathSpec.Separator, paths.Split(PathSpec.Separator).Select(path => PathFrom(file, path)));

    /// <summary>Resolves a path in a file: "~/" is the user's home folder, and a relative path starts at the file's folder.</summary>
    private string PathFrom(string file, string path)
    {
        if (path.Trim().Length == 0)
        {
            return path; // refused where the option is read
        }

        return path.StartsWith("~/", StringComparison.Ordinal) && host.Environment("HOME") is { } home
            ? Path.Combine(home, path[2..])
            : Path.GetFullPath(path, Path.GetDirectoryName(Path.GetFullPath(file))!);
    }
}

/// <summary>A value from a configuration file, as it would be typed on the command line.</summary>
/// <param name="Text">Value of the option; "true" or "false" for a flag.</param>
/// <param name="File">Path of the file.</param>
/// <param name="Rank">1 for the file of <c>--config</c>, 2 for the user's file; the smaller rank takes precedence.</param>
internal sealed record ConfigValue(OptionSpec Option, string Text, string File, int Line, int Rank)
{
    /// <summary>Converts the value to the form in which options are read.</summary>
    public OptionValue ToOptionValue() => new(
        Option is PathSpec { TakesSeveral: true } ? Text.Split(PathSpec.Separator) : [Text],
        Invariant($"{File}, line {Line}"));
}
