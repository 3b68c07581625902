using System.Text.Json;

namespace Msisf.MySql.Tests;

/// <summary>The table of option files that the PHP tests read too.</summary>
internal static class OptionFileCases
{
    private static readonly JsonElement Table = JsonDocument.Parse(
        File.ReadAllText(Path.Combine(AppContext.BaseDirectory, "option_files.json"))).RootElement;

    public static IEnumerable<string> DefaultSockets =>
        Table.GetProperty("defaultSockets").EnumerateArray().Select(item => item.GetString()!);

    /// <summary>Names of the cases that are connections, or of those that are refused.</summary>
    public static IEnumerable<string> Names(bool areRefused) =>
        Table.GetProperty("cases").EnumerateArray().Where(
            item => item.TryGetProperty("refused", out _) == areRefused).Select(item => item.GetProperty("name").GetString()!);

    public static JsonElement Of(string name) =>
        Table.GetProperty("cases").EnumerateArray().Single(item => item.GetProperty("name").GetString() == name);

    /// <summary>What the settings of a case have to be; the first case has the values of all others that they leave out.</summary>
    public static IReadOnlyDictionary<string, string> Expected(string name)
    {
        Dictionary<string, string> values = [];
        foreach (JsonProperty property in Table.GetProperty("cases")[0].GetProperty("expected").EnumerateObject().Concat(
            Of(name).GetProperty("expected").EnumerateObject()))
        {
            values[property.Name] = property.Value.ToString();
        }

        return values;
    }
}
