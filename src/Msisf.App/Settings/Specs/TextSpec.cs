using System.Text.RegularExpressions;
using Msisf.Core.Errors;

namespace Msisf.App.Settings.Specs;

/// <summary>An option whose value is a text that this option alone understands.</summary>
/// <inheritdoc/>
internal sealed record TextSpec(string Name, string ValueName, string Help) : OptionSpec(Name, Help)
{
    /// <inheritdoc/>
    public override string ValueName { get; } = ValueName;

    /// <summary>The default; null if there is none.</summary>
    public string? Default { get; init; }

    /// <summary>The values that a shell offers.</summary>
    public IReadOnlyList<string> Words { get; init; } = [];

    /// <summary>Between the values of a list; null if it takes one value.</summary>
    public string? Separator { get; init; }

    /// <summary>The form of the text, and what is needed for messages, e.g. "a size is needed, e.g. 4G"; null for any text.</summary>
    public (Regex Pattern, string Needed)? Form { get; init; }

    /// <inheritdoc/>
    public override IReadOnlyList<string> Suggestions => Words;

    /// <inheritdoc/>
    public override string? ListSeparator => Separator;

    /// <inheritdoc/>
    public override string? DefaultValue => Default;

    /// <summary>The text, or the default, which the option must have.</summary>
    /// <exception cref="BadInputException">Not of the form.</exception>
    public string Read(OptionValues values) => ReadIfGiven(values) ?? Default!;

    /// <summary>The text; null if it is not given.</summary>
    /// <exception cref="BadInputException">Not of the form.</exception>
    public string? ReadIfGiven(OptionValues values)
    {
        string? text = values.Text(this);
        return text is null || Form is not { } form || form.Pattern.IsMatch(text)
            ? text
            : throw new BadInputException($"{Name} is '{text}'; {form.Needed}.").About(this);
    }
}
