using System.Text;
using System.Text.Json;

namespace Msisf.Adapters.Manifest;

/// <summary>Says in words how the settings of a finished frame differ from those of a run.</summary>
public static class SettingsDifference
{
    /// <summary>Digits of a checksum that a message shows: enough to tell two apart.</summary>
    private const int ShownDigits = 12;

    private const string Renderer = "--renderer";

    /// <summary>A sentence's end, e.g. "made with --fov 60, now 30".</summary>
    /// <param name="made">Settings of the finished frame; null if the manifest does not have them.</param>
    /// <param name="wanted">Settings of the run; null if the manifest does not have them.</param>
    public static string Reason(SettingsRecord? made, SettingsRecord? wanted)
    {
        if (made is null || wanted is null)
        {
            return "made with other settings, or from another state";
        }

        return made.Key == wanted.Key
            ? "made for another time, position, orientation, motion or noise"
            : $"made with {string.Join("; ", Between(made, wanted).DefaultIfEmpty("other settings"))}";
    }

    private static IEnumerable<string> Between(SettingsRecord made, SettingsRecord wanted)
    {
        using JsonDocument old = JsonDocument.Parse(made.Description);
        using JsonDocument now = JsonDocument.Parse(wanted.Description);
        return
        [
            .. Changed("msis ", Text(old, "version"), Text(now, "version")),
            .. Arguments(Text(old, "arguments"), Text(now, "arguments")),
            .. Model(old, now),
            .. Changed("ephemeris ", Text(old, "ephemeris"), Text(now, "ephemeris")),
            .. Kernels(old).Length == 0 || Kernels(now).Length == 0 ? [] : Files(Kernels(old), Kernels(now)), // or the line above says it
            .. Changed("POV-Ray ", Text(old, "povray"), Text(now, "povray")),
        ];
    }

    private static IEnumerable<string> Changed(string what, string? old, string? now)
    {
        if (old != now)
        {
            yield return old is null ? $"no {what.Trim()}, now {now}" : $"{what}{old}, now {now ?? "none"}";
        }
    }

    /// <summary>The options that differ. Those that only one renderer has are left out if the renderer differs.</summary>
    private static IEnumerable<string> Arguments(string? old, string? now)
    {
        Dictionary<string, string> before = Options(old ?? string.Empty);
        Dictionary<string, string> after = Options(now ?? string.Empty);
        foreach ((string name, string value) in before.Where(option => after.GetValueOrDefault(option.Key, option.Value) != option.Value))
        {
            yield return $"{name} {value}, now {after[name]}";
        }

        if (before.GetValueOrDefault(Renderer) != after.GetValueOrDefault(Renderer))
        {
            yield break;
        }

        foreach ((string name, string value) in before.Where(option => !after.ContainsKey(option.Key)))
        {
            yield return $"{name} {value}".TrimEnd() + ", now without it";
        }

        foreach ((string name, string value) in after.Where(option => !before.ContainsKey(option.Key)))
        {
            yield return $"no {name}, now {(value.Length > 0 ? value : "with it")}";
        }
    }

    /// <summary>Options and their values; a flag has an empty one. A value in quotes may have spaces and dashes.</summary>
    private static Dictionary<string, string> Options(string arguments)
    {
        Dictionary<string, string> options = [];
        string? name = null;
        foreach (string word in Words(arguments))
        {
            if (word.StartsWith("--", StringComparison.Ordinal))
            {
                name = word;
                options[name] = string.Empty;
            }
            else if (name is not null)
            {
                options[name] = options[name].Length > 0 ? $"{options[name]} {word}" : word;
            }
        }

        return options;
    }

    private static IEnumerable<string> Words(string arguments)
    {
        StringBuilder word = new();
        bool isQuoted = false;
        foreach (char character in arguments)
        {
            isQuoted ^= character == '\'';
            if (character == ' ' && !isQuoted)
            {
                yield return word.ToString();
                word.Clear();
            }
            else
            {
                word.Append(character);
            }
        }

        yield return word.ToString();
    }

    private static IEnumerable<string> Model(JsonDocument old, JsonDocument now)
    {
        (string? Product, string? Hash) before = ModelOf(old);
        (string? Product, string? Hash) after = ModelOf(now);
        return before.Product == after.Product
            ? Files([(before.Product ?? "model", before.Hash)], [(after.Product ?? "model", after.Hash)])
            : Changed("elevation model ", before.Product, after.Product);
    }

    private static IEnumerable<string> Files(IReadOnlyList<(string Name, string? Hash)> old, IReadOnlyList<(string Name, string? Hash)> now)
    {
        foreach ((string name, string? hash) in old.Except(now))
        {
            (string Name, string? Hash)[] same = [.. now.Where(file => file.Name == name)];
            yield return same.Length > 0
                ? $"another {name} (checksum {Short(hash)}, now {Short(same[0].Hash)})"
                : $"{name}, now without it";
        }

        foreach ((string name, _) in now.Where(file => old.All(other => other.Name != file.Name)))
        {
            yield return $"no {name}, now with it";
        }
    }

    private static string Short(string? hash) => hash is null ? "unknown" : $"{hash[..Math.Min(ShownDigits, hash.Length)]}...";

    private static (string? Product, string? Hash) ModelOf(JsonDocument description) =>
        Member(description.RootElement, "model") is { ValueKind: JsonValueKind.Object } model
            ? (TextOf(Member(model, "product")), TextOf(Member(model, "sha256_of_parts")))
            : (null, null);

    private static (string Name, string? Hash)[] Kernels(JsonDocument description) =>
        Member(description.RootElement, "kernels") is { ValueKind: JsonValueKind.Array } kernels
            ? [.. kernels.EnumerateArray().Select(kernel => (TextOf(Member(kernel, "name")) ?? "kernel", TextOf(Member(kernel, "sha256"))))]
            : [];

    private static string? Text(JsonDocument description, string name) => TextOf(Member(description.RootElement, name));

    private static JsonElement? Member(JsonElement parent, string name) =>
        parent.ValueKind == JsonValueKind.Object && parent.TryGetProperty(name, out JsonElement member) ? member : null;

    private static string? TextOf(JsonElement? element) =>
        element is { ValueKind: JsonValueKind.String } text ? text.GetString() : null;
}
