using System.Text.RegularExpressions;

namespace Msisf.App.Cluster;

/// <summary>
/// The script templates in the folder Templates; @NAME@ in them is replaced by a value that is already quoted for its place.
/// </summary>
internal static partial class ScriptTemplate
{
    /// <summary>Fills a template in.</summary>
    /// <param name="name">File name of the template.</param>
    /// <param name="values">A value for each name in the template.</param>
    public static string Fill(string name, IReadOnlyDictionary<string, string> values)
    {
        using Stream stream = typeof(ScriptTemplate).Assembly.GetManifestResourceStream($"Templates/{name}")
            ?? throw new ArgumentException($"there is no template {name}.", nameof(name));
        using StreamReader reader = new(stream);
        return Placeholder().Replace(reader.ReadToEnd(), match => values[match.Groups["name"].Value]);
    }

    [GeneratedRegex("@(?<name>[A-Z_]+)@")]
    private static partial Regex Placeholder();
}
