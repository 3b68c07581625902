namespace Msisf.App.Settings.Specs;

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
