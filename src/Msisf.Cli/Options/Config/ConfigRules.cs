using System.CommandLine;
using Msisf.Core.Render;

namespace Msisf.Cli.Options.Config;

/// <summary>
/// Leaves out what a file says and a call can't use: settings for every call meet calls of all kinds. What stands on the command line is
/// never touched; it is an error where it has no meaning.
/// </summary>
internal sealed class ConfigRules
{
    private const int RankOfCommandLine = 0;

    private readonly Func<string, string?> _onLine;
    private readonly Dictionary<string, ConfigValue> _values;

    private ConfigRules(Dictionary<string, ConfigValue> values, Func<string, string?> onLine) => (_values, _onLine) = (values, onLine);

    /// <summary>The values that apply.</summary>
    /// <param name="values">From the files, for options that the command has.</param>
    /// <param name="onLine">Text of an option on the command line by its key; empty of a flag, null if it is not given.</param>
    /// <param name="draws">Whether the command draws images, and so has a renderer.</param>
    public static IReadOnlyDictionary<string, ConfigValue> Applicable(
        IReadOnlyDictionary<string, ConfigValue> values, Func<string, string?> onLine, bool draws)
    {
        ConfigRules rules = new(
            new Dictionary<string, ConfigValue>(values.Where(pair => onLine(pair.Key) is null), StringComparer.Ordinal), onLine);
        if (draws)
        {
            rules.LeaveOutOtherRenderer();
        }

        rules.KeepOneOf("lod", "off", "lod-error");
        rules.KeepOneOf("ignore-sun", "true", "aberration");
        rules.KeepOneOf("source", "mysql", "ldem");
        if (rules.Effective("source") != "mysql")
        {
            rules._values.Remove("defaults-file");
        }

        if (rules.Effective("reflectance") is { } law && law.StartsWith("hapke:", StringComparison.Ordinal)
            && law.Contains("w=", StringComparison.Ordinal))
        {
            rules._values.Remove("albedo");
        }

        return rules._values;
    }

    private void LeaveOutOtherRenderer()
    {
        RendererKind renderer = Effective("renderer") == "native" ? RendererKind.Native : RendererKind.PovRay;
        foreach (Option option in RendererRules.WithoutMeaning(renderer, new NativeOptions(), new SourceOptions(), new RunOptions()))
        {
            _values.Remove(ConfigKeys.KeyOf(option));
        }
    }

    /// <summary>
    /// Of two that exclude each other, where the first has a certain value, leaves out what comes from farther away; the second if both
    /// stand together.
    /// </summary>
    private void KeepOneOf(string first, string firstValue, string second)
    {
        if (Effective(first) == firstValue && Effective(second) is not null)
        {
            _values.Remove(RankOf(first) > RankOf(second) ? first : second);
        }
    }

    /// <summary>Null if nobody gives it, or a file says that a flag is not set.</summary>
    private string? Effective(string key) => _onLine(key) switch
    {
        "" => "true",
        string text => text,
        null => _values.GetValueOrDefault(key)?.Text is { } text && text != "false" ? text : null,
    };

    private int RankOf(string key) => _values.TryGetValue(key, out ConfigValue? value) ? value.Rank : RankOfCommandLine;
}
