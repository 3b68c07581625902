using System.Text.Json;

namespace Msisf.App.Serving;

/// <summary>Lists in a request that hold what stands in the lines of a file on the command line.</summary>
internal static class RequestRows
{
    /// <summary>The lines: what is in each list, with spaces between.</summary>
    /// <param name="rows">A list of lists of numbers or words.</param>
    /// <param name="key">For messages.</param>
    /// <param name="needed">What is needed, for messages.</param>
    /// <exception cref="UsageException">It is another thing.</exception>
    public static string Text(JsonElement rows, string key, string needed) =>
        rows.ValueKind == JsonValueKind.Array && rows.EnumerateArray().All(row => row.ValueKind == JsonValueKind.Array
            && row.EnumerateArray().All(value => value.ValueKind is JsonValueKind.Number or JsonValueKind.String))
            ? string.Concat(rows.EnumerateArray().Select(row => $"{JsonText.Joined(row, " ", $"'{key}'")}\n"))
            : throw new UsageException($"'{key}' is {JsonText.Shown(rows)}; {needed}, is needed.");
}
