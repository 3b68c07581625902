namespace Msisf.App.Settings.Specs;

/// <summary>The options of one call as text, from the command line and the configuration files. Immutable.</summary>
/// <param name="values">Values by long name.</param>
/// <param name="argument">The positional argument, e.g. the folder of msis status; null if there is none.</param>
/// <param name="arguments">The words of the positional argument; null for one word.</param>
internal sealed class OptionValues(
    IEnumerable<KeyValuePair<string, OptionValue>> values, string? argument = null, IReadOnlyList<string>? arguments = null)
{
    private readonly Dictionary<string, OptionValue> _values = new(values, StringComparer.Ordinal);

    public string? Argument { get; } = argument;

    /// <summary>The words of the positional argument.</summary>
    public IReadOnlyList<string> Arguments { get; } = arguments ?? (argument is null ? [] : [argument]);

    /// <summary>Whether the option is given on the command line.</summary>
    public bool IsGiven(OptionSpec option) => _values.TryGetValue(option.Name, out OptionValue? value) && value.Place is null;

    /// <summary>Whether a look has set some of them.</summary>
    public bool HasLook => _values.Values.Any(value => value.Look is not null);

    /// <summary>Position of the option in a configuration file; null if it is not set, or on the command line.</summary>
    public string? PlaceOf(OptionSpec option) => _values.GetValueOrDefault(option.Name)?.Place;

    /// <summary>The words of the option's value; null if the option is neither given nor in a configuration file.</summary>
    public IReadOnlyList<string>? Words(OptionSpec option) => _values.GetValueOrDefault(option.Name)?.Words;

    /// <summary>The option's value as one text, which is empty for a flag on the command line; null if the option is not set.</summary>
    public string? Text(OptionSpec option) => Words(option) is { } words ? string.Join(' ', words) : null;

    /// <summary>Returns these options together with others that are not among them.</summary>
    public OptionValues With(IEnumerable<KeyValuePair<string, OptionValue>> more) => new([.. _values, .. more], Argument, Arguments);

    /// <summary>Returns these options with others in place of some.</summary>
    /// <param name="replaced">The options that are left out.</param>
    /// <param name="others">What is there in their place.</param>
    public OptionValues Replacing(IEnumerable<OptionSpec> replaced, IEnumerable<KeyValuePair<string, OptionValue>> others) =>
        new([.. _values.ExceptBy(replaced.Select(option => option.Name), pair => pair.Key), .. others], Argument, Arguments);

    /// <summary>
    /// The exit code of an exception: a wrong option is a wrong content of a file if all options that it is about were set in files.
    /// </summary>
    public int ExitCodeOf(MsisfException failure)
    {
        OptionValue[] affected = [.. failure.Options.Select(name => _values.GetValueOrDefault(name)).OfType<OptionValue>()];
        return failure is UsageException && affected.Length > 0 && Array.TrueForAll(affected, value => value.Place is not null)
            ? new BadInputException(failure.Message).ExitCode
            : failure.ExitCode;
    }

    /// <summary>The message of an exception, with the source of the first affected option that the command line does not have.</summary>
    public string MessageOf(MsisfException failure)
    {
        string? option = failure.Options.FirstOrDefault(name => _values.GetValueOrDefault(name)?.Source is not null);
        return option is null ? failure.Message : $"{failure.Message} {option} comes from {_values[option].Source}.";
    }
}

/// <summary>The value of one option as text.</summary>
/// <param name="Words">
/// Words of the value as on the command line; empty for a flag, which is "true" or "false" in a configuration file.
/// </param>
/// <param name="Place">Position in a configuration file, e.g. "a.yaml, line 3"; null for the command line.</param>
internal sealed record OptionValue(IReadOnlyList<string> Words, string? Place = null)
{
    /// <summary>The look that has the value, e.g. "--look photo"; null for a value of its own.</summary>
    public string? Look { get; init; }

    /// <summary>Where the value comes from; null for the command line.</summary>
    public string? Source => Look is null ? Place : Place is null ? Look : $"{Look} ({Place})";
}
