using Msisf.Core.Errors;

namespace Msisf.App.Settings.Specs;

/// <summary>
/// The options of one call as text: those of the command line, and behind them those of the configuration files. Immutable.
/// </summary>
internal sealed class OptionValues
{
    private readonly Dictionary<string, OptionValue> _values;

    /// <summary>Takes the options.</summary>
    /// <param name="values">By long name.</param>
    /// <param name="argument">The argument that is no option, e.g. the folder of msis status; null if there is none.</param>
    public OptionValues(IEnumerable<KeyValuePair<string, OptionValue>> values, string? argument = null)
    {
        _values = new Dictionary<string, OptionValue>(values, StringComparer.Ordinal);
        Argument = argument;
    }

    /// <summary>The argument that is no option; null if there is none.</summary>
    public string? Argument { get; }

    /// <summary>Whether the command line has the option.</summary>
    public bool IsGiven(OptionSpec option) => _values.TryGetValue(option.Name, out OptionValue? value) && value.Place is null;

    /// <summary>The words of the option; null if it is neither given nor in a configuration file.</summary>
    public IReadOnlyList<string>? Words(OptionSpec option) => _values.GetValueOrDefault(option.Name)?.Words;

    /// <summary>The same as one text, empty for a flag on the command line.</summary>
    public string? Text(OptionSpec option) => Words(option) is { } words ? string.Join(' ', words) : null;

    /// <summary>These and more, for options that are not among these.</summary>
    public OptionValues With(IEnumerable<KeyValuePair<string, OptionValue>> more) => new([.. _values, .. more], Argument);

    /// <summary>A failure's message, with the place of the first setting in a configuration file that it is about.</summary>
    public string MessageOf(MsisfException failure)
    {
        string? option = failure.Options.FirstOrDefault(name => _values.GetValueOrDefault(name)?.Place is not null);
        return option is null ? failure.Message : $"{failure.Message} {option} comes from {_values[option].Place}.";
    }
}
