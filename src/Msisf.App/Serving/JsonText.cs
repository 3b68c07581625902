using System.Text.Json;
using System.Text.Unicode;
using Msisf.Adapters.Input;

namespace Msisf.App.Serving;

/// <summary>Reads values of a request's JSON as the text that would be typed on the command line.</summary>
internal static class JsonText
{
    /// <summary>Reads a request.</summary>
    /// <exception cref="UsageException">It is not UTF-8.</exception>
    /// <exception cref="JsonException">It is not JSON.</exception>
    public static JsonElement Parse(byte[] text) => Utf8.IsValid(text)
        ? JsonElement.Parse(text)
        : throw new UsageException("the request is not UTF-8 text, as JSON is.");

    /// <summary>The members of an object by their names.</summary>
    /// <exception cref="UsageException">The value is not an object, or a name is there twice.</exception>
    public static IReadOnlyDictionary<string, JsonElement> Members(JsonElement json)
    {
        if (json.ValueKind != JsonValueKind.Object)
        {
            throw new UsageException("the options of a frame are a JSON object, e.g. {\"fixed-state\": [55289, 1.9e6, 0, 0, 0, 0, 0, 1]}.");
        }

        Dictionary<string, JsonElement> members = new(StringComparer.Ordinal);
        foreach (JsonProperty member in json.EnumerateObject())
        {
            string name = WellFormed(() => member.Name);
            if (!members.TryAdd(name, member.Value))
            {
                throw new UsageException($"{NumberText.Shown(name)} is given twice. Give it once.");
            }
        }

        return members;
    }

    /// <summary>A text or a number as text.</summary>
    /// <param name="name">What it is, for the message.</param>
    /// <exception cref="UsageException">It is neither.</exception>
    public static string Of(JsonElement value, string name) => value.ValueKind switch
    {
        JsonValueKind.String => WellFormed(() => value.GetString()!),
        JsonValueKind.Number => value.GetRawText(),
        _ => throw new UsageException($"{name} is {Shown(value)}; a text or a number is needed."),
    };

    /// <exception cref="UsageException">An element is neither text nor number.</exception>
    public static string Joined(JsonElement array, string separator, string name) =>
        string.Join(separator, array.EnumerateArray().Select(value => Of(value, name)));

    /// <summary>A message with each text of a request cut short that is too long for it.</summary>
    /// <param name="longest">Characters of a text that are repeated at most.</param>
    public static string WithoutLongTexts(string message, JsonElement json, int longest) => json.ValueKind switch
    {
        JsonValueKind.Object => json.EnumerateObject().Aggregate(
            message, (text, member) => WithoutLongTexts(text, member.Value, longest)),
        JsonValueKind.Array => json.EnumerateArray().Aggregate(message, (text, element) => WithoutLongTexts(text, element, longest)),
        JsonValueKind.String when json.GetRawText().Length > longest && WellFormed(() => json.GetString()!).Trim() is var value
            && value.Length > longest => message.Replace(value, $"{value.AsSpan(0, longest - 3)}...", StringComparison.Ordinal),
        _ => message,
    };

    /// <summary>The kind of a value in words.</summary>
    public static string Shown(JsonElement value) => value.ValueKind switch
    {
        JsonValueKind.Object => "an object",
        JsonValueKind.Array => "a list",
        JsonValueKind.String => "a text",
        JsonValueKind.Number => "a number",
        JsonValueKind.Null => "null",
        _ => value.GetRawText(),
    };

    private static string WellFormed(Func<string> read)
    {
        try
        {
            return read();
        }
        catch (InvalidOperationException exception)
        {
            throw new UsageException("the JSON text holds one half of a surrogate pair.", exception);
        }
    }
}
