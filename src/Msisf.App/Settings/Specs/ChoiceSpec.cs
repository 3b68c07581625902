using Msisf.Adapters.Input;

namespace Msisf.App.Settings.Specs;

/// <summary>
/// An option whose value is one of a few words, in capitals or small letters. What does not need the values' type is here, because
/// generic code for types of other assemblies is compiled at each start of the program.
/// </summary>
/// <param name="Name">Long name with its dashes.</param>
internal abstract record ChoiceSpec(string Name, OptionRole Role, IReadOnlyList<Choice> Choices, string Help)
    : OptionSpec(Name, Role, Help)
{
    /// <summary>The default, one of the choices' values; null if there is none.</summary>
    public object? Default { get; init; }

    public override string ValueName => string.Join('|', Suggestions);

    public override IReadOnlyList<string> Suggestions => [.. Choices.Select(choice => choice.Word)];

    public override string? DefaultValue => Default is { } value ? TextOf(value) : null;

    public override string Canonical(string text) => ChoiceOf(text)?.Word ?? text;

    public override string TextOf(object value) => Choices.First(choice => choice.Value.Equals(value)).Word;

    /// <summary>Whether two words are the same, in capitals or small letters.</summary>
    public static bool IsSame(string a, string b) => a.Equals(b, StringComparison.OrdinalIgnoreCase);

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

/// <summary>One word of a <see cref="ChoiceSpec"/> with its value.</summary>
/// <param name="word">The word, as the help text shows it.</param>
/// <param name="value">What it stands for.</param>
internal sealed class Choice(string word, object value)
{
    /// <summary>The word, as the help text shows it.</summary>
    public string Word { get; } = word;

    /// <summary>What it stands for.</summary>
    public object Value { get; } = value;
}
