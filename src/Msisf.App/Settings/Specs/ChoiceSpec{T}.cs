namespace Msisf.App.Settings.Specs;

/// <summary>An option whose value is one of a few words, each of which stands for a value of one type.</summary>
/// <typeparam name="T">Type of the values.</typeparam>
internal sealed record ChoiceSpec<T> : ChoiceSpec
    where T : struct
{
    /// <summary>Declares the option.</summary>
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
