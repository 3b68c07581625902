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

    /// <exception cref="UsageException">The word is none of the choices; the message names the nearest one.</exception>
    protected Choice? GivenChoice(OptionValues values) =>
        values.Text(this) is string text ? ChoiceOf(text) ?? throw Wrong(text) : null;

    private UsageException Wrong(string text) => new UsageException(
        $"{Name} is '{text}'; one of {string.Join(", ", Suggestions)} is needed{NearestName.Question(text, Suggestions, ".")}").About(this);

    private Choice? ChoiceOf(string text) => Choices.FirstOrDefault(choice => IsSame(choice.Word, text));
}

/// <summary>One word of a <see cref="ChoiceSpec"/> with its value.</summary>
/// <param name="word">The word, as the help text shows it.</param>
/// <param name="value">What it stands for.</param>
internal sealed class Choice(string word, object value)
{
    /// <summary>The word, as the help text shows it.</summary>
    public string Word { get; } = word;

    public object Value { get; } = value;
}

/// <summary>An option whose value is one of a few words, each of which stands for a value of one type.</summary>
/// <typeparam name="T">Type of the values.</typeparam>
internal sealed record ChoiceSpec<T> : ChoiceSpec
    where T : struct
{
    /// <param name="name">Long name with its dashes.</param>
    /// <param name="role">What the option decides.</param>
    /// <param name="choices">Each word with its value.</param>
    /// <param name="help">See <see cref="OptionSpec"/>.</param>
    public ChoiceSpec(string name, OptionRole role, IReadOnlyList<Choice> choices, string help)
        : base(name, role, choices, help)
    {
    }

    /// <summary>Declares the option by pairs.</summary>
    /// <inheritdoc cref="ChoiceSpec{T}(string, OptionRole, IReadOnlyList{Choice}, string)"/>
    public ChoiceSpec(string name, OptionRole role, (string Word, T Value)[] choices, string help)
        : base(name, role, ChoicesOf(choices), help)
    {
    }

    public string WordOf(T value) => TextOf(value);

    /// <summary>Reads the value of the given word, or the default, which must exist unless the option is required.</summary>
    /// <exception cref="UsageException">The word is none of the choices.</exception>
    public T Read(OptionValues values) => (T)(GivenChoice(values)?.Value ?? Default!);

    /// <summary>Reads the value of the given word; null if the option is not given.</summary>
    /// <exception cref="UsageException">The word is none of the choices.</exception>
    public T? ReadIfGiven(OptionValues values) => (T?)GivenChoice(values)?.Value;

    /// <summary>The pairs as choices, by indices: enumerators of pairs would be compiled at each start, for each T.</summary>
    private static Choice[] ChoicesOf((string Word, T Value)[] pairs)
    {
        Choice[] choices = new Choice[pairs.Length];
        for (int i = 0; i < pairs.Length; i++)
        {
            choices[i] = new Choice(pairs[i].Word, pairs[i].Value);
        }

        return choices;
    }
}
