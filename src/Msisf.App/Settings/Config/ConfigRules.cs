using Msisf.App.Settings.Specs;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;

namespace Msisf.App.Settings.Config;

/// <summary>
/// Removes values of configuration files that a call can't use, because the files hold settings for all kinds of calls. Options on the
/// command line are never removed; it is an error if they can't be used.
/// </summary>
internal sealed class ConfigRules
{
    private const int RankOfCommandLine = 0;

    private readonly OptionValues _line;
    private readonly Dictionary<string, ConfigValue> _values;

    private ConfigRules(Dictionary<string, ConfigValue> values, OptionValues line) => (_values, _line) = (values, line);

    /// <summary>Selects the values that apply to a call.</summary>
    /// <param name="values">Values from the configuration files.</param>
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
            string? renderer = rules.Effective(RendererOptions.Renderer) ?? LookOptions.RendererOf(rules.Effective(LookOptions.Look));
            rules.LeaveOut([.. RendererOptions.WithoutMeaning(
                renderer == RendererOptions.Renderer.WordOf(RendererKind.Native) ? RendererKind.Native : RendererKind.PovRay)]);
        }

        rules.KeepOneOf(SurfaceOptions.LevelOfDetail, SurfaceOptions.LevelOfDetail.WordOf(true), SurfaceOptions.LevelOfDetailError);
        rules.KeepOneOf(LightOptions.IgnoreSun, "true", LightOptions.Aberration);
        string database = PatternsOptions.Source.WordOf(true);
        rules.KeepOneOf(PatternsOptions.Source, database, SurfaceOptions.Ldem);
        if (rules.Effective(PatternsOptions.Source) != database)
        {
            rules.LeaveOut(PatternsOptions.DefaultsFile);
        }

        if (ReflectanceText.IsAbsolute(rules.Effective(NativeOptions.Reflectance) ?? ReflectanceFactory.DefaultLaw))
        {
            rules.LeaveOut(NativeOptions.Albedo);
        }

        if (rules.Effective(AlbedoOptions.Map) is { } map && Path.GetFileName(map) != AlbedoOptions.NoMap)
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
    /// Removes one of two options that exclude each other if the first has a certain value: the one with the lower precedence, or the
    /// second if their precedence is equal.
    /// </summary>
    private void KeepOneOf(OptionSpec first, string firstValue, OptionSpec second)
    {
        if (Effective(first) == firstValue && Effective(second) is not null)
        {
            LeaveOut(RankOf(first) > RankOf(second) ? first : second);
        }
    }

    /// <summary>The value that applies; null if the option is not given, or a file sets a flag to false.</summary>
    private string? Effective(OptionSpec option) => _line.Text(option) switch
    {
        "" => "true",
        string text => option.Canonical(text),
        null => _values.GetValueOrDefault(option.Name)?.Text is { } text && text != "false" ? option.Canonical(text) : null,
    };

    private int RankOf(OptionSpec option) => _values.TryGetValue(option.Name, out ConfigValue? value) ? value.Rank : RankOfCommandLine;
}
