using Msisf.Adapters.Input;
using Msisf.Core.Errors;

namespace Msisf.App.Settings.Specs;

/// <summary>
/// An option whose value is one of a few words, in capitals or small letters. What does not need the values' type is here, because
/// generic code for types of other assemblies is compiled at each start of the program.
/// </summary>
/// <param name="Name">Long name with its dashes.</param>
/// <param name="Choices">Each word with its value.</param>
/// <param name="Help">See <see cref="OptionSpec"/>.</param>
internal abstract record ChoiceSpec(string Name, IReadOnlyList<Choice> Choices, string Help) : OptionSpec(Name, Help)
{
    /// <summary>The default, one of the choices' values; null if there is none.</summary>
    public object? Default { get; init; }

    /// <inheritdoc/>
    public override string ValueName => string.Join('|', Suggestions);

    /// <inheritdoc/>
    public override IReadOnlyList<string> Suggestions => [.. Choices.Select(choice => choice.Word)];

    /// <inheritdoc/>
    public override string? DefaultValue => Default is { } value ? ChoiceOf(value).Word : null;

    /// <inheritdoc/>
    public override string Canonical(string text) => ChoiceOf(text)?.Word ?? text;

    /// <summary>Whether two words are the same, in capitals or small letters.</summary>
    public static bool IsSame(string a, string b) => a.Equals(b, StringComparison.OrdinalIgnoreCase);

    /// <summary>The choice with a value.</summary>
    protected Choice ChoiceOf(object value) => Choices.First(choice => choice.Value.Equals(value));

    /// <summary>The choice that is given; null if the option is not.</summary>
    /// <exception cref="UsageException">The word is none of the choices; the message names the nearest one.</exception>
    protected Choice? GivenChoice(OptionValues values) =>
        values.Text(this) is string text ? ChoiceOf(text) ?? throw Wrong(text) : null;

    private UsageException Wrong(string text)
    {
        string question = NearestName.Question(text, Suggestions);
        return new UsageException(
            $"{Name} is '{text}'; one of {string.Join(", ", Suggestions)} is needed{(question.Length > 0 ? question : ".")}").About(this);
    }

    private Choice? ChoiceOf(string text) => Choices.FirstOrDefault(choice => IsSame(choice.Word, text));
}
