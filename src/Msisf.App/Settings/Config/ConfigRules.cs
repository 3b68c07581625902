using Msisf.App.Settings.Specs;
using Msisf.Core.Render;

namespace Msisf.App.Settings.Config;

/// <summary>
/// Leaves out what a file says and a call can't use: settings for every call meet calls of all kinds. What stands on the command line is
/// never touched; it is an error where it has no meaning.
/// </summary>
internal sealed class ConfigRules
{
    private const int RankOfCommandLine = 0;

    private readonly OptionValues _line;
    private readonly Dictionary<string, ConfigValue> _values;

    private ConfigRules(Dictionary<string, ConfigValue> values, OptionValues line) => (_values, _line) = (values, line);

    /// <summary>The values that apply.</summary>
    /// <param name="values">From the files.</param>
    /// <param name="line">The command line.</param>
    /// <param name="command">Its command.</param>
    public static IReadOnlyCollection<ConfigValue> Applicable(IEnumerable<ConfigValue> values, OptionValues line, CommandSpec command)
    {
        Dictionary<string, OptionSpec> options = command.Options.ToDictionary(option => option.Name, StringComparer.Ordinal);
        ConfigRules rules = new(
            values.Where(
                value => options.TryGetValue(value.Option.Name, out OptionSpec? option) && !line.IsGiven(option)).ToDictionary(value =>
                    value.Option.Name, StringComparer.Ordinal),
            line);
        if (options.ContainsKey(RendererOptions.Renderer.Name))
        {
            RendererKind renderer = rules.Effective(RendererOptions.Renderer) == RendererOptions.Renderer.WordOf(RendererKind.Native)
                ? RendererKind.Native
                : RendererKind.PovRay;
            rules.LeaveOut([.. RendererOptions.WithoutMeaning(renderer)]);
        }

        rules.KeepOneOf(SurfaceOptions.LevelOfDetail, SurfaceOptions.LevelOfDetail.WordOf(true), SurfaceOptions.LevelOfDetailError);
        rules.KeepOneOf(LightOptions.IgnoreSun, "true", LightOptions.Aberration);
        string database = PatternsOptions.Source.WordOf(true);
        rules.KeepOneOf(PatternsOptions.Source, database, SurfaceOptions.Ldem);
        if (rules.Effective(PatternsOptions.Source) != database)
        {
            rules.LeaveOut(PatternsOptions.DefaultsFile);
        }

        if (rules.Effective(NativeOptions.Reflectance) is { } law && law.StartsWith("hapke:", StringComparison.Ordinal)
            && law.Contains("w=", StringComparison.Ordinal))
        {
            rules.LeaveOut(NativeOptions.Albedo);
        }

        return rules._values.Values;
    }

    private void LeaveOut(params OptionSpec[] options)
    {
        foreach (OptionSpec option in options)
        {
            _values.Remove(option.Name);
        }
    }

    /// <summary>
    /// Of two options that exclude each other if the first has a certain value, leaves out the one with the lower rank; the second if both
    /// stand together.
    /// </summary>
    private void KeepOneOf(OptionSpec first, string firstValue, OptionSpec second)
    {
        if (Effective(first) == firstValue && Effective(second) is not null)
        {
            LeaveOut(RankOf(first) > RankOf(second) ? first : second);
        }
    }

    /// <summary>Null if nobody gives it, or a file says that a flag is not set.</summary>
    private string? Effective(OptionSpec option) => _line.Text(option) switch
    {
        "" => "true",
        string text => text,
        null => _values.GetValueOrDefault(option.Name)?.Text is { } text && text != "false" ? text : null,
    };

    private int RankOf(OptionSpec option) => _values.TryGetValue(option.Name, out ConfigValue? value) ? value.Rank : RankOfCommandLine;
}
