using System.Text.RegularExpressions;
using Msisf.Adapters.Input;
using Msisf.Core.Time;

namespace Msisf.App.Settings.Specs;

/// <summary>An option whose value is a text with a syntax of its own.</summary>
/// <inheritdoc/>
internal sealed record TextSpec(string Name, OptionRole Role, string ValueName, string Help) : OptionSpec(Name, Role, Help)
{
    public override string ValueName { get; } = ValueName;

    public string? Default { get; init; }

    /// <summary>The value if the option is given without one; null if it needs one.</summary>
    public string? ValueIfBare { get; init; }

    /// <summary>Values that shell completion offers.</summary>
    public IReadOnlyList<string> Words { get; init; } = [];

    /// <summary>Separator of the values of a list; null if the option takes one value.</summary>
    public string? Separator { get; init; }

    /// <summary>
    /// The required pattern of the text and a description for messages, e.g. "a size is needed, e.g. 4G"; null for any text.
    /// </summary>
    public (Regex Pattern, string Needed)? Form { get; init; }

    public override IReadOnlyList<string> Suggestions => Words;

    public override string? ListSeparator => Separator;

    public override string? DefaultValue => Default;

    /// <summary>Reads the text, or the default, which must exist.</summary>
    /// <exception cref="UsageException">The text does not match the required pattern.</exception>
    public string Read(OptionValues values) => ReadIfGiven(values) ?? Default!;

    /// <summary>Reads the text; null if the option is not given.</summary>
    /// <exception cref="UsageException">The text does not match the required pattern.</exception>
    public string? ReadIfGiven(OptionValues values)
    {
        string? text = values.Text(this) is { } given ? ValueIfBare is { } bare && given.Length == 0 ? bare : given : null;
        return text is null || Form is not { } form || form.Pattern.IsMatch(text)
            ? text
            : throw new UsageException($"{Name} is '{text}'; {form.Needed}.").About(this);
    }
}

/// <summary>An option whose value is a time: an MJD (UTC), or ISO 8601.</summary>
/// <inheritdoc/>
internal sealed record TimeSpec(string Name, OptionRole Role, string Help) : OptionSpec(Name, Role, Help)
{
    public override string ValueName => "TIME";

    /// <summary>Reads the time, which must be given.</summary>
    /// <exception cref="BadInputException">The value is not a time.</exception>
    public CalendarTime Read(OptionValues values) => this.Named(() => TimeText.Parse(values.Text(this)!));
}
