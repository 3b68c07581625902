using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>Files or folders under the names by which clients ask for them, so that no path of a request reaches the file system.</summary>
internal static class NamedPaths
{
    /// <summary>Reads a list such as "flight=runs/flight,craters.csv"; without a name the last part of the path is the name.</summary>
    /// <param name="option">The option that holds it.</param>
    /// <param name="values">The options of a call.</param>
    /// <exception cref="UsageException">A path is empty, or two have one name.</exception>
    public static IReadOnlyDictionary<string, string> Read(TextSpec option, OptionValues values)
    {
        Dictionary<string, string> paths = new(StringComparer.Ordinal);
        foreach (string entry in option.ReadIfGiven(values)?.Split(option.Separator!, StringSplitOptions.TrimEntries) ?? [])
        {
            string[] parts = entry.Split('=', 2);
            string path = Path.GetFullPath(parts[^1].Length > 0 ? parts[^1] : throw Wrong("is a path"));
            string name = parts.Length == 2 ? parts[0] : Path.GetFileName(Path.TrimEndingDirectorySeparator(path));
            if (name.Length == 0 || name.Contains('/', StringComparison.Ordinal) || !paths.TryAdd(name, path))
            {
                throw Wrong($"has a name of its own without '/', but '{name}' is none");
            }

            UsageException Wrong(string needed) =>
                new UsageException($"{option.Name} {entry}: each part {needed}. Write NAME=PATH, separated by commas.").About(option);
        }

        return paths;
    }
}
