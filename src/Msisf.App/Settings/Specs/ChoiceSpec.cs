using Msisf.Core.Errors;

namespace Msisf.App.Settings.Specs;

/// <summary>An option whose value is one of a few words.</summary>
/// <param name="Name">Long name with its dashes.</param>
/// <param name="Choices">Each word with its value.</param>
/// <param name="Help">See <see cref="OptionSpec"/>.</param>
/// <typeparam name="T">Type of the values.</typeparam>
internal sealed record ChoiceSpec<T>(string Name, IReadOnlyList<(string Word, T Value)> Choices, string Help) : OptionSpec(Name, Help)
    where T : struct
{
    /// <summary>The default; null if there is none.</summary>
    public T? Default { get; init; }

    /// <inheritdoc/>
    public override string ValueName => string.Join('|', Suggestions);

    /// <inheritdoc/>
    public override IReadOnlyList<string> Suggestions => [.. Choices.Select(choice => choice.Word)];

    /// <inheritdoc/>
    public override string? DefaultValue => Default is { } value ? WordOf(value) : null;

    /// <summary>The word for a value.</summary>
    public string WordOf(T value) => Choices.First(choice => EqualityComparer<T>.Default.Equals(choice.Value, value)).Word;

    /// <summary>The command-line words that set the option to a value.</summary>
    public string[] Words(T value) => [Name, WordOf(value)];

    /// <summary>Reads the value of the given word, or the default, which must exist unless the option is required.</summary>
    /// <exception cref="BadInputException">The word is none of the choices.</exception>
    public T Read(OptionValues values)
    {
        if (values.Text(this) is not string text)
        {
            return Default!.Value;
        }

        foreach ((string word, T value) in Choices)
        {
            if (word == text)
            {
                return value;
            }
        }

        throw new BadInputException($"{Name} is '{text}'; one of {string.Join(", ", Suggestions)} is needed.").About(this);
    }
}
